"""Draws time over error of benchmarks/solids.cc: plot_solids.py TABLE.csv PICTURE.png"""

import csv
import sys

import matplotlib

matplotlib.use("Agg")
import matplotlib.pyplot as plt
from matplotlib.ticker import FuncFormatter, LogLocator

TITLES = {"bar": "pulse in a bar\ndisplacement, root mean square",
          "ball": "ball on a plane\nlargest force, against Hertz's theory",
          "sphere": "thick sphere beyond yield\nlargest radial stress over Y"}


def plain(axis):
    """Ticks at 1, 2, 5 of each decade with plain numbers, and room for the labels at the points."""
    axis.margins(x=0.18, y=0.15)
    for one in (axis.xaxis, axis.yaxis):
        one.set_major_locator(LogLocator(subs=(1, 2, 5)))
        one.set_major_formatter(FuncFormatter(lambda value, _: f"{value:g}"))
        one.set_minor_formatter(FuncFormatter(lambda value, _: ""))


def main(table, picture):
    with open(table, newline="") as file:
        rows = list(csv.DictReader(file))
    scenes = list(dict.fromkeys(row["scene"] for row in rows))
    figure, axes = plt.subplots(1, len(scenes), figsize=(4 * len(scenes), 3.8), constrained_layout=True)
    for axis, scene in zip(axes, scenes):
        for element, style in (("reduced", "o-"), ("full", "s--")):
            part = [row for row in rows if row["scene"] == scene and row["element"] == element]
            axis.loglog([100 * float(row["error"]) for row in part], [float(row["cpu_s"]) for row in part], style,
                        label=element)
            for row in part:
                axis.annotate(row["cells"], (100 * float(row["error"]), float(row["cpu_s"])), fontsize=7,
                              xytext=(3, 3), textcoords="offset points")
        axis.set_title(TITLES[scene], fontsize=10)
        if scene == "ball":  # what the theory itself leaves out lies below 1 %
            axis.set_xlim(0.1, 2)
        plain(axis)
        axis.set_xlabel("error [%]")
        axis.grid(True, which="both", alpha=0.3)
        axis.legend(loc="lower left")
    axes[0].set_ylabel("processor time of one core [s]")
    figure.suptitle("numbers at the points: cells", fontsize=8, x=0.99, ha="right")
    figure.savefig(picture, dpi=120)


if __name__ == "__main__":
    if len(sys.argv) != 3:
        sys.exit(__doc__)
    main(sys.argv[1], sys.argv[2])
