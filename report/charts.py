"""Charts of a dive as SVG, colour-blind safe (Okabe and Ito), black on white for print."""
import io

import matplotlib

matplotlib.use("svg")
import matplotlib.pyplot as plt  # noqa: E402
import numpy as np  # noqa: E402

VESSEL, VEHICLE, LARGEST, LIMIT, BREAKING = "#0072B2", "#E69F00", "#555555", "#D55E00", "#000000"
STATUS_COLOURS = {"OK": "#009E73", "DEGRADED": "#E69F00", "INVALID": "#D55E00", "STOWED": "#999999"}
MOST_POINTS = 4000

plt.rcParams.update({"font.size": 9, "axes.grid": True, "grid.alpha": 0.3, "axes.spines.top": False, "axes.spines.right": False,
                     "svg.fonttype": "none", "legend.frameon": False, "svg.hashsalt": "tether_report"})


def svg(figure):
    text = io.StringIO()
    figure.savefig(text, format="svg", bbox_inches="tight", metadata={"Date": None})
    plt.close(figure)
    whole = text.getvalue()
    return whole[whole.index("<svg"):]


def thinned(t, *series):
    """At most MOST_POINTS of a long record: of every stretch its least and its largest value of the first series."""
    if len(t) <= MOST_POINTS:
        return (t,) + series
    stretch = -(-2 * len(t) // MOST_POINTS)
    whole = len(t) // stretch * stretch
    rows = np.where(np.isnan(series[0]), np.inf, series[0])[:whole].reshape(-1, stretch)
    first = np.arange(len(rows)) * stretch
    least = first + rows.argmin(axis=1)
    most = first + np.where(np.isinf(rows), -np.inf, rows).argmax(axis=1)
    keep = np.unique(np.r_[least, most])
    return tuple(x[keep] for x in (t,) + series)


class Unit:
    """That of the tensions of a dive: kN if they get to 2 kN."""

    def __init__(self, dive):
        is_large = np.nanmax(np.r_[0.0, dive.ends["max_tension"]]) >= 2e3
        self.name, self.size = ("kN", 1e3) if is_large else ("N", 1.0)

    def label(self, axis, text="tension"):
        axis.yaxis.set_major_formatter(matplotlib.ticker.FuncFormatter(lambda x, _: "%g" % (x / self.size)))
        axis.set_ylabel("%s [%s]" % (text, self.name))


def legend_above(axis, columns):
    axis.legend(loc="lower right", bbox_to_anchor=(1.0, 1.0), fontsize=8, ncol=columns)


def limits(axis, summary, top):
    for key, name, colour in (("working_load", "working load", LIMIT), ("breaking_load", "breaking load", BREAKING)):
        load = summary.get(key)
        if load and load < 3.0 * top:
            axis.axhline(load, color=colour, linestyle="--", linewidth=1.0, label=name)


def tension(dive):
    figure, (ends, status) = plt.subplots(2, 1, figsize=(9.0, 4.2), sharex=True, gridspec_kw={"height_ratios": [12, 1]})
    for name, series, colour in (("vessel", dive.vessel, VESSEL), ("vehicle", dive.vehicle, VEHICLE)):
        low, high = "%s_tension_p05" % name, "%s_tension_p95" % name
        if low in dive.ends:
            t, _, p05, p95 = thinned(dive.t, series, dive.ends[low], dive.ends[high])
            ends.fill_between(t, p05, p95, color=colour, alpha=0.25, linewidth=0, label="%s end, 5 to 95 %%" % name)
        t, line = thinned(dive.t, series)
        ends.plot(t, line, color=colour, linewidth=1.0, label="%s end" % name)
    t, largest = thinned(dive.t, dive.ends["max_tension"])
    ends.plot(t, largest, color=LARGEST, linewidth=0.6, linestyle=":", label="largest along the tether")
    top = np.nanmax(np.r_[0.0, dive.ends["max_tension"]])
    limits(ends, dive.summary, top)
    ends.set_ylim(bottom=0.0)
    Unit(dive).label(ends)
    legend_above(ends, 3)
    status.set_yticks([])
    status.set_ylim(0.0, 1.0)
    status.grid(False)
    for begin, end, word in spells(dive.t, dive.status):
        status.axvspan(begin, end, color=STATUS_COLOURS.get(word, "#999999"), linewidth=0)
    words = [word for word in STATUS_COLOURS if word in dive.status]
    status.legend([plt.Rectangle((0, 0), 1, 1, color=STATUS_COLOURS[word]) for word in words], words, title="what the estimate was worth",
                  title_fontsize=8, fontsize=8, loc="upper left", bbox_to_anchor=(0.0, -1.2), ncol=len(words), borderaxespad=0.0)
    status.set_xlabel("time [s]", x=1.0, ha="right")
    return svg(figure)


def spells(t, words):
    """Begin, end and word of every stretch with the same word."""
    changes = [k for k in range(1, len(words)) if words[k] != words[k - 1]]
    borders = [0] + changes + [len(words) - 1]
    return [(t[a], t[b], words[a]) for a, b in zip(borders, borders[1:]) if b > a]


def along_the_tether(dive):
    shape, unit = dive.shape, Unit(dive)
    figure, axis = plt.subplots(figsize=(9.0, 3.4))
    keep = np.unique(np.linspace(0, len(shape.t) - 1, 400).astype(int))
    axis.grid(False)
    image = axis.pcolormesh(shape.t[keep], shape.s[0], shape.tension[keep].T / unit.size, cmap="cividis", shading="nearest", rasterized=True)
    axis.set_xlabel("time [s]")
    axis.set_ylabel("s from the vessel [m]")
    axis.invert_yaxis()
    figure.colorbar(image, label="tension [%s]" % unit.name)
    return svg(figure)


def forecast(dive):
    """The median and the 95 % quantile that were forecast for the next seconds, and what came in them."""
    table = dive.forecast
    t, horizon = table["t"], table["horizon"]
    median, high = table["max_tension"], table["max_tension_p95"]
    largest = dive.ends["max_tension"]
    came = np.array([np.nan if np.isnan(h) or b + h > dive.t[-1] else np.nanmax(np.r_[np.nan, largest[(dive.t >= b) & (dive.t <= b + h)]])
                     for b, h in zip(t, horizon)])
    figure, (peak, chance) = plt.subplots(2, 1, figsize=(9.0, 4.2), sharex=True, gridspec_kw={"height_ratios": [2, 1]})
    peak.fill_between(t, median, high, color=VESSEL, alpha=0.25, linewidth=0, label="forecast, median to 95 %")
    peak.plot(t, came, color=LIMIT, linewidth=1.0, label="came")
    Unit(dive).label(peak, "largest in the next\n%.0f s" % np.nanmedian(horizon))
    legend_above(peak, 2)
    chance.plot(t, 100.0 * table["probability_over_tension"], color=VESSEL, linewidth=1.0)
    chance.set_ylim(0.0, 100.0)
    chance.set_ylabel("over-tension within\nthem [%]")
    chance.set_xlabel("time at which it was forecast [s]")
    return svg(figure)


def inputs(table):
    """A row a topic: where nothing came it is white, where something was refused there is a dot."""
    topics = sorted(table.groups("topic"), key=lambda group: group[0])
    t, messages, refused = table["t"], table["messages"], table["refused"]
    period = np.min(np.diff(np.unique(t))) if len(np.unique(t)) > 1 else 10.0
    figure, axis = plt.subplots(figsize=(9.0, 0.8 + 0.3 * len(topics)))
    for k, (_, pick) in enumerate(topics):
        usual = np.median(messages[pick])
        axis.bar(t[pick], np.minimum(0.8 * messages[pick] / usual, 0.8), width=period, bottom=k - 0.4, align="edge", color=VESSEL, linewidth=0)
        bad = pick & (refused > 0)
        axis.plot(t[bad] + 0.5 * period, np.full(bad.sum(), k), "o", color=LIMIT, markersize=4)
    axis.set_yticks(range(len(topics)))
    axis.set_yticklabels([name for name, _ in topics], fontsize=8)
    axis.set_xlabel("time [s]; height: messages over their usual number, dots: some were refused")
    return svg(figure)


def exceedance(dive):
    unit = Unit(dive)
    figure, axis = plt.subplots(figsize=(4.3, 3.2))
    for name, series, colour in (("vessel end", dive.vessel, VESSEL), ("vehicle end", dive.vehicle, VEHICLE)):
        known = np.sort(series[~np.isnan(series)])[::-1]
        if len(known):
            axis.plot(known[:: max(1, len(known) // 1000)] / unit.size,
                      (100.0 * (np.arange(len(known)) + 1) / len(known))[:: max(1, len(known) // 1000)], color=colour, label=name)
    axis.set_yscale("log")
    axis.set_xlabel("tension [%s]" % unit.name)
    axis.set_ylabel("share of the time above [%]")
    axis.legend(fontsize=8)
    return svg(figure)


def cycle_counts(counted, unit):
    """@param counted  pairs of range [N] and count."""
    figure, axis = plt.subplots(figsize=(4.3, 3.2))
    ranges = np.array([r for r, _ in counted])
    edges = np.linspace(0.0, ranges.max(), 13)
    counts, _ = np.histogram(ranges, edges, weights=[c for _, c in counted])
    axis.bar(edges[:-1] / unit.size, counts, width=np.diff(edges) / unit.size, align="edge", color=VESSEL, edgecolor="white")
    axis.set_yscale("log")
    axis.set_xlabel("range of a cycle [%s]" % unit.name)
    axis.set_ylabel("cycles")
    return svg(figure)


def parameters(table):
    groups = [(name, pick) for name, pick in table.groups("name") if (table["configured_stddev"][pick] > 0.0).any()]
    figure, axes = plt.subplots(-(-len(groups) // 3), 3, figsize=(9.0, 1.7 * -(-len(groups) // 3)), sharex=True, squeeze=False)
    t, mean, stddev, configured = (table[key] for key in ("t", "mean", "stddev", "configured"))
    for axis, (name, pick) in zip(axes.flat, groups):
        axis.fill_between(t[pick], mean[pick] - stddev[pick], mean[pick] + stddev[pick], color=VESSEL, alpha=0.25, linewidth=0)
        axis.plot(t[pick], mean[pick], color=VESSEL, linewidth=1.0)
        axis.plot(t[pick], configured[pick], color=BREAKING, linestyle="--", linewidth=0.8)
        axis.set_title(name, fontsize=8)
    for axis in list(axes.flat)[len(groups):]:
        axis.axis("off")
    figure.tight_layout()
    return svg(figure)
