"""What a report is made of: the results of a run, the tick that is drawn, and what is missing."""

import glob
import os
import re

import numpy as np

import sections
import wheelrail
from wheelrail import DataError as ReportError


class Run:
    """What the pictures of a folder are drawn from; None where a file is missing, with a sentence in `remarks`."""

    def __init__(self, folder):
        self.data = wheelrail.load(folder)
        self.folder = self.data.folder
        self.pictures_folder = self.data.path("pictures")
        self.remarks = []
        self.summary = None   # dictionary of summary.json
        self.figures = []     # how its figures are shown: the entries of figures.json
        self.patches = None   # all ticks of the patch
        self.patch = None     # the tick that is drawn
        self.tick = None      # its number
        self.instants = []    # numbers of several chosen ticks
        self.history = None   # name -> array over the recorded steps
        self.friction = None  # friction coefficient
        self.sections = None  # rail head and wheel; None of an earlier version, or where only a distance is given

    @property
    def title(self):
        return (self.summary or {}).get("title") or os.path.basename(os.path.abspath(self.folder))

    @property
    def is_halfspace(self):
        """Whether the folder holds a half-space solution alone."""
        return self.data.has("halfspace.h5") and not self.data.has("patch.h5")

    @property
    def peaks(self):
        """Peak pressure and shear traction of the results [MPa], which maps of the last output step show as theirs; empty
        where results belong to no output step, as over irregular surfaces."""
        summary = self.summary or {}
        if "largest_vertical_force_at_m" in summary or (self.patches is not None and
                                                        self.tick != int(self.patches.names[-1][5:])):
            return {}
        keys = {"pressure": "max_pressure_Pa", "shear": "max_shear_traction_Pa"}
        return {name: 1e-6 * summary[key] for name, key in keys.items() if (summary.get(key) or 0) > 0}

    def other_patches(self):
        """Number and fields of the further patches of a half-space solution, the second on."""
        found = []
        while self.data.has(f"halfspace_patch_{len(found) + 2}.h5"):
            found.append((len(found) + 2, self.data.halfspace_patch(len(found) + 2)[-1]))
        return found

    def try_to(self, read, without):
        """What `read` gives; None, with a remark, where its file is missing."""
        try:
            return read()
        except wheelrail.MissingFile as error:
            self.remarks.append(f"{error} {without}")
            return None


def load_summary(run):
    run.summary = run.try_to(lambda: run.data.summary, "The table of results is left out.")
    if run.summary is not None:
        figures = run.try_to(lambda: run.data.figures, "Results are shown by their keys, in SI units.")
        run.figures = list((figures or {}).values())


def figure_of(run, key):
    """How the figure with this key is shown; None when that is not known."""
    return next((figure for figure in run.figures if figure["key"] == key), None)


def choose_tick(ticks, wanted):
    """Number of a tick: last, or a number as a text."""
    if len(ticks) == 0:
        raise ReportError(f"The file {ticks.path} holds no output step; run the scene for longer.")
    numbers = [int(name[5:]) for name in ticks.names]
    if wanted == "last":
        return numbers[-1]
    if not re.fullmatch(r"\d+", wanted) or int(wanted) not in numbers:
        raise ReportError(f"There is no output step {wanted} in {ticks.path}; accepted are last and the numbers from "
                          f"{numbers[0]} to {numbers[-1]}.")
    return int(wanted)


def usual_tick(ticks, summary):
    """Number among the ticks of that which is drawn where none is asked for: the last, but over irregular surfaces that
    nearest to the largest force."""
    place = (summary or {}).get("largest_vertical_force_at_m")
    if place is None:
        return len(ticks) - 1
    return min(range(len(ticks)), key=lambda k: abs(ticks[k].attributes["rolled_distance_m"] - place))


def tick_of(ticks, number):
    return ticks[ticks.names.index(f"tick_{number:04d}")]


def load_patch(run, wanted):
    """The ticks of the patch; several wanted ones, with commas between, are the instants, the last of them is drawn;
    None: usual_tick()."""
    run.patches = run.try_to(lambda: run.data.patch, "The pictures of the contact patch are left out.")
    if run.patches is None:
        return
    numbers = [choose_tick(run.patches, text.strip()) for text in (wanted or "last").split(",")]
    run.instants = [int(run.patches.names[usual_tick(run.patches, run.summary)][5:])] if wanted is None else numbers
    run.tick = run.instants[-1]
    run.patch = tick_of(run.patches, run.tick)
    missing = {"along", "lateral", "pressure", "shear_along", "shear_lateral", "state"} - set(run.patch)
    if missing:
        raise ReportError(f"The file {run.patches.path} lacks the fields {', '.join(sorted(missing))}.")


def find_friction(run):
    """Friction coefficient from the summary, else from parameters.prm, else None."""
    value = (run.summary or {}).get("friction_coefficient")
    path = run.data.path("parameters.prm")
    if value is None and os.path.exists(path):
        with open(path, encoding="utf-8", errors="replace") as file:
            found = re.search(r"^\s*set\s+Friction coefficient\s*=\s*([0-9.eE+-]+)", file.read(), re.MULTILINE)
        value = float(found.group(1)) if found else None
    return None if value is None or not np.isfinite(value) else float(value)


def tables_in(folder):
    """The tables of a folder, as of places and creep curves, and the pictures of them."""
    found = [os.path.relpath(path, folder) for name in ("*.csv", "pictures/*.png")
             for path in glob.glob(os.path.join(glob.escape(folder), name))]
    return sorted(found, key=lambda name: (os.sep in name, name)) if any(name.endswith(".csv") for name in found) else []


def load(folder, tick=None):
    run = Run(folder)
    load_summary(run)
    load_patch(run, tick)
    if not run.is_halfspace:
        run.history = run.try_to(lambda: run.data.history, "The pictures over the rolled distance are left out.")
    if run.summary is None and run.patch is None and run.history is None:
        if tables := tables_in(run.folder):
            raise ReportError(f"The folder {folder} holds {', '.join(tables)}, of which there is no page; give the output "
                              "folder of a run for one.")
        raise ReportError(f"The folder {folder} holds no results (none of summary.json, patch.h5 and "
                          "history.h5); give the output folder of a run.")
    run.friction = find_friction(run)
    run.sections = sections.load(run.folder)
    os.makedirs(run.pictures_folder, exist_ok=True)
    return run
