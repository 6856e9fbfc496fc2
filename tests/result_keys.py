"""No figure is lost: keys of summary.json and columns of the tables against a stored list.

Usage: result_keys.py PROGRAM

A key that is new is added to tests/reference/result_keys.json; `result_keys.py PROGRAM --write` makes the list anew.
"""

import csv
import json
import os
import subprocess
import sys

from checks import SMALL_SCENE, check, finish

PROGRAM = os.path.abspath(sys.argv[1])
STORED = os.path.join(os.path.dirname(os.path.abspath(__file__)), "reference", "result_keys.json")

SCENE = f"""set Title = keys
{SMALL_SCENE}
subsection Run
  set Rolling distance = 4 mm
  set Averaging distance = 2 mm
end
subsection Half-space
  set Element size = 1 mm
end
subsection Rail material
  set Yield stress = 400 MPa
end
subsection Output
  set Ticks = 1
  set Folder = out
end
"""

MATERIAL = ["--set", "Material test/Axial = 500 MPa, -500 MPa", "--set", "Material test/Cycles = 2"]
CURVE = ["--set", "Track/Radius = 500 m", "--set", "Track/Cant = 100 mm"]


def program(*words):
    done = subprocess.run([PROGRAM, *words], stdout=subprocess.PIPE, stderr=subprocess.STDOUT, text=True, check=False)
    check(done.returncode == 0, f"{words[0]} ends well {'' if done.returncode == 0 else done.stdout[-500:]}")


def columns(path):
    with open(path, encoding="utf-8") as file:
        return next(csv.reader(line for line in file if not line.startswith("#")))


def keys(path):
    with open(path, encoding="utf-8") as file:
        return list(json.load(file))


def results():
    """The keys of each kind of result."""
    with open("keys.prm", "w", encoding="utf-8") as file:
        file.write(SCENE)
    with open("rows.csv", "w", encoding="utf-8") as file:
        file.write("distance [m],lateral shift [mm],yaw [mrad]\n0,0,0\n1,1,2\n")
    program("run", "keys.prm", "--overwrite", "--set", "Run/Passages = 2", "--set", "Output/Folder = many")
    of_run = "many/passage_001"
    program("compare", of_run, "--no-pictures")
    worn = os.path.join(os.path.dirname(os.path.abspath(__file__)), "profiles", "worn_S1002.prw")
    program("halfspace", "keys.prm", "--no-pictures", "--set", f"Profiles/Wheel = {worn}")
    program("vehicle", "keys.prm", "rows.csv", "--no-pictures", "--both-wheels", *CURVE)
    program("halfspace", "keys.prm", "--no-pictures", "--set", "Wheelset/Wheels = both", "--set",
            "Output/Folder = both")
    program("report", "both-halfspace")
    for page in ("wheelset.html", "right/report.html", "left/report.html"):
        check(os.path.getsize(f"both-halfspace/{page}") > 10000, f"{page} is there, with its pictures")
    program("halfspace", "keys.prm", "--no-pictures", "--creep-curve", "longitudinal 0.1,0.2 %")
    program("material", "keys.prm", "--no-pictures", *MATERIAL)
    return {"summary.json of a run": keys(f"{of_run}/summary.json"),
            "compare.json": keys(f"{of_run}/compare.json"),
            "summary.json of half-spaces": keys("out-halfspace/summary.json"),
            "summary.json of a wheelset": keys("both-halfspace/summary.json"),
            "vehicle.csv": columns("out-vehicle/vehicle.csv"),
            "creep_curve.csv": columns("out-halfspace/creep_curve.csv"),
            "cycles.csv": columns("out-material/cycles.csv"),
            "material.csv": columns("out-material/material.csv"),
            "passages.csv": columns("many/passages.csv")}


FOUND = results()
if "--write" in sys.argv:
    with open(STORED, "w", encoding="utf-8") as stored:
        json.dump(FOUND, stored, indent=1)
        stored.write("\n")
with open(STORED, encoding="utf-8") as stored:
    EXPECTED = json.load(stored)
check(set(FOUND) == set(EXPECTED), "the list has all kinds of results")
for what, names in FOUND.items():
    expected = EXPECTED.get(what, [])
    lost = [name for name in expected if name not in names]
    new = [name for name in names if name not in expected]
    check(not lost, f"{what}: no key of {len(expected)} is lost {lost}")
    check(not new, f"{what}: new keys stand in the list {new}")
finish()
