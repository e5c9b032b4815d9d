#!/usr/bin/python3
"""Runs tether_steady over the reference tows, prints the deviations and draws the paper's figures.

Usage: validate_steady_tow.py TETHER_STEADY REFERENCE.csv OUT_FOLDER. Exit code 1 if a deviation is above 1e-3 (floor 0.05 m).
"""
import csv
import os
import subprocess
import sys

import matplotlib
matplotlib.use("Agg")
import matplotlib.pyplot as plt
import yaml

ELEMENTS = 50
LIMIT = 1e-3       # relative
FLOOR = 0.05       # [m], of depth and layback


def config_of(row):
    """The configuration of one row: a neutral vehicle without drag under the row's force."""
    drag = float(row["cable_drag"])
    return {
        "tether": {
            "length": float(row["length_m"]), "elements": ELEMENTS, "diameter": float(row["diameter_m"]),
            "mass_per_length": float(row["mass_per_length_kg_m"]), "axial_stiffness": float(row["axial_stiffness_N"]),
            "drag_normal": drag * float(row["drag_normal"]), "drag_tangential": drag * float(row["drag_tangential"]),
            "working_load": 1.0e5, "breaking_load": 1.0e6},
        "vehicle": {
            "mode": "free", "mass": 1025.0, "volume": 1.0, "inertia": [100.0, 100.0, 100.0], "drag_area": [0.0, 0.0, 0.0],
            "force": [float(row["vehicle_force_x_N"]), 0.0, float(row["vehicle_force_z_N"])]}}


def read(path):
    with open(path, newline="") as lines:
        return list(csv.DictReader(lines))


def steady(tool, row, folder):
    os.makedirs(folder, exist_ok=True)
    config = os.path.join(folder, "config.yaml")
    with open(config, "w") as out:
        yaml.safe_dump(config_of(row), out)
    subprocess.run([tool, "--config", config, "--vessel-position", "0,0,-1", "--vessel-velocity",
                    "%s,0,0" % row["tow_speed_m_s"], "--out", folder, "--quiet"], check=True)
    return read(folder + "/ends.csv")[0], read(folder + "/shape.csv")


def size(ends, end):
    return sum(float(ends["%s_f%s" % (end, axis)]) ** 2 for axis in "xyz") ** 0.5


def main():
    tool, reference, out = sys.argv[1:4]
    rows = read(reference)
    figure, axes = plt.subplots(3, 2, figsize=(12, 13))
    worst = 0.0
    print("%-28s %12s %12s %10s %10s" % ("case", "vessel", "vehicle", "depth", "layback"))
    for row in rows:
        ends, shape = steady(tool, row, os.path.join(out, row["case"]))
        deviations = []
        for value, key, floor in ((size(ends, "vessel"), "tension_vessel_N", 0.0), (size(ends, "vehicle"), "tension_vehicle_N", 0.0),
                                  (-float(ends["vehicle_z"]), "depth_m", FLOOR), (-float(ends["vehicle_x"]), "layback_m", FLOOR)):
            expected = float(row[key])
            deviations.append(abs(value - expected) / max(abs(expected), floor / LIMIT))
        worst = max(worst, *deviations)
        print("%-28s %12.1e %12.1e %10.1e %10.1e" % ((row["case"],) + tuple(deviations)))
        lines, tensions = axes[int(row["case"][6]) - 1]
        style = "-" if float(row["cable_drag"]) else "--"
        x0, z0 = float(shape[0]["x"]), float(shape[0]["z"])
        lines.plot([float(p["x"]) - x0 for p in shape], [float(p["z"]) - z0 for p in shape], style, label=row["case"])
        tensions.plot([float(p["s"]) for p in shape], [float(p["tension"]) for p in shape], style, label=row["case"])
    for number, (lines, tensions) in enumerate(axes, 1):
        lines.set(title="System %d: lines (dashed: cable drag off)" % number, xlabel="behind the vessel [m]", ylabel="z [m]")
        tensions.set(title="System %d: tension" % number, xlabel="s [m]", ylabel="tension [N]")
        for axis in (lines, tensions):
            axis.grid(alpha=0.3)
        lines.legend(fontsize=7)
    figure.tight_layout()
    figure.savefig(out + "/steady_tow.png", dpi=90)
    with_drag = {row["case"]: float(row["depth_m"]) for row in rows}
    print("largest relative deviation %.1e (limit %.0e), %d elements" % (worst, LIMIT, ELEMENTS))
    pairs = [(case, case.replace("_drag", "_nodrag")) for case in with_drag if case.endswith("_drag")]
    for case, without in pairs:
        print("cable drag takes %s from %.1f to %.1f m deep" % (case, with_drag[without], with_drag[case]))
    return 0 if worst <= LIMIT else 1


if __name__ == "__main__":
    sys.exit(main())
