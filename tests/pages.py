"""Makes the pages of a finished run and of its comparison and opens them in a headless Chromium: no complaint on the
console, sliders and choices work, numbers under the cursor are those of the files, print shows the pictures.

Usage: pages.py PROGRAM MPIEXEC FOLDER. Ends with code 77 (skipped) where there is no Chromium.
"""

import os
import shutil
import subprocess
import sys

from browser import find_browser
from checks import check, finish
from page_checks import check_page, close, plot, set_control

PROGRAM, _, SOURCE = sys.argv[1:4]
FOLDER = os.path.abspath("run")
sys.path.insert(0, os.path.join(os.path.dirname(os.path.dirname(os.path.abspath(__file__))), "source", "report"))
sys.dont_write_bytecode = True
import numpy as np  # noqa: E402
import sections  # noqa: E402
import wheelrail  # noqa: E402


def make(command):
    done = subprocess.run([PROGRAM, command, FOLDER], capture_output=True, text=True, check=False)
    check(done.returncode == 0 and done.stderr == "", f"{command} makes its page {done.stderr.strip()[:300]}")
    return done.stdout


def check_patch_view(page, run):
    """The map of the tick that the slider shows holds the numbers of patch.h5."""
    for number in (len(run.patch) - 1, 0):
        set_control(page, "view-patch", "tick", str(number))
        shown = plot(page, "view-patch", "Math.max(...plot.data[0].z.flat().filter(v => v !== null))")
        wanted = float(run.patch[number]["pressure"].to("MPa").max())
        check(close(shown, wanted), f"pressure under the cursor at tick {number}: {shown} MPa, in the file {wanted:.3f}")
    set_control(page, "view-patch", "field", "shear_along")
    shown = plot(page, "view-patch", "Math.min(...plot.data[0].z.flat().filter(v => v !== null))")
    check(close(shown, float(run.patch[0]["shear_along"].to("MPa").min())), f"another field: {shown} MPa")
    set_control(page, "view-patch", "surface", True)
    check(plot(page, "view-patch", "plot.data[0].type") == "surface", "the three-dimensional patch")
    set_control(page, "view-patch", "field", "state")
    check(plot(page, "view-patch", "plot.data[0].type === 'surface' && Math.max(...plot.data[0].surfacecolor.flat())") == 2,
          "stick and slip in three dimensions")
    check(plot(page, "view-patch", "plot.data[0].surfacecolor.flat().every((v, k) => v || plot.data[0].z.flat()[k] === null)"),
          "it ends at the patch: no colour of stick between slip and open nodes")
    set_control(page, "view-patch", "surface", False)
    set_control(page, "view-patch", "field", "pressure")
    check(abs(plot(page, "view-patch", "plot.data[0].zmax") - 1e-6 * run.summary["max_pressure_Pa"]) < 1, "colours end at the peak of the results")
    shown = plot(page, "view-patch", "plot.layout.shapes[1].x0")
    peak = plot(page, "view-patch", "(() => { const d = plot.data[0], row = d.z.flat(), k = row.indexOf(Math.max(...row.filter(v => v !== null)));"
                                    " return d.x[k % d.x.length]; })()")
    check(abs(shown - peak) < 1e-3, f"AA goes through the highest pressure: {shown} mm, {peak} mm")
    tick = run.patch[-1]
    set_control(page, "view-patch", "tick", str(len(run.patch) - 1))
    set_control(page, "view-patch", "field", "shear")
    shown = plot(page, "view-patch", "Number(plot.data.find(t => t.marker).hovertemplate.split(' ')[1])")
    wanted = 1e-6 * max(np.hypot(tick[of + "shear_along"], tick[of + "shear_lateral"]).max()
                        for of in ("", "edge_") if of + "shear_along" in tick)
    check(close(shown, wanted), f"peak shear, also between nodes: {shown} MPa, in the file {wanted:.3f}")


def check_cut_view(page):
    before = plot(page, "view-cuts", "Math.max(...plot.data[0].y)")
    place = plot(page, "view-cuts", "document.querySelector('#view-cuts [name=place]').max")
    set_control(page, "view-cuts", "place", place)
    check(plot(page, "view-cuts", "Math.max(...plot.data[0].y)") < before, "the cut moves to the edge of the patch")
    set_control(page, "view-cuts", "plane", "BB")
    check("lateral" in plot(page, "view-cuts", "plot.layout.xaxis.title.text"), "plane BB runs across the rail")


def check_slice_view(page, tick):
    set_control(page, "view-slices", "plane", "AA_peak")
    shown = plot(page, "view-slices", "Math.max(...plot.data[1].z.flat().filter(v => v !== null))")
    cut = tick["AA_peak_rail"]
    near = cut["depth"] <= 0.010001
    wanted = float(cut["von_mises_stress"].to("MPa")[:, near].max())
    check(close(shown, wanted), f"von Mises stress below the contact: {shown} MPa, in the file {wanted:.3f}")
    largest = plot(page, "view-slices", "Math.max(...plot.data.flatMap(body => body.z.flat()).map(v => v ?? 0))")
    ends = plot(page, "view-slices", "[plot.data[0].zmin, plot.data[0].zmax, plot.data[0].contours.coloring]")
    check(ends[0] == 0 and abs(ends[1] / largest - 1) < 1e-3 and ends[2] == "heatmap", f"colours end at 0 and {largest} MPa: {ends}")


if find_browser() is None:
    print("skipped: there is no Chromium; install the Debian package chromium")
    sys.exit(77)
shutil.rmtree(FOLDER, ignore_errors=True)
shutil.copytree(SOURCE, FOLDER)
output = make("report")
check("left out" not in output, f"nothing is left out of the report [{output.strip()}]")
run_data = wheelrail.load(FOLDER)
check_page(os.path.join(FOLDER, "report.html"), ["view-patch", "view-cuts", "view-slices", "view-curves"],
           lambda page: (check_patch_view(page, run_data), check_cut_view(page), check_slice_view(page, run_data.slices[-1])))
where, summary = sections.load(FOLDER), run_data.summary
place = where.place(where.on_rail(1e3 * summary["patch_centre_lateral_m"])[0])
for value, key in zip(place, ("patch_centre_from_axis_m", "patch_centre_from_gauge_face_m", "patch_centre_below_top_m")):
    check(abs(value - 1e3 * summary[key]) < 0.02, f"{key} by the sections of the page: {value:.3f} mm")
make("compare")
check_page(os.path.join(FOLDER, "compare.html"), ["view-patch", "view-cuts", "view-slices"],
           lambda page: (check_cut_view(page), check_slice_view(page, run_data.slices[-1])))
finish()
