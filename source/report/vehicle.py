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
import inputs
import page
import sections
import style
import views

#: what a picture shows: title, (key, factor), unit
PICTURES = [
    ("Motion", [("given_lateral_shift_m", 1e3, "lateral shift [mm]"), ("given_yaw_rad", 1e3, "yaw [mrad]"),
                ("given_load_N", 1e-3, "load [kN]"), ("given_load_right_N", 1e-3, "load, right [kN]"),
                ("given_load_left_N", 1e-3, "load, left [kN]"), ("given_radius_m", 1, "radius [m], 0: straight")]),
    ("Forces on the wheel", [("longitudinal_force_N", 1e-3, "longitudinal force [kN]"), ("lateral_force_N", 1e-3, "lateral force [kN]"),
                             ("vertical_force_N", 1e-3, "vertical force [kN]"),
                             ("lateral_over_vertical", 1, "lateral / vertical, Y/Q")]),
    ("Axle with both wheels", [("axle_lateral_force_N", 1e-3, "sum of lateral forces [kN]"),
                               ("axle_yaw_moment_Nm", 1e-3, "steering moment [kN m]")]),
    ("Creepages and spin", [("reference_creepage", 1e3, "longitudinal creepage, reference point [10\u207b\u00b3]"),
                            ("reference_lateral_creepage", 1e3, "lateral creepage, reference point [10\u207b\u00b3]"),
                            ("reference_spin_per_m", 1, "spin [1/m]")]),
    ("Patch", [("max_pressure_Pa", 1e-6, "peak pressure [MPa]"), ("contact_area_m2", 1e6, "contact area [mm\u00b2]"),
               ("reference_lateral_m", 1e3, "place on the rail [mm]")]),
    ("Wear", [("t_gamma_N", 1, "wear number T-gamma [N]"), ("stick_fraction", 100, "sticking part [%]")]),
]
#: how the wheels are drawn: colour, whether dashed, name
SIDES = {"right_": (style.BLUE, False, "right wheel"), "left_": (style.RED, True, "left wheel"), "": (style.BLUE, False, "")}
WORST = [("lateral_over_vertical", 1, "Y/Q", "", 3), ("max_pressure_Pa", 1e-6, "peak pressure", "MPa", 1),
         ("t_gamma_N", 1, "wear number T-gamma", "N", 1), ("largest_von_mises_Pa", 1e-6, "von Mises stress", "MPa", 1)]


def draw(table, x, label, title, rows, path):
    sides = [side for side in ("right_", "left_", "") if any(side + key in table for key, _, _ in rows)]
    rows = [row for row in rows if any(side + row[0] in table for side in sides)]
    if not rows:
        return None
    figure, all_axes = plt.subplots(len(rows), 1, figsize=(8, 1 + 1.7 * len(rows)), sharex=True, squeeze=False)
    for axes, (key, factor, text) in zip(all_axes[:, 0], rows):
        for side in sides:
            if side + key in table:
                color, dash, name = SIDES[side]
                axes.plot(x, factor * table[side + key], color=color, linewidth=1.1, label=name,
                          linestyle=(0, (5, 2)) if dash else "-")
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
BAND = [("max_pressure_Pa", 1e-6, "peak pressure [MPa]"), ("t_gamma_N", 1, "wear number T-gamma [N]")]


def on_heads(table, side, key, where):
    """Largest value of a result over all rows at each place of the outline of a head; nan where no patch lies."""
    place, half = 1e3 * table[side + "reference_lateral_m"], 0.5e3 * table[side + "patch_lateral_m"]
    angle = table[side + "reference_angle_rad"] if side + "reference_angle_rad" in table else np.zeros_like(place)
    values, x = table[side + key], where[:, 0]
    largest = np.full(len(x), np.nan)
    for p, h, a, value in zip(place, half, angle, values):
        if np.isfinite(p) and np.isfinite(h) and np.isfinite(value):
            reach = max(h * np.cos(a if np.isfinite(a) else 0), 0.1)
            inside = np.abs(x - p) <= reach
            largest[inside] = np.fmax(largest[inside], value)
    return largest


def draw_heads(table, folder, path):
    """The running band on the heads of both rails, the gauge side on the left: coloured by what its places bear."""
    heads = {side: sections.load(folder, f"sections_{side.strip('_')}.json") for side in ("right_", "left_")}
    heads = {side: head for side, head in heads.items() if head is not None and side + "patch_lateral_m" in table}
    if not heads:
        return None
    figure, all_axes = plt.subplots(len(BAND), len(heads), figsize=(7 * len(heads), 7.4), squeeze=False,
                                    constrained_layout=True)
    for row, (key, factor, text) in zip(all_axes, BAND):
        bands = {}
        for side, head in heads.items():
            fine = head.at_x(np.linspace(head.rail[:, 0].min() + 0.05, head.rail[:, 0].max() - 0.05, 600))
            bands[side] = fine, factor * on_heads(table, side, key, fine)
        known = np.concatenate([values[np.isfinite(values)] for _, values in bands.values()])
        if not len(known):
            plt.close(figure)
            return None
        for axes, (side, head) in zip(row, heads.items()):
            sections.draw_head(axes, head, with_wheel=False)
            fine, values = bands[side]
            pieces = np.stack([fine[:-1], fine[1:]], axis=1)[np.isfinite(values[:-1])]
            lines = LineCollection(pieces, array=values[:-1][np.isfinite(values[:-1])], cmap=style.HIGH, linewidths=7,
                                   capstyle="butt", zorder=3)
            lines.set_clim(known.min(), known.max())
            axes.add_collection(lines)
            axes.set_title(f"{side.strip('_')}-hand rail, largest {text.split(' [')[0]}", pad=22)
        figure.colorbar(lines, ax=row, label=text)
    figure.savefig(path)
    plt.close(figure)
    return ("Running band on the heads: the places that patches touch, coloured by the largest value there", path)


def make_views(table, x, label):
    """The curves one below the other over one axis, right and left told apart."""
    rows = []
    for _, of_picture in PICTURES:
        for key, factor, text in of_picture:
            curves = []
            for side, (_, dash, name) in SIDES.items():
                if side + key in table and np.isfinite(table[side + key]).any():
                    curves.append({"name": name, "y": views.plain(factor * table[side + key], 5), "color": 1 if dash else 0 if name else 5,
                                   **({"dash": "dash"} if dash else {})})
            if curves:
                rows.append({"label": text, "curves": curves})
    if not rows or len(x) < 2:
        return []
    return [{"id": "view-rows", "type": "stack", "title": "Over the rows", "x": views.plain(x), "abscissa": label, "rows": rows}]


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
                                  array=value[there], cmap=style.HIGH, linewidths=max(width, 0.8), capstyle="butt")
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


def worst_rows(table, x, label, most):
    lines = ["<table><tr><th>wheel</th><th>by</th><th class=number>row</th>"
             f"<th class=number>{html.escape(label)}</th><th class=number>value</th><th></th></tr>"]
    for side in ("right_", "left_"):
        for key, factor, text, unit, decimals in WORST:
            values = table.get(side + key)
            if values is None or not np.isfinite(values).any():
                continue
            for row in np.argsort(-np.nan_to_num(values, nan=-np.inf), kind="stable")[:most]:
                if np.isfinite(values[row]):
                    lines.append(f"<tr><td>{side.strip('_')}</td><td>{text}</td><td class=number>{row + 1}</td>"
                                 f"<td class=number>{x[row]:g}</td><td class=number>{page.number(values[row], factor, decimals)}</td>"
                                 f"<td>{unit}</td></tr>")
    return "\n".join(lines) + "</table>"


def make_page(folder):
    table = columns.read(os.path.join(folder, "vehicle.csv"))
    given = "given_distance_m" if "given_distance_m" in table else "given_time_s"
    label = "distance [m]" if given == "given_distance_m" else "time [s]"
    drawn = os.path.join(folder, "pictures")
    os.makedirs(drawn, exist_ok=True)
    curves = [draw(table, table[given], label, title, rows, os.path.join(drawn, title.split()[0].lower() + ".png"))
              for title, rows in PICTURES]
    bands = [draw_heads(table, folder, os.path.join(drawn, "heads.png")),
             draw_band(table, table[given], label, os.path.join(drawn, "band.png"))]
    script = page.plotly_script()
    shown = make_views(table, table[given], label) if script else []
    # what the rows tell is not that of the scene
    told = {"wheelset", "wheel load"} | {label for key, label in (("given_velocity_m_per_s", "speed"), ("given_radius_m", "curve"))
                                         if key in table}
    entries = [row for row in inputs.rows(inputs.read(folder), of=inputs.HALF) if row[0] not in told]
    entries.append(("rows", f"{len(table[given])}, {label.split(' [')[0]} {table[given][0]:g} to {table[given][-1]:g}"))
    parts = [*verdicts(table), "<div class=top><div><h2>Inputs</h2>", inputs.table(entries), "</div><div><h2>Key results: worst rows</h2>",
             worst_rows(table, table[given], label, 1), "</div></div>"]
    for title, pictures in (("Where on the rails", bands), ("Curves", curves)):
        pictures = [picture for picture in pictures if picture]
        covered = [os.path.basename(path)[:-4] for _, path in pictures] if shown and pictures and title == "Curves" else ()
        if pictures:
            parts += [f"<h2>{title}</h2>", page.views_html(shown) if covered else "",
                      page.pictures_html(pictures, covered, broad=("band", "heads"))]
    parts += ["<h2>Worst rows</h2>", worst_rows(table, table[given], label, 5)]
    return page.write(os.path.join(folder, "vehicle.html"), inputs.title(inputs.read(folder), "rows of a vehicle"), parts, shown, script)


if __name__ == "__main__":
    sys.exit(page.run_script(__doc__, make_page, sys.argv[1:]))
