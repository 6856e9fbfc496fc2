"""Tables with commas beside the HDF5 files, for spreadsheets and other programs: `report --csv`.

All go to FOLDER/csv. A header is a label with its unit in brackets, "normal force [kN]"; the first line of a file names
its columns, numbers have points.
"""

import csv
import os

import numpy as np

import run_data
from whole_file import part_of

#: unit in the files -> unit in the tables, factor
SHOWN = {"Pa": ("MPa", 1e-6), "m": ("mm", 1e3), "m2": ("mm2", 1e6), "N": ("kN", 1e-3), "s": ("ms", 1e3), "rad": ("mrad", 1e3)}


def header(name, unit):
    """"normal force [kN]" and the factor of the values, of a column with this unit in its file."""
    shown, factor = SHOWN.get(unit, (unit, 1))
    label = name.replace("_", " ")
    return (label if shown in ("", "1") else f"{label} [{shown}]"), factor


def write(path, columns):
    """Columns (header, values) of equal length; values that are not finite are left empty."""
    os.makedirs(os.path.dirname(path), exist_ok=True)
    with part_of(path) as part, open(part, "w", encoding="utf-8", newline="") as file:
        lines = csv.writer(file, lineterminator="\n")
        lines.writerow([head for head, _ in columns])
        for row in zip(*[values for _, values in columns]):
            lines.writerow([value if isinstance(value, str) else f"{value:.7g}" if np.isfinite(value) else "" for value in row])
    return path


def history_columns(table):
    """Columns of history.h5 or patch_history.h5."""
    found = []
    for name, values in table.items():
        head, factor = header(name, values.unit)
        found.append((head, factor * np.asarray(values, dtype=float)))
    return found


def patch_columns(tick, where):
    """The nodes of a patch, one a row; with their places on the rail where `where` (Sections) is known."""
    names = ["along", "lateral"] + [name for name in tick if name not in ("along", "lateral") and tick[name].ndim == 2]
    found = []
    for name in names:
        head, factor = header("lateral s" if name == "lateral" else name, tick[name].unit)
        found.append((head, factor * np.asarray(tick[name], dtype=float).ravel()))
    if where is not None:
        points = where.on_rail(found[1][1])
        found[2:2] = [("X from the running circle [mm]", points[:, 0]), ("Y from the top of the rail [mm]", points[:, 1]),
                      ("from the rail's axis to the gauge side [mm]", where.place(points.T)[0])]
    return found


def section_columns(tick, plane):
    """One plane through rail and wheel: a row for each point, the body in the first column."""
    bodies = [name for name in (plane + "_rail", plane + "_wheel") if name in tick]
    along = plane[0] == "A"
    columns = {"body": [], ("along [mm]" if along else "lateral s [mm]"): [], "depth [mm]": []}
    place, depth = list(columns)[1:]
    for name in bodies:
        group = tick[name]
        shape = (len(group["position"]), len(group["depth"]))
        columns["body"] += [name.rsplit("_", 1)[1]] * (shape[0] * shape[1])
        columns[place] += list(np.repeat(1e3 * np.asarray(group["position"]), shape[1]))
        columns[depth] += list(np.tile(1e3 * np.asarray(group["depth"]), shape[0]))
        for field in sorted(group):
            if group[field].shape == shape:
                head, factor = header(field, group[field].unit)
                columns.setdefault(head, [])
                columns[head] += list(factor * np.asarray(group[field], dtype=float).ravel())
    rows = len(columns["body"])
    return [(head, values) for head, values in columns.items() if len(values) == rows]


def write_all(run):
    """All tables of a result; returns their paths."""
    def path(name):
        return os.path.join(run.folder, "csv", name + ".csv")

    written = []
    if run.history:
        written.append(write(path("history"), history_columns(run.history)))
    if run.data.has("patch_history.h5"):
        written.append(write(path("patch_history"), history_columns(run.data.patch_history)))
    if run.patch is not None:
        written.append(write(path("patch"), patch_columns(run.patch, run.sections)))
        for number, tick in run.other_patches() if run.is_halfspace else ():
            written.append(write(path(f"patch_{number}"), patch_columns(tick, None)))
    name = f"tick_{run.tick:04d}" if run.tick is not None else ""
    if run.data.has("slices.h5") and name in run.data.slices.names:
        tick = run_data.tick_of(run.data.slices, run.tick)
        for plane in ("AA", "BB", "AA_peak", "BB_peak"):
            if plane + "_rail" in tick:
                written.append(write(path("section_" + plane), section_columns(tick, plane)))
    if run.sections is not None:
        lines = [(what, *point) for what, points in (("rail", run.sections.rail), ("wheel", run.sections.wheel)) for point in points]
        written.append(write(path("profiles"), list(zip(("body", "X from the running circle [mm]", "Y from the top of the rail [mm]"),
                                                        map(list, zip(*lines))))))
    return written
