"""Error and wall time of a rolling scene over cell size and penalty scale.

    benchmarks/rolling_accuracy.py OUT.csv PICTURE.png [SCENE.prm [CELL_MM:SCALE ...]]

Runs the scene (prm/rolling.prm, 40 mm of rolling) once for each pair of solution cell size and penalty
scale, compares each run with half-spaces under its own load and in its own pose (wheelrail compare), writes
a table and draws wall time over the errors. Takes some ten minutes with the default pairs. To be started in
the top folder."""

import csv
import json
import subprocess
import sys
import tempfile

import matplotlib

matplotlib.use("Agg")
import matplotlib.pyplot as plt
from matplotlib import ticker

PAIRS = ["2:10", "1:0.1", "1:1", "1:3", "1:10", "1:30", "0.5:10"]
FIGURES = {
    "max_pressure": "peak pressure",
    "contact_area": "area",
    "max_shear_traction": "peak shear",
    "creepage": "creepage",
}

SMALLEST = 0.1  # per cent; smaller errors are drawn there


def measure(scene, cell, scale):
    """One row of the table: the relative differences from half-spaces and the time of the run."""
    with tempfile.TemporaryDirectory() as folder:
        out = folder + "/run"
        sets = {
            "Output/Folder": out,
            "Output/Volume fields": "false",
            "Run/Rolling distance": "40 mm",
            "Mesh/Solution cell size": cell + " mm",
            "Contact/Penalty scale": scale,
        }
        command = ["./wheelrail", "run", scene]
        for entry, value in sets.items():
            command += ["--set", entry + " = " + value]
        subprocess.run(command, check=True, stdout=subprocess.DEVNULL)
        subprocess.run(["./wheelrail", "compare", out], check=True, stdout=subprocess.DEVNULL)
        with open(out + "/summary.json", encoding="utf-8") as file:
            summary = json.load(file)
    row = {"cell_mm": cell, "penalty_scale": scale, "wall_s": round(summary["wall_time_s"], 1)}
    for key in FIGURES:
        row[key] = round(100 * summary["relative_difference_" + key], 2)
    return row


def draw(rows, picture):
    figure, axes = plt.subplots(2, 2, figsize=(9, 7.5), constrained_layout=True, sharey=True)
    plain = ticker.FuncFormatter(lambda value, _: f"{value:g}")
    for axis, (key, label) in zip(axes.flat, FIGURES.items()):
        for cell in sorted({float(row["cell_mm"]) for row in rows}):
            points = sorted(
                (float(row["penalty_scale"]), max(SMALLEST, abs(float(row[key]))), float(row["wall_s"]))
                for row in rows
                if float(row["cell_mm"]) == cell
            )
            axis.plot([p[1] for p in points], [p[2] for p in points], "o-", label=f"cells of {cell:g} mm")
            for k, (scale, error, time) in enumerate(points):
                axis.annotate(
                    f"f = {scale:g}",
                    (error, time),
                    fontsize=8,
                    ha="center",
                    xytext=(0, 7 if k % 2 else -14),
                    textcoords="offset points",
                )
        axis.set(xscale="log", yscale="log", xlabel=f"error of the {label} [%]")
        axis.xaxis.set_major_formatter(plain)
        axis.yaxis.set_major_locator(ticker.LogLocator(subs=(1, 2, 5)))
        axis.yaxis.set_major_formatter(plain)
        axis.yaxis.set_minor_formatter(ticker.NullFormatter())
        axis.margins(0.15)
        axis.grid(True, which="both", alpha=0.3)
    for axis in axes[:, 0]:
        axis.set_ylabel("wall time [s]")
    axes[0, 0].legend()
    figure.savefig(picture, dpi=120)


def main(table, picture, scene="prm/rolling.prm", *pairs):
    rows = []
    for pair in pairs or PAIRS:
        rows.append(measure(scene, *pair.split(":")))
        print(", ".join(f"{key} {value}" for key, value in rows[-1].items()), flush=True)
        with open(table, "w", newline="", encoding="utf-8") as file:
            writer = csv.DictWriter(file, rows[0])
            writer.writeheader()
            writer.writerows(rows)
    draw(rows, picture)


if __name__ == "__main__":
    if len(sys.argv) < 3:
        sys.exit(__doc__)
    main(*sys.argv[1:])
