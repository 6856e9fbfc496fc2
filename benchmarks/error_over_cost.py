#!/usr/bin/python3
"""Draws the error of the main scene over its cost from the table "Error over cost" of doc/measured.md.

Usage: benchmarks/error_over_cost.py [PICTURE]

From the folder of the program; the picture of README.md unless another is named.
"""

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
    figure, axes = plt.subplots(figsize=(6, 3), constrained_layout=True)
    for name in RESULTS:
        errors = [abs(float(re.search(r"\(([-+.\d]+)\)", row[name])[1])) for row in table]
        axes.plot(seconds, errors, "o-", label=name)
    for row, second in zip(table, seconds):
        axes.annotate(row["cells"], (second, 4.2), ha="center", fontsize="small")
    axes.set(xscale="log", xlabel="wall time on two cores [s]", ylabel="off the true bodies [%]", xlim=(2.5, 400), ylim=(0, 4.6))
    axes.grid(alpha=0.3)
    axes.set_xticks(seconds, [f"{second:g}" for second in seconds])
    axes.minorticks_off()
    axes.legend(fontsize="small", loc="upper center", bbox_to_anchor=(0.7, 0.9))
    figure.savefig(picture, dpi=120)


if __name__ == "__main__":
    main(*sys.argv[1:] or [PICTURE])
