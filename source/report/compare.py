#!/usr/bin/python3
"""Draws a run beside the half-space solution and writes one page.

Usage: compare.py FOLDER

FOLDER is the output folder of a run after the command compare: patch.h5 and slices.h5 (last tick), halfspace.h5,
halfspace_slices.h5 and compare.json are read. Pictures go to FOLDER/pictures, the page to FOLDER/compare.html; the
page holds its pictures and views itself and needs no network.
"""

import html
import json
import sys

sys.dont_write_bytecode = True  # the scripts may lie in a folder that is not ours to write to

import cuts
import inputs
import maps
import page
import patch_pictures
import run_data
import style
import subsurface_pictures
import views
from fields import Fields

NAMES = ("Finite elements", "Half-spaces")
COVERED = {"compare_cut_aa", "compare_cut_bb"}
BROAD = {"compare_maps", "compare_subsurface_aa", "compare_subsurface_bb"}


def read_pair(run):
    """The last tick of the run and the half-space solution."""
    ticks = (run.patch, run.data.halfspace[-1])
    for tick, path in zip(ticks, (run.patches.path, run.data.halfspace.path)):
        if not tick["pressure"].max() > 0:
            raise run_data.ReportError(f"There is no loaded contact patch in {path}.")
    return dict(zip(NAMES, ticks))


def draw_all(run, pair):
    fields_of = {name: Fields(tick, margin=4) for name, tick in pair.items()}
    pictures = [("Pressure, shear traction, stick and slip: finite elements above, half-spaces below, one scale each",
                 style.save(run, maps.draw_panels(fields_of, run.sections), "compare_maps"))]
    pictures += patch_pictures.draw_others(run, "compare_")
    pictures += [cuts.draw(run, fields_of, plane, f"compare_cut_{plane.lower()}") for plane in ("AA", "BB")]
    return pictures + subsurface_pictures.draw_all(run, "compare_")


def make_views(run, pair):
    sources = [views.patch_source(name, [tick], [""], run.sections) for name, tick in pair.items()]
    stresses = subsurface_pictures.ticks_of(run)
    return views.patch_views(sources, run.friction, 0) + (views.slice_views(stresses) if len(stresses) > 1 else [])


def difference_of(figure):
    """The difference as a text: as the screen shows it, or of the half-spaces' value in files of earlier versions."""
    if figure.get("difference"):
        return figure["difference"].replace("-", "\u2212") if figure["difference"] != "-" else ""
    difference = figure.get("relative_difference")
    if not page.is_number(difference):
        return ""
    relative_to = figure.get("relative_to", "")
    return page.number(difference, 100, 2) + " %" + (f" of the {relative_to}" if relative_to else "")


def table(figures, title="half-spaces", key="halfspace"):
    rows = ["<div class=wide><table><tr><th></th><th class=number>finite elements</th><th class=number>std</th>"
            f"<th class=number>{title}</th><th>unit</th><th class=number>difference</th><th>limit</th></tr>"]
    for figure in figures:
        def shown(value):
            return page.number(value, figure["factor"], figure["decimals"]) if page.is_number(value) else ""
        limit = figure.get("limit", "").replace(" 1e-3", "\u00b710\u207b\u00b3")
        kind = "" if not limit or not difference_of(figure) else " bad" if figure["beyond"] else " good"
        rows.append(f"<tr><td>{html.escape(figure['label'])}</td><td class=number>{shown(figure['fe'])}</td>"
                    f"<td class=number>{shown(figure['fe_std'])}</td><td class=number>{shown(figure[key])}</td>"
                    f'<td>{page.unit_text(figure)}</td><td class="number{kind}">{difference_of(figure)}</td>'
                    f"<td>{html.escape(limit)}</td></tr>")
    return "\n".join(rows + ["</table></div>"])


def make_parts(run, comparison, pictures, shown):
    pose = (f"Wheel moved by {1e3 * comparison['lateral_offset_m']:.3f} mm to the track centre, rail head turned by "
            f"{1e3 * comparison['rail_roll_rad']:.3f} mrad, wheel rim by {1e3 * comparison['wheel_roll_rad']:.3f} mrad "
            "(from X to Y), as fitted to the end of the run. "
            f"Half-space elements of {1e3 * comparison['element_size_m']:g} mm.")
    rows = inputs.rows(inputs.read(run.folder), run.summary)
    parts = [page.verdict_sentence(run.summary), f"<p class=remark>{html.escape(comparison['sentence'])}</p>",
             "<p>Finite elements against two elastic half-spaces under the same load and in the same position.</p>",
             "<div class=top><div><h2>Inputs</h2>", inputs.table(rows), "</div><div>"]
    parts += [f"<p class=remark>{html.escape(sentence)}</p>" for sentence in run.remarks]
    parts += ["<h2>Key results</h2>", table(comparison["figures"]),
              f"<p>Means of the run over its averaging distance, with their standard deviation. {html.escape(pose)}</p></div></div>"]
    if comparison.get("bodies"):
        parts += ["<h2>Against this wheel and this rail as elastic bodies</h2>",
                  table(comparison["bodies"]["figures"], "true bodies", "bodies"),
                  "<p>Under the same forces, with nothing fitted: what is left is cells, penalty and settling.</p>"]
    if shown:
        parts += ["<h2>Views</h2>", page.views_html(shown)]
    parts += ["<h2>Pictures</h2><p>Last output step of the run. Tractions act on the rail. Maps show the right-hand rail from "
              "above, rolling direction up. G.C.: side of the gauge corner (track centre), F.S.: field side. AA and BB: "
              "the planes along and across the rail through the highest pressure.</p>",
              page.pictures_html(pictures, COVERED if shown else (), BROAD)]
    return parts


def main(arguments):
    if len(arguments) != 1:
        print(__doc__, file=sys.stderr)
        return 1
    try:
        run = run_data.load(arguments[0])
        if run.patch is None:
            raise run_data.ReportError(run.remarks[-1])
        with open(run.data.path("compare.json"), encoding="utf-8") as file:
            comparison = json.load(file)
        run.friction = comparison["friction_coefficient"]
        pair = read_pair(run)
        pictures = draw_all(run, pair)
        script = page.plotly_script()
        if script is None:
            run.remarks.append("Python's plotly is not installed (package python3-plotly); the page shows pictures "
                               "alone.")
        shown = make_views(run, pair) if script else []
        title = (comparison["title"] or run.title) + ": comparison"
        path = page.write(run.data.path("compare.html"), title, make_parts(run, comparison, pictures, shown), shown,
                          script)
    except (run_data.ReportError, OSError, ValueError, KeyError) as error:
        print(error, file=sys.stderr)
        return 1
    print(f"The page is {path}")
    return 0


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))
