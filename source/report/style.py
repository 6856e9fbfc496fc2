"""What all pictures share: fonts, colours, scales, the sides of the rail, saving."""

import os
import re
import sys

try:
    import matplotlib
except ImportError as error:
    sys.exit(f"{error}; install the Debian package python3-matplotlib")

matplotlib.use("Agg")

import matplotlib.pyplot as plt  # noqa: E402  (the backend is chosen first)
import numpy as np  # noqa: E402
from matplotlib.ticker import MaxNLocator  # noqa: E402

BLUE, RED, GREEN, ORANGE, GREY = "#1f5fa8", "#c0392b", "#2e8b57", "#d98200", "#6b6b6b"
COLORS = [BLUE, RED, GREEN, ORANGE, "#7d4fa3", GREY, "#00868b", "#8b5a2b", "#c71585"]
OPEN, STICK, SLIP = "#f4f4f4", BLUE, RED
HIGH = "viridis_r"  # colours of pressures, stresses and the like: dark is high, as in all others

matplotlib.rcParams.update({
    "font.size": 10,
    "axes.titlesize": 11,
    "axes.labelsize": 10,
    "legend.fontsize": 9,
    "legend.frameon": False,
    "figure.dpi": 100,
    "savefig.dpi": 150,
    "axes.grid": False,
    "axes.axisbelow": True,
    "grid.color": "#d9d9d9",
    "grid.linewidth": 0.6,
})


def round_levels(low, high, parts=14):
    """Round values at equal steps from `low` or below to `high` or above."""
    if not high > low:
        high = low + 1e-9
    return MaxNLocator(nbins=parts, steps=[1, 2, 2.5, 5, 10]).tick_values(low, high)


def levels_to(top, parts=14):
    """Round values at equal steps from 0, and the end itself: colours end at the value."""
    top = max(top, 1e-9)
    levels = round_levels(0, top, parts)
    step = levels[1] - levels[0]
    return [*(level for level in levels if level < top - 0.4 * step), top]


def round_top(value):
    """A round number that is not below the value: the end of a scale, so that the bar holds the peak."""
    return round_levels(0, value, 8)[-1]


def in_order(count):
    """Colours of so many curves that follow each other, the last one the darkest."""
    return plt.get_cmap(HIGH)([0.08 + 0.92 * k / max(count - 1, 1) for k in range(count)])


def band(axes, places, table, key, factor, color):
    """The interval of 95 % around a curve, of columns such as max_pressure_low_Pa; nothing where there are none."""
    body, unit = re.fullmatch(r"(.*?)((?:_(?:Pa|m2|N|m))?)", key).groups()
    low, high = f"{body}_low{unit}", f"{body}_high{unit}"
    if low in table and high in table:
        fill_band(axes, places, table[low], table[high], factor, color)


def fill_band(axes, places, low, high, factor, color):
    axes.fill_between(places, factor * low, factor * high, color=color, alpha=0.2, linewidth=0)


def name_places(axes, x, y, texts, size=8):
    """Texts above places of a curve, raised where they would cover each other; the limits of the axes must stand."""
    axes.figure.draw_without_rendering()
    taken, pixel = [], axes.figure.dpi / 72
    for place, text in sorted(zip(axes.transData.transform(list(zip(x, y))).tolist(), texts)):
        half, step, up = 0.35 * size * len(text) * pixel, 1.3 * size * pixel, 6 * pixel
        while any(abs(place[0] - a) < half + w and abs(place[1] + up - b) < step for a, b, w in taken):
            up += 0.25 * step
        taken.append((place[0], place[1] + up, half))
        axes.annotate(text, axes.transData.inverted().transform(place), (0, up / pixel), textcoords="offset points",
                      ha="center", fontsize=size)


def color_bar(figure, axes, mappable, label, width=0.04):
    """A bar beside the axes with its label."""
    bar = figure.colorbar(mappable, cax=axes.inset_axes([1.02 + 0.2 * width, 0, width, 1]))
    bar.set_label(label)
    return bar


def level_bar(figure, axes, filled, label, values=None):
    """A bar of filled contours that names both ends and each level between them, or each second from 0 on; `values`:
    what the levels stand for."""
    bar, levels = color_bar(figure, axes, filled, label), np.asarray(filled.levels)
    last, zero = len(levels) - 1, int(np.argmin(np.abs(levels)))
    step = 1 if last < 10 else 2
    named = [0, *(k for k in range(step, last - step + 1) if (k - zero) % step == 0), last]
    bar.set_ticks(levels[named], labels=[f"{(levels if values is None else values)[k]:.4g}" for k in named])
    return bar


def sides(axes, left="G.C.", right="F.S."):
    """Names the sides of the rail above the axes: gauge corner (track centre) and field side."""
    for x, name, place in ((0, left, "left"), (1, right, "right")):
        axes.text(x, 1.02, name, transform=axes.transAxes, ha=place, va="bottom", weight="bold", color=GREY)


def rolling_arrow(axes):
    """Rolling direction up, in the upper left corner of a map."""
    axes.annotate("", xy=(0.06, 0.97), xytext=(0.06, 0.80), xycoords="axes fraction",
                  arrowprops=dict(arrowstyle="-|>", color="black", linewidth=1.4))
    axes.text(0.085, 0.965, "rolling", transform=axes.transAxes, ha="left", va="top", fontsize=9,
              bbox=dict(facecolor="white", edgecolor="none", alpha=0.7, pad=1))


def legend_beside(axes):
    """The legend to the right of the axes, where it covers no curve."""
    axes.legend(loc="upper left", bbox_to_anchor=(1.01, 1), borderaxespad=0)


def save(run, figure, name, pad=0.12):
    """Saves a figure under pictures/; the tight box keeps every label inside, but for those of three-dimensional axes,
    which need a wider pad [inch]."""
    path = os.path.join(run.pictures_folder, name + ".png")
    figure.savefig(path, bbox_inches="tight", pad_inches=pad)
    plt.close(figure)
    return path
