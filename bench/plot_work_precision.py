#!/usr/bin/env python3
"""Work-precision of the cases A to F: error of the end tensions over the speed. plot_work_precision.py JSON PNG"""
import json
import sys

import matplotlib

matplotlib.use("Agg")
import matplotlib.pyplot as plt  # noqa: E402


def main():
    with open(sys.argv[1]) as file:
        results = json.load(file)
    figure, axes = plt.subplots(2, 3, figsize=(15, 9), constrained_layout=True)
    for axis, case in zip(axes.flat, results["cases"]):
        steps = sorted({run["step"] for run in case["generalized_alpha"]}, reverse=True)
        for step, marker in zip(steps, "osD^vPX"):
            runs = [r for r in case["generalized_alpha"] if r["step"] == step and r["complete"]]
            runs.sort(key=lambda r: r["elements"])
            for end, style in (("vessel", "-"), ("vehicle", ":")):
                axis.loglog([r["times_real_time"] for r in runs], [100 * r[end + "_rms"] for r in runs], style,
                            marker=marker, color="C0" if end == "vessel" else "C1", markersize=5,
                            label="{} end, step {:g} s".format(end, step))
            for r in runs:
                axis.annotate(str(r["elements"]), (r["times_real_time"], 100 * r["vessel_rms"]), fontsize=6,
                              textcoords="offset points", xytext=(3, 3))
        explicit = [r for r in case["abarbanel_zwas"] if r["complete"]]
        axis.loglog([r["times_real_time"] for r in explicit], [100 * r["vessel_rms"] for r in explicit], "k--x",
                    label="abarbanel_zwas, vessel end")
        automatic = [r for r in case["auto"] if r["complete"]]
        axis.loglog([r["times_real_time"] for r in automatic], [100 * r["vessel_rms"] for r in automatic], "r*",
                    markersize=11, label="elements: auto, vessel end")
        axis.set_title("{}: {}".format(case["case"], case["what"]), fontsize=9)
        axis.set_xlabel("times real time (CPU)")
        axis.set_ylabel("RMS error over the mean [%]")
        axis.grid(True, which="both", alpha=0.25)
        axis.legend(fontsize=6)
    figure.suptitle("Work and precision on {} ({}); numbers are elements".format(results["machine"], results["kernel"]))
    figure.savefig(sys.argv[2], dpi=90)


if __name__ == "__main__":
    main()
