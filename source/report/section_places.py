#!/usr/bin/python3
"""Draws a wheel on rails by slices: the surfaces with the contact locus, forces and peak pressures of the patches, and the
drop of the wheel over the path.

Usage: section_places.py FOLDER

FOLDER holds places.csv and sections.csv of the command halfspace --places; the picture is FOLDER/pictures/places.png.
"""

import os
import sys

sys.dont_write_bytecode = True  # the scripts may lie in a folder that is not ours to write to

import matplotlib.pyplot as plt
import numpy as np

import columns
import style

COLOURS = (style.BLUE, style.RED)  # of the rails


def draw_surfaces(axes, table, sections):
    """Heights from above, and the locus of the contact on them."""
    shown = sections["height_m"] > np.max(sections["height_m"]) - 0.03
    order = np.argsort(sections["height_m"][shown])
    picture = axes.scatter(1e3 * sections["place_m"][shown][order], 1e3 * sections["lateral_m"][shown][order],
                           c=1e3 * sections["height_m"][shown][order], s=110, marker="s", linewidths=0,
                           vmin=1e3 * np.max(sections["height_m"]) - 12, cmap="cividis")
    axes.figure.colorbar(picture, ax=axes, label="height [mm]")
    for rail in np.unique(table["rail"]):
        on = table["rail"] == rail
        axes.scatter(1e3 * (table["place_m"] + table["ahead_m"])[on], 1e3 * table["lateral_m"][on],
                     s=4 + 40 * table["normal_force_N"][on] / np.max(table["normal_force_N"]),
                     color=COLOURS[int(rail - 1) % 2], edgecolors="white", linewidths=0.4, zorder=3,
                     label=f"contact, rail {int(rail)}")
    axes.set_ylabel("to the field side [mm]")
    axes.legend(loc="best", fontsize=8)


def draw_sections(axes, sections):
    """The outlines of some sections, one above the other."""
    places = np.unique(sections["place_m"])
    for place, shade in zip(places[::8], np.linspace(0.75, 0, len(places[::8]))):
        for rail in np.unique(sections["rail"]):
            on = (sections["place_m"] == place) & (sections["rail"] == rail)
            axes.plot(1e3 * sections["lateral_m"][on], 1e3 * sections["height_m"][on], color=str(shade), linewidth=0.9)
    axes.set_aspect("equal")
    axes.set_xlabel(f"to the field side [mm]; sections at {1e3 * places[0]:.0f} (light) to {1e3 * places[-1]:.0f} mm")
    axes.set_ylabel("height [mm]")


def draw(table, sections, path):
    figure, axes = plt.subplots(4, 1, figsize=(8.2, 11.5), layout="constrained", height_ratios=(3, 3, 3, 2))
    draw_surfaces(axes[0], table, sections)
    for rail in np.unique(table["rail"]):
        on, colour = table["rail"] == rail, COLOURS[int(rail - 1) % 2]
        place = 1e3 * table["place_m"][on]
        axes[1].plot(place, 1e-3 * table["normal_force_N"][on], ".", color=colour, label=f"force, rail {int(rail)}")
        axes[1].plot(place, 1e-6 * table["max_pressure_Pa"][on] / 100, "x", color=colour, label="peak pressure / 100")
    axes[1].set_ylabel("normal force [kN], pressure / 100 [MPa]")
    axes[1].legend(loc="best", fontsize=8)
    axes[2].plot(1e3 * table["place_m"], 1e3 * table["wheel_drop_m"], ".-", color=style.BLUE)
    axes[2].invert_yaxis()
    axes[2].set_ylabel("drop of the wheel [mm]")
    axes[2].set_xlabel("place of the wheel along the track [mm]")
    for one in axes[:3]:
        one.set_xlim(1e3 * np.min(sections["place_m"]), 1e3 * np.max(sections["place_m"]))
        one.grid(True)
    draw_sections(axes[3], sections)
    os.makedirs(os.path.dirname(path), exist_ok=True)
    figure.savefig(path)


def main(arguments):
    if len(arguments) != 1:
        print(__doc__, file=sys.stderr)
        return 1
    folder = arguments[0]
    path = os.path.join(folder, "pictures", "places.png")
    try:
        draw(columns.read(os.path.join(folder, "places.csv")), columns.read(os.path.join(folder, "sections.csv")), path)
    except OSError as error:
        print(error, file=sys.stderr)
        return 1
    print(f"Picture in {path}")
    return 0


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))
