#!/usr/bin/python3
"""Measures again what doc/measured.md has: runs its commands and writes their numbers, with machine and commit, between
the marks of each part (<!-- measured: PART --> ... <!-- end -->). What stands outside the marks stays as it is, such as
parts that a benchmark of their own measures. The rows that README.md has, too, are copied there.

Usage: benchmarks/measure.py [PART ...] [--first N] [--program "./wheelrail"] [--build build] [--page FILE]

Parts: main (the main scene), cost (error over cost), times (calls of ready scenes), ranks (what a rank holds, by
benchmark_ranks of --build); all of them take an hour on two idle cores. --first N measures the first N rows of each
part, shows them, and writes nothing.
"""

import argparse
import datetime
import json
import os
import platform
import re
import shlex
import subprocess
import sys
import tempfile
import time
from pathlib import Path

HOME = Path(__file__).resolve().parent.parent
HALF, BODIES = "relative_difference_", "bodies_relative_difference_"

#: row of the main scene: label, key without unit, unit of the file, unit here, factor, decimals
MAIN = [("peak pressure", "max_pressure", "_Pa", " MPa", 1e-6, 0),
        ("contact area", "contact_area", "_m2", " mm2", 1e6, 1),
        ("peak shear traction", "max_shear_traction", "_Pa", " MPa", 1e-6, 0),
        ("creepage", "creepage", "", "e-3", 1e3, 3),
        ("sticking part", "stick_fraction", "", " %", 100, 1),
        ("lateral force", "lateral_force", "_N", " kN", 1e-3, 2),
        ("wear number T-gamma", "t_gamma", "_N", " N", 1, 1),
        ("largest von Mises below one cell", "von_mises_below_cell", "_Pa", " MPa", 1e-6, 0)]

#: cells of the table of error over cost [mm], its results
CELLS = (2, 1, 0.5, 0.25)
COST = [("peak pressure", "max_pressure", "_Pa"), ("area", "contact_area", "_m2"), ("peak shear", "max_shear_traction", "_Pa"),
        ("creepage", "creepage", "")]

#: entries of Mesh of the table of ranks: some 40 000 cells, one and two million
RANK_MESHES = {"1 mm": ["Solution cell size = 1 mm"],
               "0.125 mm": ["Solution cell size = 0.125 mm"],
               "0.1 mm, margin of 5 mm": ["Solution cell size = 0.1 mm", "Coarse cell size = 12.8 mm", "Fine margin = 5 mm"]}

#: calls of ready scenes, the cheap ones first: what is shown, arguments of the program
TIMES = [("`prm/wear.prm`: 27 steps of nine rows", "wear prm/wear.prm --no-pictures"),
         ("`prm/quickstart.prm`, 2 mm cells", "run prm/quickstart.prm"),
         ("`prm/wear_machining.prm`", "wear prm/wear_machining.prm --no-pictures"),
         ("`prm/s_curve.csv`: 201 rows, both wheels, half-spaces",
          "vehicle prm/rolling.prm prm/s_curve.csv --both-wheels --bodies half-spaces --no-pictures"),
         ("`prm/rolling.prm` over 60 mm", 'run prm/rolling.prm --set "Run/Rolling distance = 60 mm"'),
         ("`prm/s_curve.csv`, true bodies", "vehicle prm/rolling.prm prm/s_curve.csv --both-wheels --no-pictures"),
         ("`prm/rolling_plastic.prm`, 100 mm, rail that yields", "run prm/rolling_plastic.prm"),
         ("`prm/paper.prm`, 520 mm", "run prm/paper.prm"),
         ("`prm/studies/friction.prm`, nine cases with half-spaces, without the page", "study prm/studies/friction.prm --no-pictures"),
         ("`prm/squat_track.prm`, 1.2 m over sleepers and a squat", "run prm/squat_track.prm"),
         ("`prm/ratcheting.prm`", "run prm/ratcheting.prm"),
         ("`prm/passages.prm`, ten passages over a yielding rail", "run prm/passages.prm"),
         ("`prm/wear_curve.prm`: 24 steps of 201 rows of both wheels", "wear prm/wear_curve.prm --no-pictures")]


class Calls:
    """Calls the program in the folder of the scenes, with results in one of their own."""

    def __init__(self, program, build, work):
        self.program, self.build, self.work = shlex.split(program), build, work

    def output(self, command):
        """What a command prints; ends the measurement where it fails."""
        print(" ".join(map(shlex.quote, command)), flush=True)
        done = subprocess.run(command, cwd=HOME, stdout=subprocess.PIPE, stderr=subprocess.STDOUT, text=True, check=False)
        if done.returncode:
            sys.exit(f"{done.stdout[-2000:]}\nexit code {done.returncode}: this part is not written")
        return done.stdout

    def call(self, arguments):
        """Wall time of a call of the program [s]."""
        begin = time.monotonic()
        self.output(self.program + arguments)
        return time.monotonic() - begin

    def seconds(self, call, name):
        """The same of a call whose results go to the folder `name`."""
        return self.call(shlex.split(call) + ["--set", f"Output/Folder = {self.work}/{name}"])

    def compare(self, name):
        """Compares a run with half-spaces and true bodies; its results by their keys, those of both included."""
        self.call(["compare", f"{self.work}/{name}", "--no-pictures"])
        return self.summary(name)

    def summary(self, name):
        with open(f"{self.work}/{name}/summary.json", encoding="utf-8") as file:
            return json.load(file)


def shown_time(seconds):
    if seconds < 100:
        return f"{seconds:.1f} s" if seconds < 10 else f"{seconds:.0f} s"
    return f"{seconds / 60:.1f} min"


def per_cent(value, decimals=1):
    return f"{100 * value:+.{decimals}f} %"


def table(head, rows):
    lines = ["| " + " | ".join(head) + " |", "|" + " --- |" * len(head)]
    return [re.sub(r"\|  (?=\|)", "| ", line) for line in lines + ["| " + " | ".join(row) + " |" for row in rows]]


def main_scene(calls, first):
    """The main scene until steady, against half-spaces and true bodies under its load."""
    took = calls.seconds("run prm/rolling.prm", "main")
    run = calls.compare("main")
    rows = []
    for label, key, si, unit, factor, decimals in MAIN[:first]:
        row = [label] + [f"{factor * run[k + key + si]:.{decimals}f}{unit}" for k in ("", "halfspace_")]
        if unit == " %":
            row += [f"{factor * (run[key] - run[k + key]):+.1f} points" for k in ("halfspace_", "bodies_")]
        else:
            row += [per_cent(run[k + key]) for k in (HALF, BODIES)]
        if key == "lateral_force":
            row[3:] = [f"{per_cent(run[k + key], 2)} of the load" for k in (HALF, BODIES)]
        rows.append(row)
    rows += [["energy error", f"{100 * run['energy_error']:.2f} %", "", "", ""],
             ["steady after", f"{1e3 * run['rolled_distance_m']:.1f} mm", "", "", ""],
             ["hexahedra at the start", grouped(run["elements"]), "", "", ""]]
    half = "halfspace prm/rolling.prm --no-pictures --bodies "
    fast, slow = calls.seconds(half + "half-spaces", "half"), calls.seconds(half + "real", "bodies")
    rows.append(["time, memory on two cores", f"{shown_time(took)}, {1e-9 * run['peak_memory_bytes']:.1f} GB", shown_time(fast), "",
                 shown_time(slow)])
    alone = calls.summary("half-halfspace")
    return table(["", "finite elements", "half-spaces", "difference", "difference to true bodies"], rows) + [
        "", "Without the run's position and angles (`halfspace prm/rolling.prm --bodies half-spaces`) half-spaces have "
        f"{1e-6 * alone['max_pressure_Pa']:.0f} MPa and", f"{1e6 * alone['contact_area_m2']:.1f} mm2: the rail head turns by "
        f"{1e3 * abs(run['rail_head_roll_rad']):.1f} mrad under the wheel."]


def grouped(number):
    return f"{int(number):,}".replace(",", " ")


def off_both(run, key, unit):
    """Difference to half-spaces; in brackets to true bodies, with that of both ends of the run's own interval."""
    off, value = run[BODIES + key], run[key + unit]
    ends = [run.get(f"{key}_{end}{unit}") for end in ("low", "high")]
    interval = "" if None in ends else ", {:+.1f} to {:+.1f}".format(*(100 * (end / value * (1 + off) - 1) for end in ends))
    return f"{100 * run[HALF + key]:+.1f} ({100 * off:+.1f}{interval}) %"


def error_over_cost(calls, first):
    """The main scene on cells from 2 mm to 0.25 mm, until steady."""
    rows = []
    for cell in CELLS[:first]:
        name = f"cells_{cell}"
        took = calls.seconds(f'run prm/rolling.prm --set "Mesh/Solution cell size = {cell} mm"', name)
        run = calls.compare(name)
        rows.append([f"{cell} mm"] + [off_both(run, key, unit) for _, key, unit in COST] +
                    [f"{took:.1f} s", f"{1e-9 * run['peak_memory_bytes']:.2f} GB", grouped(run["elements"])])
    return table(["cells"] + [label for label, *_ in COST] + ["wall time", "memory", "hexahedra"], rows)


def times(calls, first):
    """Whole calls of ready scenes."""
    return table(["scene", "two cores"],
                 [[label, shown_time(calls.seconds(call, f"times_{k}"))] for k, (label, call) in enumerate(TIMES[:first])])


def ranks(calls, first):
    """What the busiest of one, two and four ranks has of the main scene, on other meshes, too."""
    rows = []
    for k, (label, entries) in enumerate(list(RANK_MESHES.items())[:first]):
        scene = Path(calls.work) / f"ranks_{k}.prm"
        sets = "".join(f"  set {entry}\n" for entry in entries)
        scene.write_text(f"include {HOME}/prm/rolling.prm\nsubsection Mesh\n{sets}end\n", encoding="utf-8")
        for n in (1, 2, 4):
            lines = calls.output(["mpirun", "--oversubscribe", "-n", str(n), f"{calls.build}/benchmark_ranks", str(scene)]).splitlines()
            if n == 1:
                names = re.split("  +", lines[-2].strip())
            found = dict(zip(names, map(float, lines[-1].split())))
            rows.append([label, str(n), grouped(found["of the busiest"]),
                         f"{found['memory MB']:.0f} MB", f"{found['sent to them kB']:.0f} kB",
                         f"{found['set-up s']:.1f} s", f"{found['step ms']:.0f} ms"])
    return table(["cells", "ranks", "cells of the busiest", "its memory", "sent a step", "set-up", "step"], rows) + [
        "", f"Each undivided block takes {found['bytes a coarse block']:.0f} bytes on every rank."]


PARTS = {"main": main_scene, "cost": error_over_cost, "times": times, "ranks": ranks}


def origin():
    """Where and with what a part was measured."""
    names = re.findall(r"^model name\s*: (.*)", Path("/proc/cpuinfo").read_text(encoding="utf-8"), re.M)
    git = ["git", "-C", str(HOME), "describe", "--always", "--dirty"]
    commit = subprocess.run(git, capture_output=True, text=True, check=False).stdout.strip() or "unknown"
    return (f"*{datetime.date.today():%d %B %Y}, commit {commit}, {names[0] if names else platform.processor()}, "
            f"{len(os.sched_getaffinity(0))} cores, load before {os.getloadavg()[0]:.1f}.*")


def put(page, part, lines):
    """Replaces what is between the marks of a part."""
    text = page.read_text(encoding="utf-8")
    new, found = re.subn(rf"(<!-- measured: {part} -->\n).*?(<!-- end -->)", lambda m: m[1] + "\n".join(lines) + "\n" + m[2], text,
                         flags=re.S)
    if found != 1:
        sys.exit(f"{page}: one part <!-- measured: {part} --> ... <!-- end --> is needed, {found} are there")
    page.write_text(new, encoding="utf-8")


def copy_rows(page, readme):
    """Copies the rows of the page's tables to those of README.md that begin alike."""
    rows = {line.split("|")[1]: line for line in page.read_text(encoding="utf-8").splitlines() if line.startswith("| ")}
    lines = readme.read_text(encoding="utf-8").splitlines()
    begin = lines.index("## Accuracy and speed")
    for k, line in enumerate(lines[begin:], begin):
        if line.startswith("!["):
            break
        if line.startswith("| ") and line[2].isalpha():
            lines[k] = rows.get(line.split("|")[1], line)
    readme.write_text("\n".join(lines) + "\n", encoding="utf-8")


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("parts", nargs="*", metavar="PART", help=", ".join(PARTS))
    parser.add_argument("--first", type=int, metavar="N")
    parser.add_argument("--program", default="./wheelrail")
    parser.add_argument("--build", default="build")
    parser.add_argument("--page", type=Path, default=HOME / "doc/measured.md")
    options = parser.parse_args()
    if unknown := [part for part in options.parts if part not in PARTS]:
        parser.error(f"no such part: {', '.join(unknown)}; there are {', '.join(PARTS)}")
    with tempfile.TemporaryDirectory() as work:
        calls = Calls(options.program, options.build, work)
        for part in options.parts or PARTS:
            before = origin()
            lines = [before, ""] + PARTS[part](calls, options.first)
            print("\n".join(lines))
            if options.first is None:
                put(options.page, part, lines)
    if options.first is None and options.page == HOME / "doc/measured.md":
        copy_rows(options.page, HOME / "README.md")


if __name__ == "__main__":
    main()
