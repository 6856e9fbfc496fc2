"""Draws error and time of benchmarks/contact.cc: plot_contact.py TABLE.csv PICTURE.png"""

import csv
import sys

import matplotlib

matplotlib.use("Agg")
import matplotlib.pyplot as plt

DEFAULT_SCALE = 10


def select(rows, **wanted):
    return [row for row in rows if all(row[key] == value for key, value in wanted.items())]


def numbers(rows, column):
    return [abs(float(row[column])) for row in rows]


def mark_default(axis, rows, x, y):
    for row in rows:
        if float(row["scale"]) == DEFAULT_SCALE:
            axis.plot(abs(float(row[x])), abs(float(row[y])), "o", mfc="none", mec="black", ms=11)


def main(table, picture):
    with open(table, newline="") as file:
        rows = list(csv.DictReader(file))
    filtered = select(rows, filter="consistent")
    shapes = [shape for shape in ("point", "ellipse", "line") if select(rows, shape=shape)]
    figure, axes = plt.subplots(2, len(shapes), figsize=(4 * len(shapes), 6.8), constrained_layout=True, squeeze=False)
    for upper, lower, shape in zip(axes[0], axes[1], shapes):
        for k, cell in enumerate(dict.fromkeys(row["cell_mm"] for row in rows)):
            part = select(filtered, shape=shape, cell_mm=cell)
            upper.loglog(numbers(part, "scale"), numbers(part, "peak_percent"), "o-", ms=4, color=f"C{k}",
                         label=f"{cell} mm")
            mark_default(upper, part, "scale", "peak_percent")
            lower.loglog(numbers(part, "cpu_s"), numbers(part, "peak_percent"), "o", ms=4, color=f"C{k}",
                         label=f"{cell} mm")
            for row in part:
                lower.annotate(row["scale"], (float(row["cpu_s"]), abs(float(row["peak_percent"]))), fontsize=7,
                               xytext=(6, -2), textcoords="offset points")
            mark_default(lower, part, "cpu_s", "peak_percent")
        upper.set_title(shape)
        upper.set_xlabel("penalty scale f")
        lower.set_xlabel("processor time [s]")
        for axis in (upper, lower):
            axis.axhline(1, color="grey", lw=0.8, ls="--")
            axis.grid(True, which="both", alpha=0.3)
        upper.legend(title="cell size")
    axes[0][0].set_ylabel("error of the peak pressure [%]")
    axes[1][0].set_ylabel("error of the peak pressure [%]")
    figure.suptitle("Surface filter on; black circles: the default f = 10; small figures: f", fontsize=9)
    figure.savefig(picture, dpi=120)


if __name__ == "__main__":
    if len(sys.argv) != 3:
        sys.exit(__doc__)
    main(sys.argv[1], sys.argv[2])
