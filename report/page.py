"""One HTML file with everything in it: no network is needed to read it."""
import html
import json
import os
import time

import numpy as np

import charts
import rainflow

HERE = os.path.dirname(os.path.abspath(__file__))
MOST_FRAMES = 300  # of the slider
NOT_TOLD = 0.8  # of the standard deviation that was configured: what is left of it where measurements say nothing
UNITS = {"tether.mass_per_length": "kg/m", "tether.length": "m", "environment.current": "m/s", "vehicle.force": "N", "tension.bias": "N"}


def own_file(name):
    with open(os.path.join(HERE, name), encoding="utf-8") as text:
        return text.read()


def quantity(newtons):
    """4.54 kN, 82 N: three figures and the unit."""
    if np.isnan(newtons):
        return "-"
    if abs(newtons) >= 999.5:
        return "%.3g kN" % (newtons / 1e3) if abs(newtons) < 999.5e3 else "%.3g MN" % (newtons / 1e6)
    return "%.3g N" % newtons


def figures(value, stddev):
    """As many decimals as two figures of the standard deviation need: 1.44 for 0.062, 150 for 84."""
    if not np.isfinite(value):
        return "-"
    decimals = 1 - int(np.floor(np.log10(stddev))) if stddev > 0.0 else 0
    return "%.*f" % (min(max(decimals, 0), 9), round(value, decimals))


def table(head, rows):
    cells = lambda kind, row: "".join("<%s>%s</%s>" % (kind, html.escape(str(x)), kind) for x in row)  # noqa: E731
    return "<table><tr>%s</tr>%s</table>" % (cells("th", head), "".join("<tr>%s</tr>" % cells("td", row) for row in rows))


def section(title, *parts):
    return "<section><h2>%s</h2>%s</section>" % (html.escape(title), "".join(parts))


def headline(dive):
    largest = dive.ends["max_tension"]
    shown = []
    if dive.summary.get("epoch"):
        shown.append(("began", time.strftime("%Y-%m-%d %H:%M:%S UTC", time.gmtime(dive.summary["epoch"] + dive.t[0]))))
    shown.append(("duration", "%.0f s" % (dive.t[-1] - dive.t[0])))
    if np.isfinite(largest).any():
        k = int(np.nanargmax(largest))
        shown += [("largest tension", quantity(largest[k])),
                  ("when and where", "t = %.1f s, s = %.0f m" % (dive.t[k], dive.ends["max_tension_s"][k]))]
        load = dive.summary.get("working_load")
        if load:
            shown.append(("of the working load", "%.0f %%" % (100.0 * largest[k] / load)))
    total = len(dive.status)
    for word in ("OK", "DEGRADED", "INVALID", "STOWED"):
        if word in dive.status:
            shown.append((word, "%.1f %% of the time" % (100.0 * dive.status.count(word) / total)))
    return '<div class="figures">%s</div>' % "".join("<div>%s<b>%s</b></div>" % (html.escape(n), html.escape(v)) for n, v in shown)


def or_dash(text):
    return text if text and text != "nan" else "-"


def alarms(dive):
    """Every alarm from its rise to its end, with its peak between."""
    if dive.alarms is None:
        return "<p>No alarm was raised.</p>"
    rows, open_at = [], {}
    columns = {name: dive.alarms.text(name) for name in ("name", "state", "severity", "limit", "s")}
    t, value = dive.alarms["t"], dive.alarms["value"]
    for k, name in enumerate(columns["name"]):
        if columns["state"][k] == "NORMAL":
            if name in open_at:
                rows[open_at.pop(name)][3] = "%.1f" % t[k]
            continue
        if name not in open_at:
            open_at[name] = len(rows)
            rows.append([name.replace("_", " "), columns["severity"][k].lower(), "%.1f" % t[k], "-", "%.4g" % value[k],
                         or_dash(columns["limit"][k]), or_dash(columns["s"][k])])
    return table(["alarm", "severity", "from [s]", "to [s]", "value when raised", "limit", "s [m]"], rows) if rows else "<p>No alarm was raised.</p>"


def slider(dive):
    shape, unit = dive.shape, charts.Unit(dive)
    keep = np.unique(np.linspace(0, len(shape.t) - 1, MOST_FRAMES).astype(int))
    frames, corners = [], {"rz": [], "xy": []}
    for k in keep:
        x, y = shape.x[k] - shape.x[k, 0], shape.y[k] - shape.y[k, 0]
        r = np.hypot(x, y)
        frames.append({"t": round(float(shape.t[k]), 2), "x": np.round(x, 2).tolist(), "y": np.round(y, 2).tolist(),
                       "r": np.round(r, 2).tolist(), "z": np.round(shape.z[k], 2).tolist(),
                       "tension": np.round(shape.tension[k]).tolist()})
        corners["rz"].append((r, shape.z[k]))
        corners["xy"].append((x, y))
    box = {}
    for name, pairs in corners.items():
        across, up = (np.concatenate([pair[i] for pair in pairs]) for i in (0, 1))
        pad = 0.05 * max(np.ptp(across), np.ptp(up), 1.0)
        box[name] = [float(across.min() - pad), float(across.max() + pad), float(up.min() - pad), float(up.max() + pad)]
    data = json.dumps({"frames": frames, "box": box, "most": float(max(np.nanmax(shape.tension), 1e-9)),
                       "unit": unit.name, "size": unit.size}, allow_nan=False)
    return ('<p id="shape-label"></p><input type="range" id="shape-time" min="0" value="0" aria-label="time">'
            '<div class="pair"><canvas id="shape-elevation" width="640" height="480"></canvas>'
            '<canvas id="shape-plan" width="640" height="480"></canvas></div>'
            "<p>Square: vessel; dot: vehicle; the darker, the tauter.</p>"
            '<script type="application/json" id="shape-data">%s</script><script>%s</script>' % (data, own_file("shape.js")))


def learnt(table_of):
    last = {}
    for k, name in enumerate(table_of.text("name")):
        last[name] = k
    columns = {key: table_of[key] for key in ("mean", "stddev", "configured", "configured_stddev")}
    rows = []
    for name, k in last.items():
        mean, stddev, configured, told = (columns[key][k] for key in ("mean", "stddev", "configured", "configured_stddev"))
        if not told > 0.0:
            continue
        is_told = stddev < NOT_TOLD * told or abs(mean - configured) > told
        rows.append([name, UNITS.get(name.rsplit(".", 1)[0], UNITS.get(name, "")), "%s ± %s" % (figures(configured, told), figures(told, told)),
                     "%s ± %s" % (figures(mean, stddev), figures(stddev, stddev)) if is_told else "the dive does not tell"])
    return table(["parameter", "unit", "configured", "believed at the end"], rows)


def fatigue(dive):
    known = dive.vessel[~np.isnan(dive.vessel)]
    counted = rainflow.cycles(known)
    if not counted:
        return "<p>No cycle of tension.</p>"
    text = "<p>%.0f cycles of tension at the vessel end, the largest of %s. Counted by rainflow (ASTM E1049-85) over the rows of ends.csv.</p>" % (
        sum(c for _, c in counted), quantity(max(r for r, _ in counted)))
    return text + '<div class="pair">%s%s</div>' % (charts.cycle_counts(counted, charts.Unit(dive)), charts.exceedance(dive))


def contacts(table_of):
    t, s = table_of["t"], table_of["s"]
    rows = []
    for name, pick in table_of.groups("obstacle"):
        rows.append([name, "%.1f" % t[pick][0], "%.1f" % t[pick][-1], int(pick.sum()), "%.1f to %.1f" % (s[pick].min(), s[pick].max())])
    return table(["obstacle", "first [s]", "last [s]", "rows", "s [m]"], rows)


def inputs(table_of):
    t, messages, refused, delay, gap = (table_of[key] for key in ("t", "messages", "refused", "delay", "longest_gap"))
    rows = []
    for name, pick in sorted(table_of.groups("topic"), key=lambda group: group[0]):
        count, worst = messages[pick].sum(), int(np.argmax(np.where(pick, gap, -1.0)))
        rows.append([name, int(count), int(refused[pick].sum()), "%.2f" % ((delay[pick] * messages[pick]).sum() / count),
                     "%.1f, in the ten seconds from t = %.0f" % (gap[worst], t[worst])])
    return table(["topic", "messages", "refused", "age when it came, mean [s]", "longest time without one [s]"], rows) + charts.inputs(table_of)


def two(x):
    """Two figures, - for nothing."""
    return "-" if x is None else figures(x, abs(x))


def score(summary):
    scored = summary.get("forecast") or {}
    if not scored.get("forecasts"):
        return ""
    parts = [table(["forecasts", "times over the limit", "Brier score (0: always right)", "computing, each [s]"],
                   [[scored["forecasts"], scored["events"], two(scored["brier_score"]), two(scored["cpu_seconds"] / scored["forecasts"])]])]
    rows = [["%.0f %%" % (100.0 * w["from_probability"]), w["warnings"], w["false_warnings"], w["warned_10_s_ahead"], two(w["median_lead_time"])]
            for w in scored["warnings"]]
    if rows:
        parts.append(table(["warning at a probability of", "warnings", "of these false", "times over the limit warned 10 s ahead", "median lead [s]"], rows))
    return "".join(parts)


def page(dive, title):
    parts = [headline(dive), section("Tension", charts.tension(dive)), section("Alarms", alarms(dive))]
    if dive.summary.get("reason"):
        parts.append(section("Why the estimate was not OK", table(["reason", "rows"], sorted(dive.summary["reason"].items()))))
    if dive.shape is not None:
        parts += [section("Shape", slider(dive)), section("Tension along the tether", charts.along_the_tether(dive))]
    if dive.forecast is not None:
        parts.append(section("Forecast against what came", charts.forecast(dive), score(dive.summary)))
    if dive.parameters is not None:
        parts.append(section("What the estimate learnt", learnt(dive.parameters), charts.parameters(dive.parameters)))
    if dive.inputs is not None:
        parts.append(section("What came in", inputs(dive.inputs)))
    if dive.contacts is not None:
        parts.append(section("Contact", contacts(dive.contacts)))
    parts.append(section("Cycles of tension", fatigue(dive)))
    return ('<!DOCTYPE html><html lang="en"><head><meta charset="utf-8"><meta name="viewport" content="width=device-width">'
            "<title>%s</title><style>%s</style></head><body><h1>%s</h1>%s</body></html>\n"
            % (html.escape(title), own_file("page.css"), html.escape(title), "".join(parts)))
