#!/usr/bin/python3
"""Draws a run beside the half-space solution and writes one page.

Usage: compare.py FOLDER

FOLDER is the output folder of a run after the command compare: patch.h5 (last tick), halfspace.h5 and
compare.json are read. Pictures go to FOLDER/pictures, the page to FOLDER/compare.html; the page holds its
pictures itself and needs no network.
"""

import html
import json
import os
import sys

sys.dont_write_bytecode = True  # the scripts may lie in a folder that is not ours to write to

import matplotlib.pyplot as plt
import numpy as np

import maps
import page
import patch_pictures
import run_data
import style

NAMES = ("Finite elements", "Half-spaces")


def read_patch(folder, name):
    run = run_data.Run(folder)
    run_data.load_patch(run, "last", name)
    if run.patch is None or not run.patch["pressure"].max() > 0:
        raise run_data.ReportError(f"There is no loaded contact patch in {os.path.join(folder, name)}.")
    return patch_pictures.Fields(run.patch, margin=4)


def draw_pair(run, pair, draw, title, label, name):
    """The same map of both on the same scale."""
    scale = maps.Scale(*pair)
    figure, axes = plt.subplots(1, 2, figsize=(13.4, 5.2), gridspec_kw={"wspace": 0.16})
    for place, fields, who in zip(axes, pair, NAMES):
        image = draw(place, fields, scale, who)
    if image is not None:
        patch_pictures.color_bar(figure, axes[1], image, label)
    if draw is maps.states:
        axes[0].get_legend().remove()
    figure.suptitle(title)
    return title, style.save(run, figure, name)


def draw_cut(run, pair, along, place, title, name):
    """Shear traction, pressure and traction bound of both on a line: along the rail, or across it."""
    figure, axes = plt.subplots(2, 1, figsize=(8.6, 6.4), sharex=True)
    for fields, who, mark, color in zip(pair, NAMES, ("o", ""), (style.BLUE, style.RED)):
        if along:
            pick = (slice(None), np.argmin(np.abs(fields.lateral[0] - place)))
            x = fields.along[pick]
        else:
            pick = (np.argmin(np.abs(fields.along[:, 0] - place)), slice(None))
            x = fields.lateral[pick]
        options = dict(color=color, marker=mark, markersize=3.5, linewidth=1.4)
        axes[0].plot(x, fields.pressure[pick], label=who, **options)
        axes[1].plot(x, fields.shear[pick], label=f"shear traction, {who.lower()}", **options)
        if run.friction is not None:
            axes[1].plot(x, run.friction * fields.pressure[pick], color=color, linewidth=1.0, linestyle="--",
                         label=f"traction bound $\\mu p$, {who.lower()}")
    axes[0].set_ylabel("pressure [MPa]")
    axes[1].set_ylabel("traction [MPa]")
    for part in axes:
        part.grid(True)
        part.set_ylim(0, None)
        part.legend(loc="upper left", bbox_to_anchor=(1.01, 1), borderaxespad=0)
    if along:
        axes[1].set_xlabel("rolling direction [mm]   (leading edge on the right)")
    else:
        axes[0].invert_xaxis()  # shared; s to the left, as in the maps
        axes[1].set_xlabel("lateral $s$ [mm]   (G.C. on the left, F.S. on the right)")
    axes[0].set_title(title)
    return title, style.save(run, figure, name)


def draw_all(run, pair):
    peak = np.unravel_index(np.argmax(pair[0].pressure), pair[0].pressure.shape)
    lateral = pair[0].lateral[peak]
    middle = 0.5 * sum(pair[0].along[pair[0].loaded][[0, -1]])  # between leading and trailing edge
    return [
        draw_pair(run, pair, maps.pressure, "Pressure", "pressure [MPa]", "compare_pressure"),
        draw_pair(run, pair, maps.shear, "Shear traction on the rail", "shear traction [MPa]", "compare_shear"),
        draw_pair(run, pair, maps.states, "Stick and slip", "", "compare_states"),
        draw_cut(run, pair, True, lateral, f"Cut AA: along the rail through the peak, $s$ = {lateral:.2f} mm",
                 "compare_cut_aa"),
        draw_cut(run, pair, False, middle, f"Cut BB: across the rail, {middle:.2f} mm ahead of the axle",
                 "compare_cut_bb"),
    ]


def table(figures):
    rows = ["<table><tr><th></th><th>finite elements</th><th>std</th><th>half-spaces</th><th>difference</th><th></th></tr>"]
    for figure in figures:
        def shown(value):
            return page.number(value, figure["factor"], figure["decimals"]) if page.is_number(value) else ""
        difference = figure["relative_difference"]
        percent = page.number(difference, 100, 2) + " %" if page.is_number(difference) else ""
        rows.append(f"<tr><td>{html.escape(figure['label'])}</td><td class=number>{shown(figure['fe'])}</td>"
                    f"<td class=number>{shown(figure['fe_std'])}</td><td class=number>{shown(figure['halfspace'])}</td>"
                    f"<td class=number>{percent}</td><td>{page.unit_text(figure)}</td></tr>")
    return "\n".join(rows + ["</table>"])


def write(run, comparison, pictures):
    """Writes compare.html as a whole (temporary file, rename); returns its path."""
    title = html.escape(comparison["title"] or run.title)
    pose = (f"Wheel moved by {1e3 * comparison['lateral_offset_m']:.3f} mm to the track centre, rail head turned by "
            f"{1e3 * comparison['rail_roll_rad']:.3f} mrad, wheel rim by {1e3 * comparison['wheel_roll_rad']:.3f} mrad "
            "(from X to Y), as fitted to the end of the run. "
            f"Half-space elements of {1e3 * comparison['element_size_m']:g} mm.")
    parts = ["<!DOCTYPE html>", '<html lang="en"><head><meta charset="utf-8">',
             f"<title>{title}: comparison</title><style>{page.STYLE}</style></head><body>",
             f"<h1>{title}</h1><p>Finite elements against two elastic half-spaces under the same load.</p>",
             f"<p class=remark>{html.escape(comparison['sentence'])}</p>",
             "<h2>Figures</h2><p>Means of the run over its averaging distance, with their standard deviation.</p>",
             table(comparison["figures"]), f"<p>{html.escape(pose)}</p>",
             "<h2>Pictures</h2><p>Last tick of the run. Tractions act on the rail. G.C.: side of the gauge corner "
             "(track centre), F.S.: field side.</p>",
             "<div class=pictures>", *[page.picture(*item) for item in pictures], "</div></body></html>"]
    path = os.path.join(run.folder, "compare.html")
    with open(path + ".part", "w", encoding="utf-8") as file:
        file.write("\n".join(parts))
    os.replace(path + ".part", path)
    return path


def main(arguments):
    if len(arguments) != 1:
        print(__doc__, file=sys.stderr)
        return 1
    try:
        run = run_data.Run(arguments[0])
        with open(os.path.join(run.folder, "compare.json"), encoding="utf-8") as file:
            comparison = json.load(file)
        run.friction = comparison["friction_coefficient"]
        os.makedirs(run.pictures_folder, exist_ok=True)
        pair = [read_patch(run.folder, "patch.h5"), read_patch(run.folder, "halfspace.h5")]
        path = write(run, comparison, draw_all(run, pair))
    except (run_data.ReportError, OSError, ValueError, KeyError) as error:
        print(error, file=sys.stderr)
        return 1
    print(f"The page is {path}")
    return 0


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))
