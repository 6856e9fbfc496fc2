#!/usr/bin/python3
"""Draws the loops of a material test.

Usage: material.py FOLDER

FOLDER holds material.csv and cycles.csv of the command material; loops.png and cycles.png go there: stress over
strain, axial and in shear, and strains and ratcheting over the cycles.
"""

import csv
import os
import sys

sys.dont_write_bytecode = True  # the scripts may lie in a folder that is not ours to write to

import style

plt = style.plt


def columns(path):
    """Columns of a table by their names."""
    with open(path, encoding="utf-8", newline="") as file:
        rows = list(csv.DictReader(file))
    return {name: [float(row[name]) for row in rows] for name in rows[0]}


def driven(values):
    return max(values) - min(values) > 0


def draw_loops(folder, steps):
    """Stress over strain, each cycle in its shade; kinds that nothing happens in are left out."""
    kinds = [("axial", [1e3 * e for e in steps["E_xx"]], steps["S_xx_MPa"], "axial strain [10$^{-3}$]"),
             ("shear", [2e3 * e for e in steps["E_xy"]], steps["S_xy_MPa"], "change of the angle [10$^{-3}$]")]
    kinds = [kind for kind in kinds if driven(kind[1])]
    last = int(steps["cycle"][-1])
    colors = plt.get_cmap("viridis")
    figure, row = plt.subplots(1, len(kinds), figsize=(1.5 + 5.2 * len(kinds), 4.4), squeeze=False)
    for axes, (name, strain, stress, label) in zip(row[0], kinds):
        begin = 0
        for cycle in range(1, last + 1):
            end = begin
            while end < len(strain) and int(steps["cycle"][end]) == cycle:
                end += 1
            first = max(begin - 1, 0)
            x, y = strain[first:end], stress[first:end]
            if cycle == 1:
                x, y = [0.0] + x, [0.0] + y
            axes.plot(x, y, linewidth=0.9, color=colors(0.9 * (1 - cycle / last)))
            begin = end
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
        if not driven(low + high):
            continue
        left.fill_between(cycles["cycle"], [1e3 * v for v in low], [1e3 * v for v in high], color=color, alpha=0.25,
                          label=f"{name} strain")
        right.plot(cycles["cycle"][1:], [1e3 * v for v in cycles[f"{name}_ratcheting"][1:]], color=color, marker=".",
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
        steps = columns(os.path.join(folder, "material.csv"))
        pictures = [draw_loops(folder, steps)] if driven(steps["E_xx"]) or driven(steps["E_xy"]) else []
        cycles = columns(os.path.join(folder, "cycles.csv"))
        if len(cycles["cycle"]) > 1:
            pictures.append(draw_cycles(folder, cycles))
    except (OSError, ValueError, IndexError, KeyError) as error:
        print(error, file=sys.stderr)
        return 1
    print(f"{len(pictures)} pictures in {folder}")
    return 0


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))
