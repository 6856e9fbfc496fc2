#!/usr/bin/python3
"""Draws the error of the main scene over its cost from the table "Error over cost" of doc/measured.md.

Usage: benchmarks/error_over_cost.py [PICTURE]

From the folder of the program; the picture of README.md unless another is named.
"""

import math
import re
import sys

import matplotlib

matplotlib.use("Agg")
import matplotlib.pyplot as plt

PAGE, PICTURE = "doc/measured.md", "doc/pictures/error_over_cost.png"
RESULTS = ("peak pressure", "area", "peak shear", "creepage")


def rows():
    """Each row of the table as a dict of its columns."""
    with open(PAGE, encoding="utf-8") as file:
        lines = file.read().split("Error over cost,", 1)[1].splitlines()
    table = [[cell.strip() for cell in line.strip("|").split("|")] for line in lines if line.startswith("|")]
    until = next((k for k, row in enumerate(table[2:], 2) if not row[0].endswith("mm")), len(table))
    return [dict(zip(table[0], row)) for row in table[2:until]]


def main(picture):
    table = rows()
    seconds = [float(row["wall time"].split()[0]) for row in table]
    figure, panels = plt.subplots(1, len(RESULTS), sharey=True, figsize=(9, 3), constrained_layout=True)
    for axes, name in zip(panels, RESULTS):
        # difference; where the run gives an interval, those of its ends, too
        numbers = [[float(n) for n in re.findall(r"[-+][.\d]+", row[name].split("(")[1])] for row in table]
        axes.axhline(0, color="0.4", linewidth=0.8)
        axes.fill_between(seconds, [n[1] if len(n) == 3 else math.nan for n in numbers],
                          [n[-1] if len(n) == 3 else math.nan for n in numbers], alpha=0.25, linewidth=0)
        axes.plot(seconds, [n[0] for n in numbers], "o-")
        for row, second in zip(table, seconds):
            axes.annotate(row["cells"].removesuffix(" mm"), (second, 0.02), xycoords=("data", "axes fraction"), ha="center",
                          fontsize="small")
        axes.set(title=name, xscale="log", xlim=(seconds[0] / 1.6, 1.6 * seconds[-1]))
        axes.set_xticks((10, 100, 1000), ("10", "100", "1000"))
        axes.minorticks_off()
        axes.grid(alpha=0.3)
    panels[0].set_ylabel("off the true bodies [%]")
    figure.supxlabel("wall time on two cores [s]; numbers inside: cells [mm]; bands: the run's own intervals", fontsize="medium")
    figure.savefig(picture, dpi=120)


if __name__ == "__main__":
    main(*sys.argv[1:] or [PICTURE])
