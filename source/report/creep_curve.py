#!/usr/bin/python3
"""Draws a creep curve: forces in the contact plane and spin moment over creepage or spin.

Usage: creep_curve.py FOLDER

FOLDER holds creep_curve.csv of the command halfspace --creep-curve, and beside.csv where points of another curve are
to be drawn beside it; the picture is FOLDER/pictures/creep_curve.png.
"""

import os
import sys

sys.dont_write_bytecode = True  # the scripts may lie in a folder that is not ours to write to

import matplotlib.pyplot as plt

import columns
import style


def make_figure(table, folder):
    path = os.path.join(folder, "beside.csv")
    beside = columns.read(path) if os.path.exists(path) else {}
    given = next(iter(table))
    spin = given.endswith("spin_per_m")
    x = table[given] * (1 if spin else 100)
    figure, axes = plt.subplots(figsize=(7.6, 4.4))
    for name, label, color in (("longitudinal_force_N", "longitudinal", style.BLUE),
                               ("tangential_lateral_force_N", "lateral", style.RED)):
        if name in table:
            axes.plot(x, 1e-3 * table[name], marker=".", color=color, label=label)
        if name in beside:
            axes.plot(beside[given] * (1 if spin else 100), 1e-3 * beside[name], "o", color=color, markersize=8,
                      fillstyle="none", label=label + ", beside")
    axes.set_xlabel("spin [1/m]" if spin else f"{given.split('_')[1]} creepage [%]")
    axes.set_ylabel("force on the wheel, in the contact plane [kN]")
    axes.grid(True)
    if "reference_spin_moment_Nm" in table:
        other = axes.twinx()
        other.plot(x, table["reference_spin_moment_Nm"], color=style.GREY, linestyle="--", linewidth=1,
                   label="spin moment on the rail (right)")
        if "reference_spin_moment_Nm" in beside:
            other.plot(beside[given] * (1 if spin else 100), beside["reference_spin_moment_Nm"], "s", color=style.GREY,
                       fillstyle="none", label="spin moment, beside")
        other.set_ylabel("spin moment on the rail [N m]")
        lines = axes.get_lines() + other.get_lines()
        axes.legend(lines, [line.get_label() for line in lines], loc="best")
    else:
        axes.legend(loc="best")
    return figure


if __name__ == "__main__":
    sys.exit(columns.draw(sys.argv[1:], __doc__, "creep_curve", make_figure))
