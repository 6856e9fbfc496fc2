"""Wear across the rail: depth of one passage and work of friction, summed along the track, from wear.csv."""

import os

import matplotlib.pyplot as plt
import numpy as np

import columns
import style

CURVES = [("archard_depth_m", 1e9, "depth of one passage,\nafter Archard [nm]"),
          ("friction_work_N_per_m", 1e-3, "work of friction for each metre\nrolled and mm of width [N/mm]")]


def draw_all(run):
    """List of title and path; empty where the folder has no table of wear."""
    path = run.data.path("wear.csv")
    if not os.path.exists(path):
        return []
    table = columns.read(path)
    if not np.any(table["archard_depth_m"] > 0):
        return []
    figure, all_axes = plt.subplots(len(CURVES), 1, figsize=(7, 5), sharex=True, constrained_layout=True)
    patches = np.unique(table["patch"])
    worn = table["archard_depth_m"] > 0
    for axes, (key, factor, text) in zip(all_axes, CURVES):
        for patch, color in zip(patches, style.COLORS):
            rows = (table["patch"] == patch) & worn
            axes.plot(1e3 * table["lateral_m"][rows], factor * table[key][rows], color=color, label=f"patch {patch:g}")
        axes.set_ylim(bottom=min(0, axes.get_ylim()[0]))
        axes.set_ylabel(text)
        axes.grid(True)
    if len(patches) > 1:
        all_axes[0].legend()
    all_axes[0].invert_xaxis()
    all_axes[-1].set_xlabel("lateral s [mm]   (G.C. on the left, F.S. on the right)")
    all_axes[0].set_title("Wear across the rail")
    path = os.path.join(run.pictures_folder, "wear.png")
    figure.savefig(path)
    plt.close(figure)
    return [("Wear across the rail, of one passage", path)]
