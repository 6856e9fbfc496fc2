"""Computes a small study and opens its page in a headless Chromium: no complaint on the console, sliders over the cases
work, numbers under the cursor are those of table.csv and of the cases' files, print shows the pictures.

Usage: study_page.py PROGRAM MPIEXEC. Ends with code 77 (skipped) where there is no Chromium or Snakemake.
"""

import csv
import json
import os
import shutil
import subprocess
import sys
import types

from browser import find_browser
from checks import check, finish, small_study
from page_checks import check_page, close, plot, set_control

PROGRAM = sys.argv[1]
sys.path.insert(0, os.path.join(os.path.dirname(os.path.dirname(os.path.abspath(__file__))), "source", "report"))
sys.dont_write_bytecode = True
import wheelrail  # noqa: E402

sys.path.insert(0, os.path.join(os.path.dirname(os.path.dirname(os.path.abspath(__file__))), "source", "study"))
import page_stamp  # noqa: E402


def check_figures(page, row_of):
    """The curves hold the rows of the table."""
    names = plot(page, "view-figures", "plot.data.map(trace => trace.name).join()")
    check(names == "Finite elements,Half-spaces,True bodies", f"curves: {names}")
    for number, kind in enumerate(("", ", half-spaces", ", true bodies")):
        shown = plot(page, "view-figures", f"plot.data[{number}].y")
        wanted = row_of(f"peak pressure{kind} [MPa]")
        check(len(shown) == len(wanted) == 2 and all(close(a, b) for a, b in zip(shown, wanted)),
              f"peak pressure{kind}: {shown}, in the table {wanted}")


def check_cases(page, runs):
    """The slider goes over the cases."""
    for number, run in enumerate(runs):
        set_control(page, "view-patch", "tick", str(number))
        shown = plot(page, "view-patch", "Math.max(...plot.data[0].z.flat().filter(v => v !== null))")
        wanted = float(run.patch[-1]["pressure"].to("MPa").max())
        check(abs(shown - wanted) <= 1e-4 * wanted, f"case {number}: pressure {shown} MPa, in the file {wanted:.3f}")
        set_control(page, "view-slices", "case", str(number))
        shown = plot(page, "view-slices", "Math.max(...plot.data[1].z.flat().filter(v => v !== null))")
        cut = run.slices[-1]["AA_rail"]
        wanted = float(cut["von_mises_stress"].to("MPa")[:, cut["depth"] <= 0.010001].max())
        check(abs(shown - wanted) <= 1e-3 * wanted, f"case {number}: von Mises {shown} MPa, in the file {wanted:.3f}")


if find_browser() is None or shutil.which("snakemake") is None:
    print("skipped: Chromium (package chromium) and Snakemake (package snakemake) are needed")
    sys.exit(77)
with open("study.prm", "w") as file:
    file.write(small_study("Contact/Friction coefficient: 0.3, 0.5", more="  set Folder = study"))
done = subprocess.run([PROGRAM, "study", "study.prm", "--jobs", "2"], stdout=subprocess.PIPE, stderr=subprocess.STDOUT,
                      text=True)
check(done.returncode == 0, f"the study is computed {done.stdout[-300:] if done.returncode else ''}")
plan = json.loads(subprocess.run([PROGRAM, "study", "study.prm", "--plan"], stdout=subprocess.PIPE, text=True).stdout)
with open("study/table.csv") as file:
    table = list(csv.DictReader(file))
runs = [wheelrail.load(os.path.join("study", case["name"])) for case in plan["cases"]]
check_page("study/study.html", ["view-figures", "view-patch", "view-cuts", "view-slices"],
           lambda page: (check_figures(page, lambda key: [float(row[key]) for row in table]), check_cases(page, runs)))

# the same command again draws nothing; a page is drawn anew for other figures, another title, or when it is gone
drawn = os.stat("study/study.html").st_mtime_ns
again = subprocess.run([PROGRAM, "study", "study.prm"], stdout=subprocess.PIPE, stderr=subprocess.STDOUT, text=True)
check(again.returncode == 0 and "the page is" in again.stdout and os.stat("study/study.html").st_mtime_ns == drawn,
      f"a second call leaves the page {again.stdout[-300:]}")
study = types.SimpleNamespace(title="small", path=lambda *names: os.path.join("study", *names),
                              work=lambda name: os.path.join("study", "workflow", name))
check(page_stamp.is_current(study), "the page is that of its tables")
study.title = "another"
check(not page_stamp.is_current(study), "not under another title")
study.title = "small"
with open("study/table.csv", "a") as file:
    file.write("\n")
check(not page_stamp.is_current(study), "nor with another table")
finish()
