"""Pictures over the rolled distance: forces, energy error, creepage."""

import matplotlib.pyplot as plt
import numpy as np

import page
import run_data
import style


def abscissa(history):
    """Rolled distance in mm, or time in ms, or the row number."""
    for name, label, factor in (("rolled_distance", "rolled distance [mm]", 1e3), ("time", "time [ms]", 1e3)):
        if name in history:
            return factor * history[name][1], label
    return np.arange(len(next(iter(history.values()))[1])), "row"


def plain(name):
    return name.replace("_", " ")


def draw_forces(run, x, label):
    history = run.history
    names = [name for name, (unit, values) in history.items() if unit == "N" and np.isfinite(values).any()]
    large = [name for name in names if name in ("normal_force", "vertical_force")]
    small = [name for name in names if name not in large]
    groups = [group for group in (large, small) if group]
    if not groups:
        return []
    figure, rows = plt.subplots(len(groups), 1, figsize=(7.6, 1.0 + 2.3 * len(groups)), sharex=True, squeeze=False)
    for axes, group in zip(rows[:, 0], groups):
        for name, color in zip(group, style.COLORS):
            axes.plot(x, 1e-3 * history[name][1], color=color, linewidth=1.2, label=plain(name))
        axes.set_ylabel("force [kN]")
        axes.grid(True)
        axes.margins(x=0)
        axes.ticklabel_format(axis="y", useOffset=False)
        axes.legend(loc="upper left", bbox_to_anchor=(1.01, 1), borderaxespad=0)
    rows[0, 0].set_title("Forces on the wheel")
    rows[-1, 0].set_xlabel(label)
    return [("Forces on the wheel", style.save(run, figure, "forces"))]


def draw_single(run, x, label, name):
    """The history of a figure of the summary in its own unit, or in SI units where that is not known."""
    if name not in run.history or not np.isfinite(run.history[name][1]).any():
        return []
    unit, values = run.history[name]
    known = run_data.figure_of(run, name)
    title = page.label_text(known) if known else plain(name)
    unit, factor = (page.unit_text(known), known["factor"]) if known else (unit, 1)
    figure, axes = plt.subplots(figsize=(7.6, 2.9))
    axes.plot(x, factor * values, color=style.BLUE, linewidth=1.2)
    axes.axhline(0, color=style.GREY, linewidth=0.7)
    axes.grid(True)
    axes.margins(x=0)
    axes.set_xlabel(label)
    axes.set_ylabel(f"{plain(name)} [{unit}]")
    axes.set_title(title)
    return [(title, style.save(run, figure, name))]


def draw_all(run):
    """All pictures of the history, a list of (caption, path)."""
    if not run.history:
        return []
    if len(next(iter(run.history.values()))[1]) < 2:
        run.remarks.append("The history has fewer than two rows; its pictures are left out.")
        return []
    x, label = abscissa(run.history)
    return (draw_forces(run, x, label) + draw_single(run, x, label, "energy_error") +
            draw_single(run, x, label, "creepage"))
