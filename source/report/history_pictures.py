"""Pictures over the rolled distance: forces, energy error, creepage, results of the patch."""

import matplotlib.pyplot as plt
import numpy as np

import page
import run_data
import style


def abscissa(history):
    """Rolled distance in mm, or time in ms, or the row number."""
    for name, label, factor in (("rolled_distance", "rolled distance [mm]", 1e3), ("time", "time [ms]", 1e3)):
        if name in history:
            return factor * history[name], label
    return np.arange(len(next(iter(history.values())))), "row"


def plain(name):
    return name.replace("_", " ")


#: titles of force_groups(): what carries the load, and the rest, which is much smaller
FORCE_TITLES = ("Normal and vertical forces", "Longitudinal and lateral forces")


def force_groups(history):
    """Names of the forces that carry the load and of the others, those that are there; shares of two rails are in
    irregular_pictures."""
    names = [name for name, values in history.items()
             if values.unit == "N" and np.isfinite(values).any() and not name.endswith("_rail_force")]
    large = [name for name in names if name in ("normal_force", "vertical_force", "axle_vertical_force", "wheel_load")]
    return [group for group in (large, [name for name in names if name not in large]) if group]


def shown_as(run, name, values):
    """Title, label of the axis with the unit, and factor of a column: those of the figure of that name."""
    known = next((figure for figure in run.figures
                  if figure["key"] == name or figure["key"].startswith(name + "_")), None)
    title = page.label_text(known) if known else plain(name)
    unit, factor = (page.unit_text(known), known["factor"]) if known else (values.unit, 1)
    return title, f"{plain(name)} [{unit}]" if unit else plain(name), factor


def mean_of(run, name, factor):
    """Mean of a column in shown units, and begin and end of the stretch over which it is taken [mm]; None where the
    summary does not have the first two."""
    summary = run.summary or {}
    known = next((figure for figure in run.figures if figure["std_key"].split("_std")[0] == name), None)
    value, begin = summary.get(known["key"]) if known else None, summary.get("means_from_m")
    if not (page.is_number(value) and page.is_number(begin)):
        return None
    end = summary.get("means_to_m")  # unknown to earlier versions
    return factor * value, 1e3 * begin, 1e3 * (end if page.is_number(end) else run.history["rolled_distance"][-1])


def draw_mean(axes, mean, color, told=True):
    """A dashed line over the stretch of the mean, with its value."""
    if mean is None:
        return
    axes.plot(mean[1:], [mean[0], mean[0]], color=color, linewidth=1.6, linestyle=(0, (4, 2)))
    if told:
        axes.annotate(f"mean {mean[0]:.2f}", (mean[2], mean[0]), (-4, 4), textcoords="offset points", ha="right",
                      va="bottom", fontsize=8, color=color)


def draw_forces(run, x, label):
    groups = force_groups(run.history)
    if not groups:
        return []
    figure, rows = plt.subplots(len(groups), 1, figsize=(7.6, 1.0 + 2.3 * len(groups)), sharex=True, squeeze=False)
    for axes, group in zip(rows[:, 0], groups):
        for name, color in zip(group, style.COLORS):
            mean = mean_of(run, name, 1e-3)
            axes.plot(x, 1e-3 * run.history[name], color=color, linewidth=1.2,
                      label=plain(name) + (f", mean {mean[0]:.2f}" if mean else ""))
            draw_mean(axes, mean, color, told=False)
        axes.set_ylabel("force [kN]")
        axes.grid(True)
        axes.margins(x=0)
        axes.ticklabel_format(axis="y", useOffset=False)
        style.legend_beside(axes)
    rows[0, 0].set_title("Forces on the wheel")
    rows[-1, 0].set_xlabel(label)
    return [("Forces on the wheel", style.save(run, figure, "forces"))]


def draw_motion(run, x, label):
    """How a wheelset was led that follows a motion."""
    names = [name for name in ("lateral_shift", "wheelset_roll", "yaw", "velocity")
             if name in run.history and np.ptp(run.history[name]) > 0]
    if "lateral_shift" not in run.history or not names:
        return []
    figure, rows = plt.subplots(len(names), 1, figsize=(7.6, 1.0 + 1.7 * len(names)), sharex=True, squeeze=False)
    for axes, name in zip(rows[:, 0], names):
        _, axis_label, factor = shown_as(run, name, run.history[name])
        axes.plot(x, factor * run.history[name], color=style.BLUE, linewidth=1.2)
        axes.set_ylabel(axis_label)
        axes.grid(True)
        axes.margins(x=0)
        axes.ticklabel_format(axis="y", useOffset=False)
    rows[0, 0].set_title("Motion that the wheelset follows")
    rows[-1, 0].set_xlabel(label)
    return [("Motion that the wheelset follows", style.save(run, figure, "motion"))]


def draw_single(run, x, label, name):
    """The history of a figure of the summary in its own unit, or in SI units where that is not known."""
    if name not in run.history or not np.isfinite(run.history[name]).any():
        return []
    title, axis_label, factor = shown_as(run, name, run.history[name])
    figure, axes = plt.subplots(figsize=(7.6, 2.9))
    axes.plot(x, factor * run.history[name], color=style.BLUE, linewidth=1.2)
    draw_mean(axes, mean_of(run, name, factor), style.RED)
    axes.axhline(0, color=style.GREY, linewidth=0.7)
    axes.grid(True)
    axes.margins(x=0)
    axes.set_xlabel(label)
    axes.set_ylabel(axis_label)
    axes.set_title(title)
    return [(title, style.save(run, figure, name))]


def groups(run):
    """The curves of the interactive view: title -> (label of the axis, [(name, distance in mm, values, mean)])."""
    if "rolled_distance" not in run.history or len(run.history["rolled_distance"]) < 2:
        return {}
    x = 1e3 * run.history["rolled_distance"]
    shown = {}
    for title, group in zip(FORCE_TITLES, force_groups(run.history)):
        shown[title] = ("force [kN]", [(plain(name), x, 1e-3 * run.history[name], mean_of(run, name, 1e-3)) for name in group])
    columns = [(name, x, run.history[name]) for name in ("creepage", "energy_error") if name in run.history]
    if run.data.has("patch_history.h5"):
        table = run.data.patch_history
        columns += [(name, 1e3 * table["rolled_distance"], values) for name, values in table.items()
                    if name != "rolled_distance"]
    for name, distance, values in columns:
        if np.isfinite(values).any():
            title, label, factor = shown_as(run, name, values)
            shown[title] = (label, [(plain(name), distance, factor * values, mean_of(run, name, factor))])
    return shown


def draw_all(run):
    """All pictures of the history, a list of (caption, path)."""
    if not run.history:
        return []
    if len(next(iter(run.history.values()))) < 2:
        run.remarks.append("The history has fewer than two rows; its pictures are left out.")
        return []
    x, label = abscissa(run.history)
    return (draw_forces(run, x, label) + draw_motion(run, x, label) + draw_single(run, x, label, "creepage") +
            draw_single(run, x, label, "energy_error"))
