"""Draws time over error of benchmarks/solids.cc: plot_solids.py TABLE.csv PICTURE.png"""

import csv
import sys

import matplotlib

matplotlib.use("Agg")
import matplotlib.pyplot as plt


def main(table, picture):
    with open(table, newline="") as file:
        rows = list(csv.DictReader(file))
    scenes = list(dict.fromkeys(row["scene"] for row in rows))
    figure, axes = plt.subplots(1, len(scenes), figsize=(4 * len(scenes), 3.6), constrained_layout=True)
    for axis, scene in zip(axes, scenes):
        for element, style in (("reduced", "o-"), ("full", "s--")):
            part = [row for row in rows if row["scene"] == scene and row["element"] == element]
            axis.loglog([100 * float(row["error"]) for row in part], [float(row["cpu_s"]) for row in part], style,
                        label=element)
            for row in part:
                axis.annotate(row["cells"], (100 * float(row["error"]), float(row["cpu_s"])), fontsize=7,
                              xytext=(3, 3), textcoords="offset points")
        axis.set_title(scene)
        axis.set_xlabel("error [%]")
        axis.grid(True, which="both", alpha=0.3)
        axis.legend()
    axes[0].set_ylabel("processor time [s]")
    figure.savefig(picture, dpi=120)


if __name__ == "__main__":
    if len(sys.argv) != 3:
        sys.exit(__doc__)
    main(sys.argv[1], sys.argv[2])
