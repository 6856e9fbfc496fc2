#!/usr/bin/python3
"""Makes the page of the command vehicle: curves over distance or time, the worst rows.

Usage: vehicle.py FOLDER

FOLDER holds vehicle.csv; the page is FOLDER/vehicle.html, its pictures are in FOLDER/pictures.
"""

import html
import os
import sys

sys.dont_write_bytecode = True  # the scripts may lie in a folder that is not ours to write to

import matplotlib.pyplot as plt
import numpy as np
from matplotlib.collections import LineCollection

import columns
import page
import style

#: figures of a picture: title, (key, factor), unit
PICTURES = [
    ("Motion", [("given_lateral_shift_m", 1e3, "lateral shift [mm]"), ("given_yaw_rad", 1e3, "yaw [mrad]"),
                ("given_load_N", 1e-3, "load [kN]"), ("given_load_right_N", 1e-3, "load, right [kN]"),
                ("given_load_left_N", 1e-3, "load, left [kN]"), ("given_radius_m", 1, "radius [m], 0: straight")]),
    ("Forces on the wheel", [("longitudinal_force_N", 1e-3, "longitudinal [kN]"), ("lateral_force_N", 1e-3, "lateral [kN]"),
                             ("vertical_force_N", 1e-3, "vertical [kN]"),
                             ("lateral_over_vertical", 1, "lateral / vertical, Y/Q")]),
    ("Axle with both wheels", [("axle_lateral_force_N", 1e-3, "lateral, sum [kN]"),
                               ("axle_yaw_moment_Nm", 1e-3, "steering moment [kN m]")]),
    ("Creepages and spin", [("reference_creepage", 1e3, "creepage [1e-3]"),
                            ("reference_lateral_creepage", 1e3, "lateral [1e-3]"),
                            ("reference_spin_per_m", 1, "spin [1/m]")]),
    ("Patch", [("max_pressure_Pa", 1e-6, "peak pressure [MPa]"), ("contact_area_m2", 1e6, "area [mm2]"),
               ("reference_lateral_m", 1e3, "place on the rail [mm]")]),
    ("Wear", [("t_gamma_N", 1, "T-gamma [N]"), ("stick_fraction", 100, "stick [%]")]),
]
WORST = [("max_pressure_Pa", 1e-6, "peak pressure", "MPa"), ("t_gamma_N", 1, "T-gamma", "N"),
         ("largest_von_mises_Pa", 1e-6, "von Mises stress", "MPa")]


def draw(table, x, label, title, rows, path):
    sides = [side for side in ("right_", "left_", "") if any(side + key in table for key, _, _ in rows)]
    rows = [row for row in rows if any(side + row[0] in table for side in sides)]
    if not rows:
        return None
    figure, all_axes = plt.subplots(len(rows), 1, figsize=(8, 1 + 1.7 * len(rows)), sharex=True, squeeze=False)
    for axes, (key, factor, text) in zip(all_axes[:, 0], rows):
        for side, color in zip(sides, (style.BLUE, style.RED)):
            if side + key in table:
                axes.plot(x, factor * table[side + key], color=color, linewidth=1, label=side.strip("_"))
        axes.set_ylabel(text)
        axes.grid(True)
        axes.margins(x=0)
    if sides != [""]:
        all_axes[0, 0].legend(loc="best")
    all_axes[0, 0].set_title(title)
    all_axes[-1, 0].set_xlabel(label)
    figure.tight_layout()
    figure.savefig(path)
    plt.close(figure)
    return title, path


#: what colours the running band: key, factor, text
BAND = [("max_pressure_Pa", 1e-6, "peak pressure [MPa]"), ("t_gamma_N", 1, "T-gamma [N]")]


def draw_band(table, x, label, path):
    """Where on the heads the wheels run: for each row the width of its patch, coloured by pressure and by T-gamma."""
    sides = [side for side in ("right_", "left_") if side + "reference_lateral_m" in table]
    if not sides or len(x) < 2:
        return None
    figure, all_axes = plt.subplots(len(BAND), len(sides), figsize=(6 * len(sides), 6), sharex=True, sharey=True,
                                    squeeze=False, constrained_layout=True)
    # bars that touch each other on the page, where rows are evenly spaced
    width = 1.1 * 72 * 5.0 * np.median(np.diff(x)) / (x[-1] - x[0])
    for row, (key, factor, text) in zip(all_axes, BAND):
        known = np.concatenate([factor * table[side + key] for side in sides])
        known = known[np.isfinite(known)]
        for axes, side in zip(row, sides):
            place, half, value = (1e3 * table[side + "reference_lateral_m"], 0.5e3 * table[side + "patch_lateral_m"],
                                  factor * table[side + key])
            there = np.isfinite(place) & np.isfinite(half) & np.isfinite(value)
            bars = LineCollection([[(at, p - h), (at, p + h)] for at, p, h in zip(x[there], place[there], half[there])],
                                  array=value[there], cmap="viridis", linewidths=max(width, 0.8), capstyle="butt")
            if len(known):
                bars.set_clim(known.min(), known.max())
            axes.add_collection(bars)
            axes.plot(x[there], place[there], color="black", linewidth=0.6)
            axes.autoscale()
            axes.set_xlim(x[0], x[-1])
            axes.grid(True)
            for height, side_of, align in ((0.98, "\N{UPWARDS ARROW} gauge side", "top"),
                                           (0.02, "\N{DOWNWARDS ARROW} field side", "bottom")):
                axes.text(0.01, height, side_of, transform=axes.transAxes, va=align, color=style.GREY, fontsize=8)
        figure.colorbar(bars, ax=row, label=text)
        row[0].set_ylabel("place on the head [mm]")
    for axes, side in zip(all_axes[0], sides):
        axes.set_title(f"{side.strip('_')}-hand rail")
    for axes in all_axes[-1]:
        axes.set_xlabel(label)
    figure.savefig(path)
    plt.close(figure)
    return "Running band: width and place of the patches on the heads, from the running circle to the track centre", path


def verdicts(table):
    """How many rows have which verdict, a sentence for each wheel."""
    return [sentence for side in ("right", "left")
            for sentence in page.verdict_counts(table.get(side + "_verdict"), f"rows of the {side} wheel")]


def worst_rows(table, x, label):
    lines = ["<table><tr><th>wheel</th><th>by</th><th class=number>row</th>"
             f"<th class=number>{html.escape(label)}</th><th class=number>value</th><th></th></tr>"]
    for side in ("right_", "left_"):
        for key, factor, text, unit in WORST:
            values = table.get(side + key)
            if values is None or not np.isfinite(values).any():
                continue
            for row in np.argsort(-np.nan_to_num(values, nan=-np.inf))[:5]:
                if np.isfinite(values[row]):
                    lines.append(f"<tr><td>{side.strip('_')}</td><td>{text}</td><td class=number>{row + 1}</td>"
                                 f"<td class=number>{x[row]:g}</td><td class=number>{factor * values[row]:.1f}</td>"
                                 f"<td>{unit}</td></tr>")
    return "\n".join(lines) + "</table>"


def make_page(folder):
    table = columns.read(os.path.join(folder, "vehicle.csv"))
    given = "given_distance_m" if "given_distance_m" in table else "given_time_s"
    label = "distance [m]" if given == "given_distance_m" else "time [s]"
    os.makedirs(os.path.join(folder, "pictures"), exist_ok=True)
    pictures = []
    for title, rows in PICTURES:
        path = os.path.join(folder, "pictures", title.split()[0].lower() + ".png")
        pictures.append(draw(table, table[given], label, title, rows, path))
    pictures.insert(1, draw_band(table, table[given], label, os.path.join(folder, "pictures", "band.png")))
    parts = [*verdicts(table), f"<p>{len(table[given])} rows.</p>", "<h2>Worst rows</h2>", worst_rows(table, table[given], label),
             "<h2>Curves</h2>", page.pictures_html([picture for picture in pictures if picture], broad=("band",))]
    return page.write(os.path.join(folder, "vehicle.html"), "Wheelset of a vehicle", parts, [], "")


if __name__ == "__main__":
    sys.exit(page.run_script(__doc__, make_page, sys.argv[1:]))
