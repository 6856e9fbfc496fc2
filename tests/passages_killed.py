"""Wheels of a list over a rail until it is steady, killed again and again, give what one go gives; the pages of both.

Usage: passages_killed.py PROGRAM MPIEXEC
"""

import csv
import json
import os
import signal
import subprocess
import sys
import time

import h5py
import numpy as np

from checks import check, finish

PROGRAM = sys.argv[1]

SCENE = """
set Title = wheels of a list
subsection Track
  set Rail length = 400 mm
end
subsection Mesh
  set Solution cell size = 4 mm
  set Fine depth = 8 mm
  set Fine margin = 8 mm
end
subsection Rail material
  set Yield stress = 400 MPa
  set Tangent modulus = 21 GPa
end
subsection Run
  set Rolling distance = 24 mm
  set Averaging distance = 6 mm
  set Passages = until steady
  set Passage list = wheels.csv
  set Most passages = 6
  set Settled growth = 0.001
end
subsection Output
  set Ticks = 2
  set Volume fields = false
  set Checkpoint interval = 0.2 s
end
"""
WHEELS = "load [kN], traction\n105, 0.25\n75, -0.25\n"
FIGURES = ["wheel_load_N", "vertical_force_N", "longitudinal_force_N", "max_pressure_Pa", "rail_plastic_strain",
           "plastic_strain_increment", "plastic_work_rail_J"]


def command(folder, *options):
    return [PROGRAM, "run", "scene.prm", "--set", "Output/Folder = " + folder, *options]


def table(folder):
    with open(folder + "/passages.csv", encoding="utf-8") as file:
        return [{name: float(text or "nan") for name, text in row.items()} for row in csv.DictReader(file)]


def kill_and_resume(folder):
    """Kills the run five times, each time after it has saved more; returns how often it was killed."""
    kills, options = 0, []
    for wait in (2.5, 4, 3, 6, 3.5):
        process = subprocess.Popen(command(folder, *options), stdout=subprocess.DEVNULL)
        try:
            process.wait(wait)
            break
        except subprocess.TimeoutExpired:
            process.send_signal(signal.SIGKILL)
            process.wait()
            kills += 1
        options = ["--resume"]
    return kills


def interrupt_and_resume(folder):
    """Ctrl-C in the second passage: the command that is printed goes on to the last."""
    process = subprocess.Popen(command(folder), stdout=subprocess.PIPE, text=True)
    for line in process.stdout:
        if line.startswith("Passage 2 "):
            break
    process.send_signal(signal.SIGINT)
    told = [line for line in process.stdout if "--resume" in line]
    check(process.wait() == 3 and len(told) == 1, "interrupted in the second passage")
    words = told[0].split(" run ")[1].split()
    check(words[0] == folder + "/parameters.prm", f"the command to go on names all passages: {told[0]!r}")
    done = subprocess.run([PROGRAM, "run", words[0], "--resume"], capture_output=True, text=True, check=False)
    check(done.returncode == 0 and len(table(folder)) == 4, "and computes the rest: " + done.stderr[-300:])


def main():
    with open("scene.prm", "w", encoding="utf-8") as file:
        file.write(SCENE)
    with open("wheels.csv", "w", encoding="utf-8") as file:
        file.write(WHEELS)
    whole = subprocess.run(command("whole", "--overwrite"), capture_output=True, text=True, check=False)
    check(whole.returncode == 0, "in one go: " + whole.stderr[-300:])
    check("the rail has shaken down" in whole.stdout, "the run says that the rail has shaken down")
    rows = table("whole")
    check(len(rows) == 4, f"after two rounds, {len(rows)} wheels")
    check([round(row["wheel_load_N"] / 1e3) for row in rows] == [105, 75, 105, 75], "the loads are those of the list")
    check(rows[1]["longitudinal_force_N"] * rows[0]["longitudinal_force_N"] < 0, "every other wheel brakes")
    check("shaken down" in json.load(open("whole/summary.json"))["note"], "and so does the summary")

    subprocess.run(["rm", "-rf", "parts"], check=True)
    kills = kill_and_resume("parts")
    check(kills > 1, f"killed {kills} times")
    last = subprocess.run(command("parts", "--resume"), capture_output=True, text=True, check=False)
    check(last.returncode == 0, "gone on with to the end: " + last.stderr[-300:])
    again = table("parts")
    check(len(again) == len(rows), "as many wheels")
    for passage, (one, other) in enumerate(zip(rows, again), 1):
        for name in FIGURES:
            apart = abs(one[name] - other[name]) / max(abs(one[name]), 1e-6)
            # two static starts of the same scene differ by some 1e-8
            check(apart < 1e-3, f"passage {passage}, {name}: apart by {apart:.1e}")

    subprocess.run(["rm", "-rf", "interrupted"], check=True)
    interrupt_and_resume("interrupted")

    with h5py.File("parts/passages.h5") as file:
        cut = file["BB_behind_rail"]
        strain, added = cut["plastic_strain"][:], cut["plastic_strain_increment"][:]
        check(strain.shape == (4, len(cut["position"]), len(cut["depth"])), "passages.h5: passages, places and depths")
        check(np.nanmax(np.abs(np.nancumsum(added, axis=0) - np.nan_to_num(strain))) < 1e-12,
              "increments add up")
        check(np.nanmin(added) > -1e-12, "plastic strain never falls")
        check(abs(np.nanmax(strain[-1]) - rows[-1]["rail_plastic_strain"]) < 1e-6,
              "its largest is that of passages.csv")
        check("forward_shear" in cut, "forward shear is there")
    drawn = subprocess.run([PROGRAM, "report", "parts"], capture_output=True, text=True, check=False)
    check(drawn.returncode == 0, "the report: " + drawn.stdout[-200:] + drawn.stderr[-300:])
    for name in ("growth", "growth_depth", "residual_depth", "passages", "shakedown_map"):
        check(os.path.exists(f"parts/pictures/{name}.png"), f"picture {name}")

    with open("wheels.csv", "w", encoding="utf-8") as file:
        file.write(WHEELS.replace("75", "70"))
    other = subprocess.run(command("parts", "--resume"), capture_output=True, text=True, check=False)
    check(other.returncode == 1, "another list is refused")
    check("parts/passage_002: this passage was computed with other entries: Wheelset/Wheel load = 70 kN, saved with "
          "75 kN; set them back, or start anew with --overwrite or in another Output/Folder" in other.stderr,
          "and says why: " + other.stderr[-300:])
    with open("wheels.csv", "w", encoding="utf-8") as file:
        file.write(WHEELS.replace("105", "900"))
    other = subprocess.run([PROGRAM, "run", "scene.prm", "--validate"], capture_output=True, text=True, check=False)
    check("wheels.csv:2: load = 900 is out of range" in other.stderr,
          "a list is read before the run: " + other.stderr[-200:])
    finish()


main()
