"""The tables of a study: one row a case, one column a figure, with its unit in the header.

    table.csv   figures, in the units of the summary on the screen; the same after every resume
    costs.csv   what the cases cost: time, memory, steps
    table.h5    both in SI, under the keys of summary.json, with the attribute `unit`
"""

import csv
import io
import os
import sys

import numpy as np

try:
    import h5py
except ImportError as error:
    raise SystemExit(f"{error}; install the Debian package python3-h5py") from error

sys.path.insert(0, os.path.join(os.path.dirname(os.path.abspath(__file__)), os.pardir, "report"))

import page
from study_folder import SOURCES, replace
from whole_file import part_of

# figures that say what a run cost; they are not the same from run to run, or from machine to machine
COSTS = ["wall_time_s", "ranks", "peak_memory_bytes", "elements", "time_steps", "time_step_s", "element_updates_per_second"]

# main figures of a wheelset, which only half-spaces have
WHEELSET = ["axle_lateral_shift_m", "axle_yaw_rad", "right_lateral_over_vertical", "right_t_gamma_N", "left_t_gamma_N",
            "right_max_pressure_Pa"]

# of irregular surfaces
IMPACT = ["largest_vertical_force_N", "impact_factor", "contact_loss_m", "largest_pressure_Pa"]

# columns on the screen, as far as there are such figures
SHOWN = (IMPACT + ["max_pressure_Pa", "contact_area_m2", "max_shear_traction_Pa", "creepage", "stick_fraction"]
         + WHEELSET)


class Column:
    """Values of a figure for all cases, NaN where there is none, from one of SOURCES; shown times `factor`. `title` is the
    header without what it is that of."""

    def __init__(self, figure, source, values, std=None, error=None, low=None, high=None):
        of_wheelset = figure["key"].startswith(("axle_", "right_", "left_"))
        tail = ", " + SOURCES[source].lower() if source and not of_wheelset else ""
        self.key, self.title = source + figure["key"], header(figure["label"], figure["unit"])
        self.header = header(figure["label"] + tail, figure["unit"])
        self.si, self.factor, self.decimals = si_unit(figure), figure["factor"], figure["decimals"]
        self.values = np.array(values, dtype=float)
        self.std, self.error, self.low, self.high = std, error, low, high

    def text(self, row):
        value = self.values[row] * self.factor
        return f"{value:.7g}" if np.isfinite(value) else ""


def number_of(value):
    """The number of an axis' value as the listing writes it ("-5.5 mm"); None for a word."""
    try:
        return float(value.split(" ", 1)[0])
    except ValueError:
        return None


def unit_of(axis):
    """The unit of the numbers of an axis."""
    units = [value.split(" ", 1)[1] for value in axis["values"] if number_of(value) is not None and " " in value]
    return units[0] if units else ""


def header(label, unit):
    return f"{label} [{unit}]" if unit else label


def axis_columns(study):
    """Header and texts of each axis."""
    columns = []
    for a, axis in enumerate(study.axes):
        texts = [case["values"][a] for case in study.cases]
        numbers = [number_of(text) for text in texts]
        cells = [text if number is None else text.split(" ", 1)[0] for text, number in zip(texts, numbers)]
        # rail and wheel have entries of one name
        several = sum(other["name"] == axis["name"] for other in study.axes) > 1
        columns.append((header(axis["entry"] if several else axis["name"], unit_of(axis)), cells))
    return columns


def si_unit(figure):
    """The SI unit that a key ends with: "Pa" of "max_pressure_Pa"."""
    tail = figure["key"][len(figure["std_key"].split("_std")[0]):]
    return tail.lstrip("_")


def number(value):
    return value if isinstance(value, (int, float)) and not isinstance(value, bool) else np.nan


def columns_of(study):
    """All columns with at least one value, runs, half-spaces and true bodies beside each other."""
    pairs = [study.summaries(case) for case in study.cases]
    columns = []
    for figure in study.figures:
        for index, prefix in enumerate(SOURCES):
            values = [number((pair[index] or {}).get(figure["key"])) for pair in pairs]
            if not np.isfinite(values).any() or (index > 0 and figure["key"] in COSTS):
                continue
            beside = ([number((pair[index] or {}).get(figure.get(name))) for pair in pairs]
                      for name in ("std_key", "error_key", "low_key", "high_key"))
            columns.append(Column(figure, prefix, values, *(each if np.isfinite(each).any() else None for each in beside)))
    return columns


def as_csv(rows):
    text = io.StringIO()
    csv.writer(text, lineterminator="\n").writerows(rows)
    return text.getvalue()


def verdict(pair):
    """The verdict of a case and why, "" where there are no figures: that of its run, its true bodies, or its half-spaces."""
    summary = pair[0] or pair[2] or pair[1] or {}
    return page.verdict_of(summary), summary.get("doubts") or ""


def ended(pair):
    """How the run of a case ended: steady, not steady, distance; "" where there is none, or an older one."""
    return (pair[0] or {}).get("ended") or ""


def trusted(pair):
    """The column of before there were three verdicts: yes, no, or nothing where there are no figures."""
    word = verdict(pair)[0]
    return word and ("yes" if word == "trusted" else "no")


def write(study, failures):
    """Writes the three tables; returns the columns."""
    columns = columns_of(study)
    axes = axis_columns(study)
    states = [study.state(case, failures) for case in study.cases]
    rows = range(len(study.cases))
    for name, chosen in (("table.csv", [c for c in columns if c.key not in COSTS]),
                         ("costs.csv", [c for c in columns if c.key in COSTS])):
        is_table = name == "table.csv"
        lines = [[head for head, _ in axes] + ["state"] + (["ended", "verdict", "trusted"] if is_table else []) +
                 [column.header for column in chosen] + (["remark", "doubts"] if is_table else []) + ["folder"]]
        for row in rows:
            case = study.cases[row]
            pair = study.summaries(case)
            word, doubts = verdict(pair)
            lines.append([cells[row] for _, cells in axes] + [states[row].word] +
                         ([ended(pair), word, trusted(pair)] if is_table else []) +
                         [column.text(row) for column in chosen] +
                         ([states[row].sentence, doubts] if is_table else []) + [case["name"]])
        replace(study.path(name), as_csv(lines))
    write_hdf5(study, columns, states)
    return columns


def write_hdf5(study, columns, states):
    path = study.path("table.h5")
    with part_of(path) as part, h5py.File(part, "w") as file:
        file.attrs["title"], file.attrs["program_version"] = study.title, study.version
        for a, axis in enumerate(study.axes):
            values = [case["values"][a] for case in study.cases]
            numbers = [number_of(value) for value in values]
            group = f"axis_{a}"
            if None in numbers:
                file[group] = np.array(values, dtype=h5py.string_dtype())
            else:
                file[group] = np.array(numbers)
            file[group].attrs["entry"], file[group].attrs["unit"] = axis["entry"], unit_of(axis)
        for name, values in (("case", [case["name"] for case in study.cases]),
                             ("state", [state.word for state in states]),
                             ("ended", [ended(study.summaries(case)) for case in study.cases]),
                             ("verdict", [verdict(study.summaries(case))[0] for case in study.cases]),
                             ("remark", [state.sentence for state in states])):
            file[name] = np.array(values, dtype=h5py.string_dtype())
        for column in columns:
            for key, values in ((column.key, column.values), (column.key + "_std", column.std),
                                (column.key + "_error", column.error), (column.key + "_low", column.low),
                                (column.key + "_high", column.high)):
                if values is not None:
                    file[key] = values
                    file[key].attrs["unit"] = column.si


def show(study):
    """The main figures on the screen."""
    columns = {column.key: column for column in columns_of(study)}
    axes = axis_columns(study)
    rows = [[head for head, _ in axes] + ["verdict"]]
    rows += [[cells[row] for _, cells in axes] + [verdict(study.summaries(case))[0] or "-"]
             for row, case in enumerate(study.cases)]
    for key in SHOWN:
        for prefix in SOURCES:
            column = columns.get(prefix + key)
            if column is None:
                continue
            beside = column.key != key and key in columns
            rows[0].append(SOURCES[prefix].lower().replace("-", "- ") if beside else column.header)
            for row in range(len(study.cases)):
                value = column.values[row] * column.factor
                rows[row + 1].append(f"{value:.{column.decimals}f}" if np.isfinite(value) else "-")
    # headers of several lines, broken at blanks
    heads = [wrapped(head) for head in rows[0]]
    height = max(len(head) for head in heads)
    widths = [max([len(line) for line in head] + [len(row[i]) for row in rows[1:]]) for i, head in enumerate(heads)]
    for line in range(height):
        print("  ".join((([""] * (height - len(head)) + head)[line]).rjust(width) for head, width in zip(heads, widths)))
    for row in rows[1:]:
        print("  ".join(cell.rjust(width) for cell, width in zip(row, widths)))


def wrapped(text, width=11):
    lines = [""]
    for word in text.split(" "):
        if lines[-1] and len(lines[-1]) + 1 + len(word) > width:
            lines.append(word)
        else:
            lines[-1] = (lines[-1] + " " + word).strip()
    return lines
