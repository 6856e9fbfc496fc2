#!/usr/bin/python3
"""Makes the page of a material test: inputs, extremes, loops.

Usage: material.py FOLDER

FOLDER holds material.csv and cycles.csv of the command material; material.html goes there with
loops.png and cycles.png: stress over strain, axial and in shear, and strains and ratcheting over the cycles.
"""

import os
import sys

sys.dont_write_bytecode = True  # the scripts may lie in a folder that is not ours to write to

import numpy as np

import columns
import inputs
import page
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
    colors = style.in_order(last)
    figure, row = plt.subplots(1, len(kinds), figsize=(1.5 + 5.2 * len(kinds), 4.4), squeeze=False)
    for axes, (name, strain, stress, label) in zip(row[0], kinds):
        x, y, cycles = (np.concatenate(([first], values)) for first, values in
                        ((0, strain), (0, stress), (1, steps["cycle"])))
        for cycle in range(1, last + 1):
            own = np.flatnonzero(cycles == cycle)
            part = slice(max(own[0] - 1, 0), own[-1] + 1)  # from where the cycle before ended
            axes.plot(x[part], y[part], linewidth=0.9, color=colors[cycle - 1])
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


#: of the table at the top: column of cycles.csv, factor, label, unit, digits
FIGURES = [("axial_strain_min", 1e3, "least axial strain", "10\u207b\u00b3", 3), ("axial_strain_max", 1e3, "largest axial strain", "10\u207b\u00b3", 3),
           ("axial_ratcheting", 1e3, "axial ratcheting of the cycle", "10\u207b\u00b3", 4),
           ("shear_strain_min", 1e3, "least change of the angle", "10\u207b\u00b3", 3), ("shear_strain_max", 1e3, "largest change of the angle", "10\u207b\u00b3", 3),
           ("shear_ratcheting", 1e3, "ratcheting in shear of the cycle", "10\u207b\u00b3", 4)]


def figures(cycles):
    """Table of the first and the last cycle; kinds that nothing happens in are left out."""
    first_and_last = [0, -1] if len(cycles["cycle"]) > 1 else [0]
    head = "".join(f"<th>cycle {cycles['cycle'][k]:.0f}</th>" for k in first_and_last)
    rows = [f"<table><tr><th></th>{head}<th></th></tr>"]
    for key, factor, label, unit, digits in FIGURES:
        if key in cycles and np.nanmax(np.abs(cycles[key])) > 0:
            cells = "".join(f"<td class=number>{factor * cycles[key][k]:.{digits}f}</td>" if np.isfinite(cycles[key][k]) else "<td></td>"
                            for k in first_and_last)
            rows.append(f"<tr><td>{label}</td>{cells}<td>{unit}</td></tr>")
    return "\n".join(rows + ["</table>"])


def make_page(folder):
    """Draws what there is and puts inputs, extremes and pictures on material.html."""
    steps = columns.read(os.path.join(folder, "material.csv"))
    cycles = columns.read(os.path.join(folder, "cycles.csv"))
    pictures = []
    if driven(steps["E_xx"]) or driven(steps["E_xy"]):
        pictures.append(("Stress over strain; later cycles are darker", draw_loops(folder, steps)))
    if len(cycles["cycle"]) > 1:
        pictures.append(("Strains and ratcheting over the cycles", draw_cycles(folder, cycles)))
    given = inputs.table(inputs.material_rows(inputs.read(folder)))
    parts = [f"<div class=top><div><h2>Inputs</h2>{given}</div>" if given else "<div class=top>",
             f"<div><h2>Key results</h2>{figures(cycles)}</div></div>", "<h2>Pictures</h2>", page.pictures_html(pictures)]
    return page.write(os.path.join(folder, "material.html"), inputs.title(inputs.read(folder), "one point of a steel"), parts, [], "")


if __name__ == "__main__":
    sys.exit(page.run_script(__doc__, make_page, sys.argv[1:]))
