#!/usr/bin/python3
"""Draws the loops of a material test.

Usage: material.py FOLDER

FOLDER holds material.csv and cycles.csv of the command material; loops.png and cycles.png go there: stress over
strain, axial and in shear, and strains and ratcheting over the cycles.
"""

import os
import sys

sys.dont_write_bytecode = True  # the scripts may lie in a folder that is not ours to write to

import numpy as np

import columns
import style

plt = style.plt


def driven(values):
    return np.ptp(values) > 0


def draw_loops(folder, steps):
    """Stress over strain, each cycle in its shade; kinds that nothing happens in are left out."""
    kinds = [("axial", 1e3 * steps["E_xx"], steps["S_xx_MPa"], "axial strain [10$^{-3}$]"),
             ("shear", 2e3 * steps["E_xy"], steps["S_xy_MPa"], "change of the angle [10$^{-3}$]")]
    kinds = [kind for kind in kinds if driven(kind[1])]
    last = int(steps["cycle"][-1])
    colors = plt.get_cmap("viridis")
    figure, row = plt.subplots(1, len(kinds), figsize=(1.5 + 5.2 * len(kinds), 4.4), squeeze=False)
    for axes, (name, strain, stress, label) in zip(row[0], kinds):
        x, y, cycles = (np.concatenate(([first], values)) for first, values in
                        ((0, strain), (0, stress), (1, steps["cycle"])))
        for cycle in range(1, last + 1):
            own = np.flatnonzero(cycles == cycle)
            part = slice(max(own[0] - 1, 0), own[-1] + 1)  # from where the cycle before ended
            axes.plot(x[part], y[part], linewidth=0.9, color=colors(0.9 * (1 - cycle / last)))
        axes.set_xlabel(label)
        axes.set_ylabel(f"{name} stress [MPa]")
        axes.grid(True)
    figure.tight_layout()
    path = os.path.join(folder, "loops.png")
    figure.savefig(path)
    return path


def draw_cycles(folder, cycles):
    """Middle of the strains and ratcheting over the cycles."""
    figure, (left, right) = plt.subplots(1, 2, figsize=(10.5, 4))
    for name, color in (("axial", style.BLUE), ("shear", style.RED)):
        low, high = cycles[f"{name}_strain_min"], cycles[f"{name}_strain_max"]
        if not driven(np.concatenate((low, high))):
            continue
        left.fill_between(cycles["cycle"], 1e3 * low, 1e3 * high, color=color, alpha=0.25,
                          label=f"{name} strain")
        right.plot(cycles["cycle"][1:], 1e3 * cycles[f"{name}_ratcheting"][1:], color=color, marker=".",
                   label=name)
    left.set_ylabel("least and largest strain of the cycle [10$^{-3}$]")
    right.set_ylabel("ratcheting of the cycle [10$^{-3}$]")
    for axes in (left, right):
        axes.set_xlabel("cycle")
        axes.grid(True)
        axes.legend()
    figure.tight_layout()
    path = os.path.join(folder, "cycles.png")
    figure.savefig(path)
    return path


def main(arguments):
    if len(arguments) != 1:
        print(__doc__, file=sys.stderr)
        return 1
    folder = arguments[0]
    try:
        steps = columns.read(os.path.join(folder, "material.csv"))
        pictures = [draw_loops(folder, steps)] if driven(steps["E_xx"]) or driven(steps["E_xy"]) else []
        cycles = columns.read(os.path.join(folder, "cycles.csv"))
        if len(cycles["cycle"]) > 1:
            pictures.append(draw_cycles(folder, cycles))
    except (OSError, ValueError, IndexError, KeyError) as error:
        print(error, file=sys.stderr)
        return 1
    print(f"{len(pictures)} pictures in {folder}")
    return 0


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))
