"""Tables of the program as arrays."""

import csv
import os
import sys

import numpy as np


def read(path):
    """Columns of a table with commas by their names; nan where a cell is empty."""
    with open(path, encoding="utf-8", newline="") as file:
        lines = csv.reader(file)
        names = next(lines)
        rows = [[float(cell) if cell else np.nan for cell in line] for line in lines]
    return {name: np.array([row[k] for row in rows]) for k, name in enumerate(names)}


def draw(arguments, usage, name, figure_of):
    """Draws pictures/NAME.png from NAME.csv of the folder in `arguments`; figure_of(table, folder) makes it. An exit code."""
    if len(arguments) != 1:
        print(usage, file=sys.stderr)
        return 1
    folder = os.path.join(arguments[0], "pictures")
    try:
        figure = figure_of(read(os.path.join(arguments[0], name + ".csv")), arguments[0])
        figure.tight_layout()
        os.makedirs(folder, exist_ok=True)
        figure.savefig(os.path.join(folder, name + ".png"))
    except OSError as error:
        print(error, file=sys.stderr)
        return 1
    print(f"Picture in {os.path.join(folder, name + '.png')}")
    return 0
