#!/usr/bin/python3
"""Draws the pictures of one run and writes its page.

Usage: report.py FOLDER [--tick last|NUMBER[,NUMBER...]] [--csv] [--each]

FOLDER is the output folder of a run, of passages or of the command halfspace. The pictures go to FOLDER/pictures, the page to
FOLDER/report.html; the page holds its pictures, the numbers of its interactive views and what draws them, and needs
no network. Passages have one page; --each makes that of each passage, too. With several ticks the shear traction at all of them is drawn, everything else at the last. What a file
that is missing would have given is left out, and a sentence says so.
Exit code 0 when there was something to report, 1 otherwise.
"""

import argparse
import concurrent.futures
import html
import os
import sys

sys.dont_write_bytecode = True  # the scripts may lie in a folder that is not ours to write to

import body_pictures
import contact_file
import history_pictures
import inputs
import irregular_pictures
import material
import page
import passages
import patch_pictures
import plastic_pictures
import receptance
import run_data
import subsurface_pictures
import tables
import vehicle
import views
import wear_evolution
import wear_pictures
import wheelset

# pictures that an interactive view stands for on the screen
COVERED = {"pressure_surface", "shear_surface", "pressure_contour", "shear_contour", "cut_aa", "cut_bb", "forces",
           "energy_error", "creepage"}
# what the other commands leave, and who makes their pages
PAGES = {"vehicle.csv": vehicle, "wear.json": wear_evolution, "receptance.csv": receptance,
         "cycles.csv": material, "wheel_rail.csv": contact_file, "cases.csv": contact_file}
BROAD = {"sheet", "shear_instants"}
MEANS = ("nodes at that instant; the results above are means over the averaging distance, with their standard deviation "
         "(\u00b1) and the standard error of the mean (mean \u00b1)")


def parse_arguments(arguments):
    parser = argparse.ArgumentParser(prog="report", description="Pictures and one page of an output folder.")
    parser.add_argument("folder", help="output folder of a run, or of another command")
    parser.add_argument("--tick",
                        help="output step to draw: a number, or last (the usual one; over irregular surfaces the one nearest "
                             "to the largest force); several with commas also draw the shear at each")
    parser.add_argument("--csv", action="store_true", help="also write histories, maps and sections as tables into FOLDER/csv")
    parser.add_argument("--each", action="store_true", help="also make the page of each passage")
    return parser.parse_args(arguments)


def make_views(run):
    """The interactive views of a run."""
    shown = []
    if run.patch is not None:
        ticks, names = list(run.patches), run.patches.names
        labels = views.tick_labels(ticks, names)
        start = sum(views.is_shown(tick) for tick in ticks[:names.index(f"tick_{run.tick:04d}")])
        shown += views.patch_views([views.patch_source("", ticks, labels, run.sections)], run.friction, start, run.peaks)
        stresses = subsurface_pictures.ticks_of(run)
        if stresses:
            shown += views.slice_views(stresses)
    if run.history:
        shown += views.curve_views(run, {**history_pictures.groups(run), **irregular_pictures.groups(run)})
    return shown


def make_parts(run, pictures, shown):
    """What stands in the page, piece by piece."""
    entries = inputs.rows(inputs.read(run.folder), run.summary, inputs.HALF if run.is_halfspace else inputs.FINITE)
    parts = []
    if run.summary is not None:
        parts += page.top(run.summary, run.figures, inputs.table(entries))
    parts += [f"<p class=remark>{html.escape(sentence)}</p>" for sentence in run.remarks]
    if run.patch is not None:
        attributes = run.patch.attributes
        place = "" if run.is_halfspace else (f" Output step {run.tick}: {1e3 * attributes['time_s']:.3f} ms, "
                                             f"{1e3 * attributes['rolled_distance_m']:.2f} mm rolled.")
        parts.append("<p>Tractions act on the rail. Maps show the right-hand rail from above, rolling direction up. "
                     "G.C.: side of the gauge corner (track centre), F.S.: field side. AA and BB: the planes along and "
                     f"across the rail through the highest pressure.{place} Maps and cuts show "
                     f"{'elements; the results above are those of the solution' if run.is_halfspace else MEANS}.</p>")
    if shown:
        parts += [page.views_html(shown)]
    if pictures:
        parts += ["<h2>Pictures</h2>", page.pictures_html(pictures, COVERED if shown else (), BROAD)]
    if run.summary is not None:
        others = [figure for figure in run.figures if figure["key"] not in page.KEY_RESULTS]
        if others:
            parts += ["<h2>Further results</h2>", page.table(page.figure_rows(run.summary, others))]
        further = page.further_rows(run.summary, run.figures)
        if further:
            parts += ["<h2>Further values of summary.json, in SI units</h2>", page.table(further)]
    return parts


def make_report(run):
    """Draws everything; returns the number of pictures and the path of the page."""
    pictures = (irregular_pictures.draw_all(run) + patch_pictures.draw_all(run) + subsurface_pictures.draw_all(run) +
                body_pictures.draw_all(run) + plastic_pictures.draw_all(run) + wear_pictures.draw_all(run) +
                history_pictures.draw_all(run))
    script = page.plotly_script()
    if script is None:
        run.remarks.append("Python's plotly is not installed (package python3-plotly); the page shows pictures alone.")
    shown = make_views(run) if script else []
    return len(pictures), page.write(run.data.path("report.html"), run.title, make_parts(run, pictures, shown), shown,
                                     script)


def report_wheelset(folder, csv):
    """The pages of both wheels, and that of the wheelset."""
    for side in ("left", "right"):
        if os.path.isdir(os.path.join(folder, side)):
            run = run_data.load(os.path.join(folder, side))
            count, path = make_report(run)
            if csv:
                print(f"{len(tables.write_all(run))} tables in {os.path.join(run.folder, 'csv')}")
            print(f"{count} pictures, the page of the {side}-hand wheel is {path}")
    print(f"The page of the wheelset is {wheelset.make_page(folder)}")
    return 0


def make_passage(folder):
    """The page of one passage, in a process of its own."""
    count, path = make_report(run_data.load(folder))
    return f"{count} pictures, the page of the passage is {path}"


def report_passages(folder, each):
    """The page of all passages; with `each` before it those of single passages that have none newer than their results."""
    due = [path for path in passages.folders(folder).values() if not passages.has_page(path)] if each else []
    with concurrent.futures.ProcessPoolExecutor(max_workers=min(4, os.cpu_count() or 1)) as pool:
        for said in pool.map(make_passage, due):
            print(said, flush=True)
    return passages.make_report(folder)


def main(arguments):
    options = parse_arguments(arguments)
    try:
        if os.path.exists(os.path.join(options.folder, "wheelset.csv")):
            return report_wheelset(options.folder, options.csv)
        for table, maker in PAGES.items():
            if os.path.exists(os.path.join(options.folder, table)):
                print(f"The page is {maker.make_page(options.folder)}")
                return 0
        if os.path.exists(os.path.join(options.folder, "passages.csv")):
            run, count, path = report_passages(options.folder, options.each)
        else:
            run = run_data.load(options.folder, options.tick)
            count, path = make_report(run)
            if options.csv:
                print(f"{len(tables.write_all(run))} tables in {os.path.join(run.folder, 'csv')}")
    except (run_data.ReportError, OSError) as error:
        print(f"error: {error}", file=sys.stderr)
        return 1
    for sentence in run.remarks:
        print(sentence)
    print(f"{count} pictures in {run.pictures_folder}, the page is {path}")
    return 0


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))
