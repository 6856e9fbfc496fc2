"""Time and memory over the length of the path, with the window that moves and with fine cells all along the path.

    python3 benchmarks/path_cost.py PICTURE.png [FILE.prm] [--set ENTRY=VALUE ...] [--lengths 60 120 ...]

Runs FILE.prm (prm/quickstart.prm) with both on one rank over rising distances [mm] in a folder of its own, prints a
table and draws it. The rail is long enough for the longest path in all runs, so that far cells do not differ.
"""

import argparse
import json
import subprocess
import tempfile
from pathlib import Path

import matplotlib

matplotlib.use("Agg")
import matplotlib.pyplot as plt

HOME = Path(__file__).resolve().parent.parent
WINDOWS = {"moving": "window that moves", "fixed": "fine cells all along the path"}
FIGURES = {"wall_time_s": ("wall time [s]", 1), "peak_memory_bytes": ("memory [GB]", 1e-9),
           "elements": ("hexahedra [thousands]", 1e-3)}


def summary_of(scene, length, window, entries, folder):
    entries = entries + [f"Mesh/Window = {window}", f"Run/Rolling distance = {length} mm", "Output/Ticks = 2",
                         "Output/Volume fields = false", f"Output/Folder = {folder}"]
    command = [str(HOME / "wheelrail"), "run", "--ranks", "1", str(scene)]
    for entry in entries:
        command += ["--set", entry]
    subprocess.run(command, check=True, stdout=subprocess.DEVNULL)
    return json.loads((Path(folder) / "summary.json").read_text())


def draw(rows, picture):
    figure, axes = plt.subplots(1, len(FIGURES), figsize=(4 * len(FIGURES), 3.6), constrained_layout=True)
    for axis, (key, (label, unit)) in zip(axes, FIGURES.items()):
        for window, style in (("moving", "o-"), ("fixed", "s--")):
            of_window = [row for row in rows if row["window"] == window]
            axis.plot([row["length"] for row in of_window], [unit * row[key] for row in of_window], style,
                      label=WINDOWS[window])
        axis.set_xlabel("rolled distance [mm]")
        axis.set_ylabel(label)
        axis.set_xlim(left=0)
        axis.set_ylim(bottom=0)
        axis.grid(alpha=0.3)
    axes[0].legend(frameon=False, fontsize=9)
    figure.savefig(picture, dpi=120)


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("picture")
    parser.add_argument("scene", nargs="?", default=HOME / "prm/quickstart.prm")
    parser.add_argument("--set", action="append", default=[], dest="entries", metavar="ENTRY=VALUE")
    parser.add_argument("--lengths", nargs="+", type=int, default=[60, 120, 240, 480], metavar="MM")
    options = parser.parse_args()
    entries = [f"Track/Rail length = {max(options.lengths) + 600} mm"] + options.entries
    rows = []
    print(" path [mm]  window   wall time [s]  memory [GB]  hexahedra  peak [MPa]  energy error [%]")
    for length in options.lengths:
        for window in WINDOWS:
            with tempfile.TemporaryDirectory() as folder:
                found = summary_of(options.scene, length, window, entries, folder + "/run")
            rows.append({"length": length, "window": window, **{key: found[key] for key in FIGURES}})
            print(f"{length:10d}  {window:7s}  {found['wall_time_s']:13.1f}  {1e-9 * found['peak_memory_bytes']:11.2f}  "
                  f"{found['elements']:9.0f}  {1e-6 * found['max_pressure_Pa']:10.1f}  {100 * found['energy_error']:16.3f}",
                  flush=True)
            draw(rows, options.picture)


if __name__ == "__main__":
    main()
