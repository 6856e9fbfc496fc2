"""Runs the report script on the folder that tests/output.cc wrote and checks what it makes and says.

Usage: read_report.py REPORT.PY FOLDER
"""

import os
import re
import subprocess
import sys
import tempfile

from checks import check, finish


def report(script, *arguments):
    done = subprocess.run(["/usr/bin/python3", script, *arguments], capture_output=True, text=True, check=False)
    return done.returncode, done.stdout, done.stderr


def check_sentence(result, *parts):
    code, _, error = result
    check(code == 1 and all(part in error for part in parts) and "Traceback" not in error, "says: " + error.strip())


script, folder = sys.argv[1:3]
code, out, error = report(script, folder, "--tick", "1")
check(code == 0 and error == "", "the report is made without complaints " + error.strip())
with open(os.path.join(folder, "report.html"), encoding="utf-8") as file:
    page = file.read()
names = ["sheet", "pressure_surface", "pressure_contour", "shear_surface", "shear_contour", "stick_slip", "cut_aa", "cut_bb",
         "forces"]
for name in names:
    path = os.path.join(folder, "pictures", name + ".png")
    check(os.path.exists(path) and os.path.getsize(path) > 5000, f"pictures/{name}.png")
check(page.count("data:image/png;base64,") == len(names), "the page holds all pictures")
check(not re.search(r"(src|href)=.?https?:", page), "the page needs no network")
check('id="plotly"' in page and 'id="view-patch"' in page, "and interactive views with what draws them")
check("There is no slices.h5" in out, "stresses below the contact that are not there are told")
check("Further values" not in page, "all results have a label and a unit")
check(page.index("Key results") < page.index("Contact patch"), "key results stand at the top")
check("1234.5" in page and "Peak pressure" in page, "the page shows the peak pressure")
check("friction coefficient is neither" in out, "a missing friction coefficient is told")

code, out, error = report(script, folder, "--csv")
check(code == 0 and "tables in" in out, "tables are written when asked for")
for name, header in (("history", "normal force [kN]"), ("patch", "along [mm],lateral s [mm]")):
    with open(os.path.join(folder, "csv", name + ".csv"), encoding="utf-8") as file:
        lines = file.read().splitlines()
    check(header in lines[0] and len(lines) > 2 and len({line.count(",") for line in lines}) == 1, f"csv/{name}.csv: {lines[0]}")
code, out, error = report(script, folder, "--tick", "0,2")
check(code == 0 and os.path.exists(os.path.join(folder, "pictures", "shear_instants.png")), "shear at chosen ticks")
check_sentence(report(script, folder, "--tick", "9"), "no output step 9", "from 0 to 2")
check_sentence(report(script, os.path.join(folder, "none")), "There is no folder")
with tempfile.TemporaryDirectory() as empty:
    check_sentence(report(script, empty), "holds no results")
    check(not os.listdir(empty), "a folder without results stays as it was")
    os.mkdir(os.path.join(empty, "pictures"))
    for name in ("places.csv", "pictures/places.png"):
        with open(os.path.join(empty, name), "w", encoding="utf-8"):
            pass
    check_sentence(report(script, empty), f"{empty} holds places.csv, pictures/places.png, of which there is no page;")
    check(not os.path.exists(os.path.join(empty, "report.html")), "a folder of tables alone has no page")
    with open(os.path.join(empty, "patch.h5"), "w", encoding="utf-8") as file:
        file.write("no HDF5")
    check_sentence(report(script, empty), "patch.h5", "cannot be read as HDF5")
finish()
