#!/usr/bin/python3
"""Writes the tables of doc/theory from bench/results: each stands between two comments with its name.

write_tables.py [estimation] [forecast] [identification]
"""
import json
import os
import re
import sys

ROOT = os.path.dirname(os.path.dirname(os.path.abspath(__file__)))
WORDS = {False: "no", True: "yes"}


def results(name):
    with open(os.path.join(ROOT, "bench", "results", name + ".json")) as text:
        return json.load(text)


def percent(x, digits=0):
    return "%.*f %%" % (digits, 100.0 * x)


def table(head, rows):
    return "\n".join(["| " + " | ".join(head) + " |", "|" + "---|" * len(head)] + ["| " + " | ".join(row) + " |" for row in rows])


def pooled(rows):
    head = ["case", "latency", "load cell", "vessel: mean, RMS, band [N]", "NEES", "within 1σ", "5 to 95 %", "vehicle: RMS, band [N]",
            "NEES", "within 1σ", "5 to 95 %", "place RMS, within 2σ", "OK"]
    out = []
    for r in rows:
        vessel, vehicle = r["vessel"], r["vehicle"]
        out.append([r["case"], "%g s" % r["latency"], WORDS[r["load_cell"]],
                    "%.0f, %.0f, %.0f" % (vessel["mean"], vessel["rms"], vessel["band"]), "%.2f" % vessel["nees"],
                    percent(vessel["within_1"]), percent(vessel["within_90"]), "%.0f, %.0f" % (vehicle["rms"], vehicle["band"]),
                    "%.2f" % vehicle["nees"], percent(vehicle["within_1"]), percent(vehicle["within_90"]),
                    "%.2f m, %s" % (r["position_rms"], percent(r["position_within_2"])), percent(r["ok"])])
    return table(head, out)


def misconfigured(rows):
    by_fault = {}
    for r in rows:
        by_fault.setdefault((r["case"], r["wrong"]), {})[r["load_cell"]] = r

    def words(r):
        mean = sum(r["vessel_rms"]) / len(r["vessel_rms"])
        return "%s, %s, %s, %s, %.1f s" % (percent(mean, 1), percent(r["vessel"]["band"] / r["vessel"]["mean"], 1), percent(r["within_2"]),
                                           percent(r["ok"]), r["sure_and_wrong"])

    return table(["", "wrong", "positions: RMS, band, within 2σ, OK, longest sure and wrong", "with load cell"],
                 [[case, wrong, words(r[False]), words(r[True])] for (case, wrong), r in by_fault.items()])


def forecast(rows):
    out = []
    for r in rows:
        bins = ["-" if b["forecasts"] == 0 else "%s of %d" % (percent(b["came_true"]), b["forecasts"]) for b in r["reliability"]]
        warnings = ["%d, %s; %d of %d" % (w["warned"], "-" if w["median_lead_time"] is None else "%.0f s" % w["median_lead_time"],
                                          w["false_warnings"], w["warnings"]) for w in r["warnings"]]
        out.append([r["what"], WORDS[r["load_cell"]], str(r["runs"]), str(r["events"])] + warnings + [", ".join(bins)])
    return table(["dive", "load cell", "dives", "events", "warnings from 50 % on: events warned, lead; false", "from 80 %", "from 95 %",
                  "forecasts of 0 to 5, 5 to 20, 20 to 40, 40 to 60, 60 to 80, 80 to 95, 95 to 100 %: came true"], out)


def identification(rows):
    return table(["dive", "load cell", "parameter", "inside 95 %", "identified off", "configured off", "band"],
                 [[r["case"], WORDS[r["load_cell"]], "`%s`" % r["parameter"], "%d of %d" % (r["within_95"], r["truths"]), "%.3f" % r["rms"],
                   "%.3f" % r["configured_rms"], "%.3f" % r["stddev"]] for r in rows])


def write(path, name, text):
    path = os.path.join(ROOT, path)
    with open(path, encoding="utf-8") as source:
        old = source.read()
    new, count = re.subn(r"(<!-- table: %s -->\n).*?(\n<!-- end -->)" % name, lambda m: m.group(1) + text + m.group(2), old, flags=re.DOTALL)
    if count != 1:
        sys.exit("%s has no table '%s'" % (path, name))
    with open(path, "w", encoding="utf-8") as target:
        target.write(new)


def main(names):
    if "estimation" in names:
        estimation = results("estimation")
        write("doc/theory/estimation.md", "pooled", pooled(estimation["pooled"]))
        write("doc/theory/estimation.md", "late", pooled(estimation["late"]))
        write("doc/theory/estimation.md", "changing current", pooled(estimation["changing_current"]))
        write("doc/theory/estimation.md", "misconfigured", misconfigured(estimation["misconfigured"]))
    if "forecast" in names:
        write("doc/theory/forecast.md", "forecast", forecast(results("forecast")))
    if "identification" in names:
        write("doc/theory/estimation.md", "identification", identification(results("identification")))


if __name__ == "__main__":
    main(sys.argv[1:] or ["estimation", "forecast", "identification"])
