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

PAIRS = ["2:10", "1:0.1", "1:1", "1:3", "1:10", "1:30", "0.5:10"]
FIGURES = {
    "max_pressure": "peak pressure",
    "contact_area": "area",
    "max_shear_traction": "peak shear",
    "creepage": "creepage",
}


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
    figure, axes = plt.subplots(1, len(FIGURES), figsize=(4 * len(FIGURES), 3.8), constrained_layout=True, sharey=True)
    for axis, (key, label) in zip(axes, FIGURES.items()):
        for row in rows:
            axis.plot(abs(row[key]), row["wall_s"], "o")
            axis.annotate(
                f"{row['cell_mm']} mm, f = {row['penalty_scale']}",
                (abs(row[key]), row["wall_s"]),
                fontsize=7,
                xytext=(4, 4),
                textcoords="offset points",
            )
        axis.set_xscale("symlog", linthresh=0.5)
        axis.set_yscale("log")
        axis.margins(0.25)
        axis.set_xlabel(f"error of the {label} [%]")
        axis.grid(True, which="both", alpha=0.3)
    axes[0].set_ylabel("wall time [s]")
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
