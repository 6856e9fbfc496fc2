"""Results towards cells of no size, of a study over three sizes of Mesh/Solution cell size and more."""

import html
import os
import sys

import numpy as np

sys.path.insert(0, os.path.join(os.path.dirname(os.path.abspath(__file__)), os.pardir, "report"))

import page
import study_table

ENTRY = "Mesh/Solution cell size"
#: columns, and the power of the size with which they err (doc/theory/intervals.md)
ORDERS = {"max_pressure_Pa": 2, "contact_area_m2": 2, "max_shear_traction_Pa": 1, "creepage": 1, "t_gamma_N": 1,
          "largest_vertical_force_N": 2, "max_plastic_strain": 1, "max_residual_von_mises_Pa": 1}


def limit(sizes, values, order):
    """Value towards no size and its interval, by least squares over size^order: from there to the finest size, wider by a
    quarter of that and by the standard deviation of the fit (Eca and Hoekstra, 2014, equation 20)."""
    x, y = np.asarray(sizes, float) ** order, np.asarray(values, float)
    slope, end = np.polyfit(x, y, 1)
    finest = y[np.argmin(x)]
    scatter = np.sqrt(np.sum((y - end - slope * x) ** 2) / (len(x) - 2))
    wider = 0.25 * abs(finest - end) + scatter
    return end, min(end, finest) - wider, max(end, finest) + wider


def groups(study):
    """Cases that differ in the size alone: name of the rest, rows and sizes; of three sizes and more."""
    at = [a for a, axis in enumerate(study.axes) if axis["entry"] == ENTRY]
    found = {}
    for row, case in enumerate(study.cases if at else []):
        rest = ", ".join(f"{axis['name'].lower()} {value}" for a, (axis, value) in enumerate(zip(study.axes, case["values"]))
                         if a != at[0])
        found.setdefault(rest, []).append((row, study_table.number_of(case["values"][at[0]])))
    return {name: rows for name, rows in found.items() if len({size for _, size in rows}) >= 3}


def table(study, columns):
    """Lines of the page; nothing where no three sizes were computed."""
    shown = [columns[key] for key in ORDERS if key in columns]
    lines = []
    for name, rows in groups(study).items():
        cells = []
        for column in shown:
            known = [(size, column.values[row]) for row, size in rows if np.isfinite(column.values[row])]
            if len({size for size, _ in known}) < 3:
                cells.append("<td></td>")
                continue
            middle, low, high = (page.number(end, column.factor, column.decimals)
                                 for end in limit(*zip(*known), ORDERS[column.key]))
            cells.append(f"<td class=number>{middle} ({low} to {high})</td>")
        if any(cell != "<td></td>" for cell in cells):
            lines.append(f"<tr><td>{html.escape(name)}</td>{''.join(cells)}</tr>")
    if not lines:
        return []
    heads = "".join(f"<th>{html.escape(page.printed_header(column.header))}</th>" for column in shown)
    return ["<h2>Towards cells of no size</h2><p>Least squares over the sizes, with intervals of 95 %.</p><div class=wide>",
            f"<table><tr><th></th>{heads}</tr>", *lines, "</table></div>"]
