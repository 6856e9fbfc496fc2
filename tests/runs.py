"""Runs a scene of tests/runs, holds it against its stored result and against half-spaces: tests/runs/README.md.

Usage: runs.py PROGRAM MPIEXEC FILE.prm RUN

Leaves FILE.output in the present folder: the stored result with this run's figures in it.
"""

import csv
import json
import math
import os
import re
import subprocess
import sys

import h5py
import numpy as np

from checks import check, finish

UNITS = {"MPa": 1e6, "kN": 1e3, "mm2": 1e-6, "mm": 1e-3, "mrad": 1e-3, "1e-3": 1e-3, "%": 1e-2, "J": 1, "1": 1}

# A run may differ from half-spaces under its own load and pose by so much, on cells of 1 mm; on others in proportion
# to the cell size.
HALF_SPACES = {"max_pressure_Pa": "2 %", "contact_area_m2": "2.5 %", "max_shear_traction_Pa": "2 %", "creepage": "3 %"}

# what a new stored result begins with: figure, unit, tolerance
FIGURES = [line.split(maxsplit=2) for line in """
normal_force_N kN 0.1 %
longitudinal_force_N kN 0.02
lateral_force_N kN 0.02
max_pressure_Pa MPa 0.1 %
max_pressure_fitted_Pa MPa 0.1 %
contact_area_m2 mm2 0.1 %
patch_lateral_m mm 0.1 %
patch_longitudinal_m mm 0.1 %
patch_centre_lateral_m mm 0.01
patch_centre_longitudinal_m mm 0.01
max_shear_traction_Pa MPa 0.1 %
stick_fraction % 0.1
creepage 1e-3 0.002
max_von_mises_Pa MPa 0.1 %
max_plastic_strain 1e-3 0.1 %
plastic_work_rail_J J 0.1 %
plastic_work_wheel_J J 0.1 %
relative_lateral_m mm 0.001
rail_head_roll_rad mrad 0.002
wheel_rim_roll_rad mrad 0.002
energy_error % 0.005
elements 1 0
halfspace_max_pressure_Pa MPa 0.1 %
halfspace_contact_area_m2 mm2 0.1 %
halfspace_max_shear_traction_Pa MPa 0.1 %
halfspace_creepage 1e-3 0.002
""".strip().splitlines()]


def allowed(tolerance, value):
    """What "0.1 %" of the value, or an absolute number, allows."""
    if tolerance.endswith("%"):
        return 0.01 * float(tolerance[:-1]) * abs(value)
    return float(tolerance)


class Row:
    """A line of a stored result: key, value in its unit, unit, tolerance (absolute in the unit, or with % relative)."""

    def __init__(self, key, value, unit, tolerance):
        self.key, self.unit, self.tolerance = key, unit, tolerance
        self.factor = UNITS[unit]
        self.value = float(value)

    def with_value(self, value):
        return f"{self.key:30} {value:14.7g}  {self.unit:5} {self.tolerance}"


def read_scene(file, run):
    """What the remarks at the top of the scene say of this run: ranks, changed entries; and whether it is compared with
    half-spaces and true bodies, with which limits of its own."""
    with open(file) as lines:
        remarks = [line.rstrip("\n") for line in lines if line.startswith("#")]
    ranks, entries, found, limits, bodies, stored_only = 2, [], False, None, {}, False
    for line in remarks:
        match = re.match(r"# run (\S+):(.*)", line)
        if match and match[1] == run:
            found = True
            for word in filter(None, (word.strip() for word in match[2].split(","))):
                if re.fullmatch(r"ranks \d+", word):
                    ranks = int(word.split()[1])
                elif "=" in word:
                    entries.append(word)
                elif word == "stored only":
                    stored_only = True
                elif word != "long":
                    sys.exit(f'{file}, run {run}: "{word}" is neither long, stored only, ranks N nor '
                             "Section/Entry = value.")
        match = re.match(r"# half-spaces: compared(.*)", line)
        if match:
            limits = dict(HALF_SPACES)
            limits.update(re.findall(r"(\w+) ([\d.e-]+(?: %)?)", match[1]))
        match = re.match(r"# true bodies: compared(.*)", line)
        if match:
            bodies = dict(re.findall(r"(\w+) ([\d.e-]+(?: %)?)", match[1]))
    if not found:
        sys.exit(f'{file} has no line "# run {run}: ...".')
    return ranks, entries, None if stored_only else limits, bodies


def read_stored(file):
    """The stored results by run, each a list of rows; empty without the file."""
    runs, rows = {}, None
    if os.path.exists(file):
        with open(file) as lines:
            for number, line in enumerate(lines, 1):
                words = line.split(maxsplit=3)
                if line.startswith("run "):
                    rows = runs.setdefault(words[1], [])
                elif words and not line.startswith("#"):
                    if len(words) != 4 or words[2] not in UNITS or rows is None:
                        sys.exit(f"{file}, line {number}: key, value, unit and tolerance are expected below a line "
                                 f'"run NAME"; units are {", ".join(UNITS)}.')
                    rows.append(Row(words[0], words[1], words[2], words[3].strip()))
    return runs


def write_stored(file, runs, run, figures):
    """The stored results with the figures of this run in place of its old ones."""
    if run not in runs:
        runs[run] = [Row(key, 0, unit, tolerance) for key, unit, tolerance in FIGURES if figures.get(key) is not None]
    with open(file, "w") as output:
        for name, rows in runs.items():
            output.write(f"run {name}\n")
            for row in rows:
                value = row.value if name != run else number(figures, row.key) / row.factor
                output.write(row.with_value(value) + "\n")


def number(figures, key):
    """A figure in SI; nan where the run gives none."""
    value = figures.get(key)
    return math.nan if value is None else float(value)


def execute(*command):
    done = subprocess.run(command, stdout=subprocess.PIPE, stderr=subprocess.STDOUT, text=True)
    if done.returncode != 0:
        print(done.stdout)
    check(done.returncode == 0, " ".join(os.path.basename(word) for word in command[-8:]))


def read_json(file):
    with open(file) as text:
        return json.load(text)


def check_stored(rows, figures):
    for row in rows:
        value = number(figures, row.key) / row.factor
        unit = "" if row.unit == "1" else " " + row.unit
        check(abs(value - row.value) <= allowed(row.tolerance, row.value),
              f"{row.key}: {value:.7g}{unit}, stored {row.value:.7g}, tolerance {row.tolerance}")


def check_compared(limits, bodies):
    """The run against half-spaces and against true bodies, each with limits of its own."""
    with open("run/parameters.prm") as text:
        cell = float(re.search(r"set Solution cell size *= *([\d.]+) mm", text.read())[1])
    compared = read_json("run/compare.json")
    if "below" in limits:
        check_below(limits.pop("below"), cell)
    for what, name, figures, own in (("half-spaces", "halfspace", compared["figures"], limits),
                                     ("true bodies", "bodies", compared["bodies"]["figures"], bodies)):
        lines = {line["key"]: line for line in figures}
        for key, limit in own.items():
            run, reference = number(lines[key], "fe"), number(lines[key], name)
            factor, unit = lines[key]["factor"], lines[key]["unit"]
            check(abs(run - reference) <= cell * allowed(limit, reference),
                  f"{key}: {factor * run:.5g} {unit}, {what} {factor * reference:.5g}, difference "
                  f"{100 * (run / reference - 1):+.2f} %, limit {limit} x {cell:g} mm")


def at_point(group, field, place, depth):
    """A field of a slice at a point, interpolated."""
    columns = [np.interp(depth, group["depth"][:], column) for column in group[field][:]]
    return np.interp(place, group["position"][:], columns)


def check_below(limit, cell):
    """Von Mises stress below the surface of the rail, where the run has its largest at each depth, two cells deep and more;
    below 6 mm, where fine cells meet coarser ones, four thirds of the limit."""
    with h5py.File("run/slices.h5") as run, h5py.File("run/halfspace_slices.h5") as half_spaces:
        last = run[sorted(run)[-1]]
        (other,) = half_spaces.values()
        for plane in ("AA_rail", "AA_peak_rail", "BB_rail"):
            mises, depths, worst = last[plane]["von_mises_stress"][:], last[plane]["depth"][:], (0, 0)
            for k, depth in enumerate(depths):
                if 2e-3 * cell - 1e-6 <= depth <= 10e-3:
                    i = np.nanargmax(mises[:, k])
                    theirs = at_point(other[plane], "von_mises_stress", last[plane]["position"][i], depth)
                    share = 1 if depth < 6.1e-3 else 0.75
                    worst = max(worst, (share * abs(mises[i, k] / theirs - 1), depth))
            check(worst[0] <= cell * allowed(limit, 1),
                  f"{plane}: von Mises stress from {2 * cell:g} mm down within {100 * worst[0]:.2f} % of that below half-spaces "
                  f"(at {1e3 * worst[1]:.1f} mm; below 6 mm three quarters count), limit {limit} x {cell:g} mm")


def worn(path):
    """Lateral places [m] and depths [m] of the first patch of a table of wear, and the spacing of the places."""
    with open(path, newline="") as table:
        rows = [row for row in csv.DictReader(table) if float(row["patch"]) == 1]
    lateral, depth = (np.array([float(row[key]) for row in rows]) for key in ("lateral_m", "archard_depth_m"))
    return lateral, depth, lateral[1] - lateral[0]


def check_wear(limit):
    """Work of friction and depth of wear at each lateral place against half-spaces on elements of 0.1 mm: on larger ones
    their own wear is too small, in proportion to the element. Depths of the half-spaces are means over the width of a
    row of the run; differences count over the largest depth."""
    figures = {line["key"]: line for line in read_json("run/compare.json")["figures"]}
    for key in ("t_gamma_N", "archard_section_m2"):
        run, half_spaces = number(figures[key], "fe"), number(figures[key], "halfspace")
        check(abs(run / half_spaces - 1) <= allowed(limit, 1),
              f"{key}: run over half-spaces of 0.1 mm {100 * (run / half_spaces - 1):+.2f} %, limit {limit}")
    places, depths, width = worn("run/wear.csv")
    fine, theirs, step = worn("run/halfspace_wear.csv")
    ends = np.append(fine - 0.5 * step, fine[-1] + 0.5 * step)
    section = np.append(0, np.cumsum(theirs) * step)
    means = (np.interp(places + 0.5 * width, ends, section) - np.interp(places - 0.5 * width, ends, section)) / width
    apart = np.abs(depths - means) / depths.max()
    check(apart.max() <= allowed(limit, 1),
          f"depth of wear at each lateral place within {100 * apart.max():.2f} % of the largest (at "
          f"{1e3 * places[apart.argmax()]:+.1f} mm), limit {limit}")
    summary = read_json("run/summary.json")
    readings = number(summary, "t_gamma_N") / number(summary, "creepage_work_N") - 1
    check(abs(readings) <= allowed(limit, 1),
          f"work of friction over that of force, moment and creepage of the run {100 * readings:+.2f} %, limit {limit}")


def main():
    program, mpiexec, scene, run = sys.argv[1:]
    ranks, entries, limits, bodies = read_scene(scene, run)
    sets = [word for entry in ["Output/Folder = run", *entries] for word in ("--set", entry)]
    execute(mpiexec, "--bind-to", "none", "--oversubscribe", "-q", "-n", str(ranks), program, "run", scene,
            "--overwrite", *sets)
    wear = limits.pop("wear", None) if limits else None
    if limits:
        execute(program, "compare", "run", "--no-pictures")
        check_compared(limits, bodies)

    stored_file = re.sub(r"\.prm$", ".output", scene)
    figures, stored = read_json("run/summary.json"), read_stored(stored_file)
    check(run in stored, f"{os.path.basename(stored_file)} holds a result of run {run}")
    check_stored(stored.get(run, []), figures)
    write_stored(os.path.basename(stored_file), stored, run, figures)
    if wear:
        execute(program, "compare", "run", "--no-pictures", "--bodies", "half-spaces",
                "--set", "Half-space/Element size = 0.1 mm")
        check_wear(wear)
    finish()


if __name__ == "__main__":
    main()
