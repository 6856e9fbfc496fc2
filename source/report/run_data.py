"""Reads the output folder of a run."""

import json
import os
import re
import sys

try:
    import h5py
except ImportError as error:
    sys.exit(f"{error}; install the Debian package python3-h5py")
import numpy as np


class ReportError(Exception):
    """Something that keeps the report from being made; the text is a sentence for the user."""


class Run:
    """What a folder holds; None where a file is missing, with a sentence in `remarks`."""

    def __init__(self, folder):
        self.folder = folder
        self.pictures_folder = os.path.join(folder, "pictures")
        self.remarks = []
        self.summary = None  # dictionary of summary.json
        self.figures = []    # how its figures are shown: the entries of figures.json
        self.patch = None    # dictionary of 2-D arrays [along, lateral] and the attributes of the tick
        self.history = None  # dictionary: name -> (unit, values)
        self.friction = None  # friction coefficient

    @property
    def title(self):
        return (self.summary or {}).get("title") or os.path.basename(os.path.abspath(self.folder))


def text(value):
    return value.decode() if isinstance(value, bytes) else str(value)


def open_hdf5(run, name, use):
    path = os.path.join(run.folder, name)
    if not os.path.exists(path):
        run.remarks.append(f"There is no {name} in {run.folder}; {use} left out.")
        return None
    try:
        return h5py.File(path, "r")
    except OSError as error:
        raise ReportError(f"The file {path} cannot be read as HDF5: {error}.") from error


def read_json(run, name, kind, without):
    """The content of a JSON file of the run; None, with a remark, when there is none."""
    path = os.path.join(run.folder, name)
    if not os.path.exists(path):
        run.remarks.append(f"There is no {name} in {run.folder} {without}.")
        return None
    try:
        with open(path, encoding="utf-8") as file:
            content = json.load(file)
    except ValueError as error:
        raise ReportError(f"The file {path} is no readable JSON: {error}.") from error
    if not isinstance(content, kind):
        raise ReportError(f"The file {path} is not what the program writes: "
                          f"a JSON {'object' if kind is dict else 'array'} was expected.")
    return content


def load_summary(run):
    run.summary = read_json(run, "summary.json", dict,
                            "(the run has not finished?); the table of figures is left out")
    if run.summary is not None:
        run.figures = read_json(run, "figures.json", list,
                                "(a run of an earlier version?); figures are shown by their keys, in SI units") or []


def figure_of(run, key):
    """How the figure with this key is shown; None when that is not known."""
    return next((figure for figure in run.figures if figure["key"] == key), None)


def choose_tick(file, wanted, path):
    ticks = sorted(name for name in file if name.startswith("tick_"))
    if not ticks:
        raise ReportError(f"The file {path} holds no tick; run the scene for longer.")
    if wanted == "last":
        return ticks[-1]
    if not re.fullmatch(r"\d+", wanted) or f"tick_{int(wanted):04d}" not in ticks:
        raise ReportError(f"There is no tick {wanted} in {path}; accepted are last and the numbers from "
                          f"{int(ticks[0][5:])} to {int(ticks[-1][5:])}.")
    return f"tick_{int(wanted):04d}"


def load_patch(run, wanted, name="patch.h5"):
    file = open_hdf5(run, name, "the pictures of the contact patch are")
    if file is None:
        return
    with file:
        group = file[choose_tick(file, wanted, file.filename)]
        run.patch = {name: group[name][:] for name in group}
        run.patch.update({name: group.attrs[name] for name in group.attrs})
        run.patch["tick"] = int(group.name[-4:])
    missing = {"along", "lateral", "pressure", "shear_along", "shear_lateral", "state"} - set(run.patch)
    if missing:
        raise ReportError(f"The file {file.filename} lacks the fields {', '.join(sorted(missing))}.")


def load_history(run):
    file = open_hdf5(run, "history.h5", "the pictures over the rolled distance are")
    if file is None:
        return
    with file:
        names = sorted(file, key=lambda name: int(file[name].attrs.get("column", 0)))
        run.history = {name: (text(file[name].attrs.get("unit", "")), file[name][:]) for name in names}


def find_friction(run):
    """Friction coefficient from the summary, else from parameters.prm, else None."""
    value = (run.summary or {}).get("friction_coefficient")
    path = os.path.join(run.folder, "parameters.prm")
    if value is None and os.path.exists(path):
        with open(path, encoding="utf-8", errors="replace") as file:
            found = re.search(r"^\s*set\s+Friction coefficient\s*=\s*([0-9.eE+-]+)", file.read(), re.MULTILINE)
        value = float(found.group(1)) if found else None
    return None if value is None or not np.isfinite(value) else float(value)


def load(folder, tick, patch_file="patch.h5", with_history=True):
    if not os.path.isdir(folder):
        raise ReportError(f"There is no folder {folder}; give the output folder of a run.")
    run = Run(folder)
    load_summary(run)
    load_patch(run, tick, patch_file)
    if with_history:
        load_history(run)
    if run.summary is None and run.patch is None and run.history is None:
        raise ReportError(f"The folder {folder} holds no results (none of summary.json, patch.h5 and "
                          "history.h5); give the output folder of a run.")
    run.friction = find_friction(run)
    os.makedirs(run.pictures_folder, exist_ok=True)
    return run
