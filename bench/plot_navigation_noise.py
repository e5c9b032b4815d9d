#!/usr/bin/env python3
"""Vessel tension under navigation noise: truth, held end, observed vehicle. plot_navigation_noise.py FOLDER PNG"""
import sys

import matplotlib

matplotlib.use("Agg")
import matplotlib.pyplot as plt  # noqa: E402
import numpy as np  # noqa: E402


def main():
    figure, axes = plt.subplots(2, 3, figsize=(16, 8), constrained_layout=True)
    for column, case in enumerate("CDG"):
        for row, vehicle in enumerate(("known", "wrong")):
            axis = axes[row][column]
            observed, held = (np.genfromtxt("%s/%s_%s_%s.csv" % (sys.argv[1], case, vehicle, kind), delimiter=",",
                                            names=True) for kind in ("observed", "held"))
            axis.plot(held["t"], held["tension"], color="C3", linewidth=0.4, alpha=0.6, label="held end (no outliers)")
            axis.fill_between(observed["t"], observed["tension"] - 2 * observed["stddev"],
                              observed["tension"] + 2 * observed["stddev"], color="C0", alpha=0.25,
                              label="observed, two standard deviations")
            axis.plot(observed["t"], observed["tension"], color="C0", linewidth=1.0, label="observed")
            axis.plot(observed["t"], observed["truth"], "k--", linewidth=0.8, label="truth")
            axis.set_ylim(0, 2.0 * np.nanmax(observed["truth"]))
            axis.set_xlim(0, min(300.0, observed["t"][-1]))
            axis.set_title("%s, vehicle %s" % (case, vehicle), fontsize=10)
            axis.set_xlabel("t [s]")
            axis.set_ylabel("vessel tension [N]")
            axis.grid(True, alpha=0.25)
    axes[0][0].legend(fontsize=8, loc="lower right")
    figure.suptitle("Positions of the vehicle: 1 Hz, 0.3 m, 5 % outliers, 1 s late; vessel: satellites 5 Hz, 2 cm, heave 20 Hz, 3 cm")
    figure.savefig(sys.argv[2], dpi=80)


if __name__ == "__main__":
    main()
