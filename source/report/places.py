#!/usr/bin/python3
"""Draws the contact of a wheel at rest over irregular surfaces: peak pressure, area and drop of the wheel.

Usage: places.py FOLDER

FOLDER holds places.csv of the command halfspace --places or --pitch; the picture is FOLDER/pictures/places.png.
"""

import sys

sys.dont_write_bytecode = True  # the scripts may lie in a folder that is not ours to write to

import matplotlib.pyplot as plt
import numpy as np

import columns
import style


def make_figure(table, _):
    turned = np.ptp(table["place_m"]) == 0
    x = np.degrees(table["pitch_rad"]) if turned else 1e3 * table["place_m"]
    figure, (upper, lower) = plt.subplots(2, 1, figsize=(7.6, 6.4), sharex=True)
    upper.plot(x, 1e-6 * table["max_pressure_Pa"], marker=".", color=style.RED, label="peak pressure")
    upper.set_ylabel("peak pressure [MPa]")
    other = upper.twinx()
    other.plot(x, 1e6 * table["area_of_whole_elements_m2"], marker=".", color=style.BLUE, label="area (right)")
    other.set_ylabel("contact area [mm$^2$]")
    other.set_ylim(bottom=0)
    upper.set_ylim(bottom=0)
    for at in x[table["separate_patches"] > 1]:
        upper.axvline(at, color=style.GREY, linewidth=0.6, linestyle=":", zorder=0)
    lines = upper.get_lines()[:1] + other.get_lines()
    upper.legend(lines, [line.get_label() for line in lines], loc="best")
    lower.plot(x, 1e6 * table["wheel_drop_m"], marker=".", color=style.BLUE)
    lower.invert_yaxis()
    lower.set_ylabel("drop of the wheel [um]")
    lower.set_xlabel("pitch of the wheel [deg]" if turned else "place along the track [mm]")
    for axes in (upper, lower):
        axes.grid(True)
    if np.any(table["separate_patches"] > 1):
        upper.set_title("dotted: several separate patches", fontsize=9)
    return figure


if __name__ == "__main__":
    sys.exit(columns.draw(sys.argv[1:], __doc__, "places", make_figure))
