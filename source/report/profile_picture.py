"""Picture of wheel and rail profile in track position: profile_picture.py NUMBERS.csv PICTURE.png"""

import csv
import os
import sys

import numpy as np

import style  # chooses the backend  (source/report/style.py)
from style import BLUE, GREEN, GREY, ORANGE, RED, plt


def read_rows(path):
    """Rows of the table by their first cell: lists of number pairs, or a text."""
    numbers, texts = {}, {}
    with open(path, newline="") as table:
        for what, a, b in list(csv.reader(table))[1:]:
            if what.endswith("name"):
                texts[what] = os.path.basename(a)
            else:
                numbers.setdefault(what, []).append((float(a), float(b)))
    return {what: np.array(pairs) for what, pairs in numbers.items()}, texts


def draw_profiles(axes, numbers, texts):
    rail, wheel = numbers["rail"], numbers["wheel"]
    (x, y), = numbers["contact"]
    axes.plot(wheel[:, 0], wheel[:, 1], color=BLUE, label="wheel " + texts["wheel name"])
    axes.plot(rail[:, 0], rail[:, 1], color=RED, label="rail " + texts["rail name"])
    axes.plot([x], [y], "o", color="black", markersize=5, label="contact point")
    if "further" in numbers:
        axes.plot(*numbers["further"].T, "o", color=ORANGE, markersize=5, fillstyle="none",
                  label="further minimum of the gap below 1 mm")
    low = min(rail[:, 1].min(), wheel[:, 1].min())
    high = max(rail[:, 1].max(), wheel[:, 1].max())
    axes.set_ylim(low - 4, high + 22)  # room for the legend
    axes.set_aspect("equal")
    axes.grid(True)
    axes.set_xlabel("lateral position X in mm, from the nominal running circle to the track centre")
    axes.set_ylabel("height Y in mm")
    axes.legend(loc="upper center", ncol=2)
    for place, side, align in ((0.01, "\N{LEFTWARDS ARROW} field side", "left"),
                               (0.99, "gauge side \N{RIGHTWARDS ARROW}", "right")):
        axes.text(place, 0.03, side, transform=axes.transAxes, ha=align, va="bottom", color=GREY)
    (shift, roll), = numbers["shift"]
    (radius, angle), = numbers["radius"]
    (on_rail, on_wheel), = numbers["contact in sections"]
    axes.set_title(f"Shift {shift:.2f} mm, roll {roll:.3f} mrad, contact angle {angle:.2f} degrees, rolling radius "
                   f"{radius:.3f} mm\ncontact at x = {on_rail:.2f} mm of the rail, {on_wheel:.2f} mm of the wheel, "
                   "positive to the field side", fontsize=10)


def draw_distance(axes, numbers):
    s, distance = numbers["distance"].T
    axes.plot(s, distance, color=BLUE)
    axes.fill_between(s, distance, 100, where=distance < 100, color=GREEN, alpha=0.25,
                      label="closed by an approach of 0.1 mm")
    if "further gap" in numbers:
        gap, place = numbers["further gap"].T
        inside = (place > s[0]) & (place < s[-1]) & (gap < 400)
        axes.plot(place[inside], gap[inside], "o", color=ORANGE, markersize=5, fillstyle="none")
    axes.plot([0], [0], "o", color="black", markersize=5)
    axes.set_xlim(s[0], s[-1])
    axes.set_ylim(-15, 400)
    axes.grid(True)
    axes.set_xlabel("lateral place s along the common tangent in mm, from the contact point to the gauge side")
    axes.set_ylabel("undeformed distance in \N{MICRO SIGN}m")
    axes.legend(loc="lower left")


def main():
    numbers, texts = read_rows(sys.argv[1])
    figure, (upper, lower) = plt.subplots(2, 1, figsize=(8.5, 8.5), height_ratios=(3, 2),
                                          constrained_layout=True)
    draw_profiles(upper, numbers, texts)
    draw_distance(lower, numbers)
    figure.savefig(sys.argv[2], bbox_inches="tight", pad_inches=0.12)


if __name__ == "__main__":
    main()
