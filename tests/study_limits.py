"""Least squares towards cells of no size, and the cases of a study that they take.

Usage: study_limits.py SOURCE_FOLDER
"""

import os
import sys
from types import SimpleNamespace

from checks import check, finish

sys.path.insert(0, os.path.join(sys.argv[1], "source", "study"))

import cell_limits  # noqa: E402
import numpy as np  # noqa: E402

middle, low, high = cell_limits.limit([2, 1, 0.5], [1240 - 7 * h * h for h in (2, 1, 0.5)], 2)
check(abs(middle - 1240) < 1e-6, f"an error of second order is taken off, {middle:.3f}")
check(low < 1240 - 7 * 0.25 and high > 1240, f"finest size and limit lie within {low:.2f} to {high:.2f}")
middle, low, high = cell_limits.limit([2, 1, 0.5], [2.1, 2.2, 2.14], 1)
check(low < 2.14 < high and high - low > 0.05, f"scatter widens it, {low:.3f} to {high:.3f}")

axes = [{"entry": "Contact/Penalty scale", "name": "Penalty scale"}, {"entry": cell_limits.ENTRY, "name": "Solution cell size"}]
values = [("10", "2 mm"), ("1", "2 mm"), ("10", "1 mm"), ("1", "1 mm"), ("10", "0.5 mm")]
study = SimpleNamespace(axes=axes, cases=[{"values": value} for value in values])
check(cell_limits.groups(study) == {"penalty scale 10": [(0, 2.0), (2, 1.0), (4, 0.5)]}, "cases that differ in the size alone")
column = SimpleNamespace(key="max_pressure_Pa", factor=1e-6, decimals=1, header="peak pressure [MPa]",
                         values=1e6 * np.array([1212, 900, 1233, 1100, 1238.25]))
lines = "".join(cell_limits.table(study, {column.key: column}))
check("penalty scale 10" in lines and "1240.0 (1237.8 to 1240.4)" in lines, f"table of the page {lines[-80:]}")
check(cell_limits.table(SimpleNamespace(axes=axes[:1], cases=[]), {}) == [], "nothing without sizes")
finish()
