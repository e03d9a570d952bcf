#!/usr/bin/env python3
"""Draws the curves that path_curves prints, as SVG. The same curves give the same bytes.

Usage: draw_profiles.py path_curves FOLDER
"""
import collections
import csv
import pathlib
import re
import subprocess
import sys

import matplotlib
from matplotlib import pyplot

MOST_BYTES = 60_000
STYLES = {"S_CURVE": ("#0072b2", "-"), "MOD_SINE": ("#d55e00", "--"), "POLY5": ("#009e73", "-."), "SINE2": ("#cc79a7", ":"),
          "0": ("#777777", ":"), "5": ("#0072b2", "-"), "100": ("#d55e00", "--")}


def curves_of(program, kind, *names):
    """{values of `names`: {column: [number...]}}."""
    printed = subprocess.run([program, kind], check=True, capture_output=True, text=True).stdout
    curves = collections.defaultdict(lambda: collections.defaultdict(list))
    for row in csv.DictReader(printed.splitlines()):
        key = tuple(row.pop(name) for name in names)
        for column, value in row.items():
            curves[key][column].append(float(value))
    return curves


def draw(axes, name, xs, ys, label):
    colour, line = STYLES[name]
    axes.plot(xs, ys, color=colour, linestyle=line, linewidth=1.4, label=label)


def laws(program):
    figure, grid = pyplot.subplots(3, 3, figsize=(10, 7), sharex=True, sharey="row", layout="constrained")
    for (law, share), curve in curves_of(program, "laws", "law", "share").items():
        column = ("0", "50", "100").index(share)
        grid[0][column].set_title(f"jerk {share} %")
        for row, what in enumerate(("speed", "acceleration", "jerk")):
            if what == "jerk" and share == "0":
                continue  # it is infinite where the acceleration jumps, and 0 else
            draw(grid[row][column], law, curve["time"], curve[what], law)
    for axes, unit in zip(grid[:, 0], ("speed [deg/s]", "acceleration [deg/s²]", "jerk [deg/s³]")):
        axes.set_ylabel(unit)
    for axes in grid[2]:
        axes.set_xlabel("time [s]")
    grid[2][0].text(0.5, 0.6, "jumps of the acceleration", transform=grid[2][0].transAxes, ha="center")
    for axes in grid.flat:
        axes.axhline(0, color="#b0b0b0", linewidth=0.6, zorder=0)
    grid[0][1].legend(fontsize="small")
    return figure


def corner(program):
    figure, (way, speed) = pyplot.subplots(1, 2, figsize=(10, 3.6), layout="constrained")
    for (tolerance,), curve in curves_of(program, "corner", "tolerance").items():
        label = f"tolerance {tolerance} mm" if tolerance != "0" else "stop"
        draw(way, tolerance, curve["y"], curve["z"], label)
        draw(speed, tolerance, curve["time"], curve["speed"], label)
    way.set(xlim=(-3, 17), ylim=(-3, 17), aspect="equal", xlabel="on from the corner [mm]", ylabel="before the corner [mm]")
    speed.set(xlabel="time [s]", ylabel="speed of the flange [mm/s]")
    for axes in (way, speed):
        axes.grid(alpha=0.3)
    speed.legend(fontsize="small", loc="center left", bbox_to_anchor=(0.1, 0.4))
    return figure


def save(figure, file):
    figure.savefig(file, metadata={"Date": None, "Creator": None})
    # A tenth of a point is less than anybody sees.
    text = re.sub(r"(\d\.\d)\d+", r"\1", file.read_text(encoding="utf-8"))
    file.write_text("\n".join(line.strip() for line in text.splitlines()) + "\n", encoding="utf-8")
    size = file.stat().st_size
    print(f"{file}: {size} bytes")
    if size > MOST_BYTES:
        raise SystemExit(f"{file} has {size} bytes, but at most {MOST_BYTES} are allowed: let path_curves print fewer points")


def main():
    program, folder = sys.argv[1], pathlib.Path(sys.argv[2])
    matplotlib.rcParams.update({"svg.hashsalt": "cobot_command", "svg.fonttype": "none", "font.size": 9, "font.sans-serif": ["DejaVu Sans"],
                                "path.simplify_threshold": 0.5})
    save(laws(program), folder / "laws.svg")
    save(corner(program), folder / "corner.svg")


if __name__ == "__main__":
    main()
