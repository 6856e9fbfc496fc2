#!/usr/bin/python3
"""Makes the page of a file of the program CONTACT: its cases and patches, their peak pressures and forces, maps of pressure.

Usage: contact_file.py FOLDER

FOLDER holds summary.json, wheel_rail.csv, patches.csv and bodies.csv (module 1), cases.csv (module 3) and case_K.h5 of the command
contact; contact.html goes there with pictures/cases.png and pictures/pressures.png.
"""

import html
import json
import os
import sys

sys.dont_write_bytecode = True  # the scripts may lie in a folder that is not ours to write to

import h5py
import numpy as np

import columns
import page
import style

plt = style.plt

MOST_MAPS, MOST_ROWS = 12, 400

#: column of a table, factor, label, digits
COLUMNS = [("case", 1, "case", 0), ("patch", 1, "patch", 0), ("y_track_m", 1e3, "y [mm]", 3),
           ("contact_angle_rad", 1e3, "angle [mrad]", 2), ("normal_force_N", 1, "FN [N]", 1),
           ("longitudinal_force_N", 1, "FX [N]", 1), ("tangential_lateral_force_N", 1, "FS, FY [N]", 1),
           ("approach_m", 1e3, "approach [mm]", 5), ("max_pressure_Pa", 1e-6, "peak pressure [MPa]", 1),
           ("creepage", 1e2, "CKSI [%]", 4), ("lateral_creepage", 1e2, "CETA [%]", 4),
           ("area_of_whole_elements_m2", 1e6, "area [mm2]", 2), ("stick_fraction", 1e2, "stick [%]", 1),
           ("max_temperature_C", 1, "hottest [\u00b0C]", 1),
           ("relative_difference_max_pressure", 1e2, "peak beside half-spaces [%]", 1)]


def patch_tables(folder):
    """Tables of the patches of module 1 and of the cases of module 3, as far as they are there."""
    for name, title in (("patches.csv", "Wheel and rail: patches"), ("cases.csv", "Basic contact: cases")):
        path = os.path.join(folder, name)
        if os.path.exists(path):
            yield title, without_rounding(columns.read(path))


def digits_of(values, digits):
    """As many that the largest value of a column has four, for units in a file may be others than of steel."""
    largest = np.nanmax(np.abs(values))
    return digits if digits == 0 or largest == 0 else max(digits, min(9, 3 - int(np.floor(np.log10(largest)))))


def without_rounding(table):
    """Tangential forces and creepages that are zero but for rounding, as zero."""
    force = np.abs(table["normal_force_N"])
    limits = {"longitudinal_force_N": 1e-7 * force, "tangential_lateral_force_N": 1e-7 * force,
              "creepage": 1e-9, "lateral_creepage": 1e-9}
    return {key: np.where(np.abs(values) < limits[key], 0, values) if key in limits else values for key, values in table.items()}


def rows_of(table):
    shown = [(key, factor, label, digits_of(factor * table[key], digits)) for key, factor, label, digits in COLUMNS
             if key in table and np.isfinite(table[key]).any()]
    rows = ["<tr>" + "".join(f"<th class=number>{html.escape(page.printed_header(label))}</th>" for _, _, label, _ in shown) + "</tr>"]
    for k in range(min(MOST_ROWS, len(table["case"]))):
        cells = (page.number(table[key][k], factor, digits) if np.isfinite(table[key][k]) else ""
                 for key, factor, _, digits in shown)
        rows.append("<tr>" + "".join(f"<td class=number>{cell}</td>" for cell in cells) + "</tr>")
    more = len(table["case"]) - MOST_ROWS
    return "<div class=wide><table>" + "\n".join(rows) + "</table></div>" + \
        (f"<p>{more} more rows stand in the table.</p>" if more > 0 else "")


def draw_cases(tables, path):
    """Peak pressure and normal force over the cases; of one there is nothing to see."""
    if max((len(table["case"]) for _, table in tables), default=0) < 2:
        return None
    figure, (upper, lower) = plt.subplots(2, 1, figsize=(7.6, 6), sharex=True)
    for (title, table), color in zip(tables, (style.BLUE, style.RED)):
        label = title.split(":")[0]
        upper.plot(table["case"], 1e-6 * table["max_pressure_Pa"], ".", color=color, label=label)
        lower.plot(table["case"], 1e-3 * table["normal_force_N"], ".", color=color, label=label)
    upper.set_ylabel("peak pressure [MPa]")
    lower.set_ylabel("normal force [kN]")
    lower.set_xlabel("case")
    lower.xaxis.get_major_locator().set_params(integer=True)
    for axes in (upper, lower):
        axes.set_ylim(0, 1.1 * axes.get_ylim()[1])
        axes.grid(True)
        axes.legend()
    figure.tight_layout()
    figure.savefig(path)
    plt.close(figure)
    return "Cases", path


def maps(folder, tables):
    """Case, patch and fields of some contacts, spread over the file."""
    rows = sorted((int(table["case"][k]), int(table["patch"][k]) if "patch" in table else 1)
                  for _, table in tables for k in np.flatnonzero(table["max_pressure_Pa"] > 0))
    for case, patch in (rows[k] for k in np.unique(np.linspace(0, len(rows) - 1, min(MOST_MAPS, len(rows))).round().astype(int))):
        with h5py.File(os.path.join(folder, f"case_{case}.h5"), "r") as file:
            fields = file[f"tick_{patch - 1:04d}"]
            if fields["pressure"].size > 1:
                yield case, patch, {name: fields[name][()] for name in ("along", "lateral", "pressure", "state")}


def draw_pressures(folder, tables, path):
    """Pressures from above, rolling direction to the right, with the border of adhesion."""
    shown = list(maps(folder, tables))
    if not shown:
        return None
    across = min(4, len(shown))
    figure, all_axes = plt.subplots(-(-len(shown) // across), across, figsize=(1 + 3.6 * across, 0.4 + 3 * -(-len(shown) // across)),
                                    squeeze=False, constrained_layout=True)
    for axes in all_axes.flat[len(shown):]:
        axes.set_visible(False)
    for axes, (case, patch, fields) in zip(all_axes.flat, shown):
        x, y, pressure = 1e3 * fields["along"], 1e3 * fields["lateral"], 1e-6 * fields["pressure"]
        axes.set_title(f"case {case}, patch {patch}")
        axes.set_xlabel("along the track [mm]")
        if min(pressure.shape) == 1:  # two cylinders
            axes.plot(x if len(x) > 1 else y, pressure.ravel())
            axes.set_ylabel("pressure [MPa]")
            continue
        picture = axes.pcolormesh(x, y, np.where(pressure > 0, pressure, np.nan), cmap=style.HIGH, shading="nearest")
        figure.colorbar(picture, ax=axes, label="pressure [MPa]")
        stick = fields["state"] == 1
        if stick.any() and not stick.all():
            axes.contour(x, y, stick.astype(float), levels=[0.5], colors="white", linewidths=0.9)
        touches = pressure > 0
        axes.set_xlim(x[touches].min() - 1, x[touches].max() + 1)
        axes.set_ylim(y[touches].min() - 1, y[touches].max() + 1)
        axes.set_aspect("equal", adjustable="datalim")
    for axes in all_axes[:, 0]:
        axes.set_ylabel(axes.get_ylabel() or "across [mm]")
    figure.savefig(path)
    plt.close(figure)
    return ("Pressures" if len(shown) < MOST_MAPS else f"Pressures of {MOST_MAPS} contacts") + "; white: border of adhesion", path


def make_page(folder):
    with open(os.path.join(folder, "summary.json"), encoding="utf-8") as file:
        summary = json.load(file)
    tables = list(patch_tables(folder))
    pictures_folder = os.path.join(folder, "pictures")
    os.makedirs(pictures_folder, exist_ok=True)
    pictures = [picture for picture in (draw_cases(tables, os.path.join(pictures_folder, "cases.png")),
                                        draw_pressures(folder, tables, os.path.join(pictures_folder, "pressures.png"))) if picture]
    refused = int(summary["cases_refused"])
    parts = [page.verdict_sentence(summary),
             f"<p>{int(summary['cases_solved'])} of {int(summary['cases'])} cases are solved, as half-spaces"
             f"{f'; {refused} are not computed' if refused else ''}. Forces act on the rail, or on body 1; axes and signs are "
             "CONTACT's.</p>",
             *(["<h2>Pictures</h2>", page.pictures_html(pictures, broad=("pressures",))] if pictures else [])]
    for title, table in tables:
        parts += [f"<h2>{html.escape(title)}</h2>", rows_of(table)]
    bodies = os.path.join(folder, "bodies.csv")
    if os.path.exists(bodies):
        parts += ["<h2>Wheel and rail: true bodies</h2>", rows_of(columns.read(bodies))]
    return page.write(os.path.join(folder, "contact.html"), str(summary.get("title") or "contact"), parts, [], "")


if __name__ == "__main__":
    sys.exit(page.run_script(__doc__, make_page, sys.argv[1:]))
