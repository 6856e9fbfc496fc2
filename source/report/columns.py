"""Tables of the program as arrays."""

import csv

import numpy as np


def read(path):
    """Columns of a table with commas by their names; nan where a cell is empty."""
    with open(path, encoding="utf-8", newline="") as file:
        lines = csv.reader(file)
        names = next(lines)
        rows = [[float(cell) if cell else np.nan for cell in line] for line in lines]
    return {name: np.array([row[k] for row in rows]) for k, name in enumerate(names)}
