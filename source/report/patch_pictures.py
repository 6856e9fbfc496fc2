"""Pictures of the contact patch: panels, surfaces, cuts AA and BB, shear at chosen instants."""

import matplotlib.pyplot as plt
import numpy as np
from matplotlib.ticker import MaxNLocator

import cuts
import maps
import run_data
import style
from fields import Fields


def draw_surface(run, fields, values, label, title, name):
    figure = plt.figure(figsize=(7.4, 5.4))
    axes = figure.add_subplot(projection="3d")
    peak = max(values.max(), 1e-9)
    top = style.round_top(peak)
    surface = axes.plot_surface(fields.lateral, fields.along, values, cmap=style.HIGH, rstride=1, cstride=1,
                                linewidth=0.15, edgecolor="#00000055", antialiased=True, vmin=0, vmax=peak)
    axes.set_box_aspect((np.ptp(fields.lateral), np.ptp(fields.along), 0.6 * np.ptp(fields.lateral)))
    axes.set_xlabel("lateral s [mm]\nG.C. $\\leftarrow$   $\\rightarrow$ F.S.", labelpad=14)
    axes.set_ylabel("rolling direction [mm] $\\rightarrow$", labelpad=8)
    axes.set_xlim(fields.lateral.max(), fields.lateral.min())  # s to the left, as in the maps
    axes.set_zlim(0, top)
    axes.xaxis.set_major_locator(MaxNLocator(5))
    axes.yaxis.set_major_locator(MaxNLocator(5))
    axes.view_init(elev=28, azim=-58)
    axes.set_title(title)
    bar = figure.colorbar(surface, cax=figure.add_axes([0.95, 0.22, 0.022, 0.5]))
    bar.set_label(label)
    levels = style.levels_to(peak)
    bar.set_ticks(levels, labels=[f"{level:.4g}" for level in levels])
    return style.save(run, figure, name, pad=0.5)


def new_map(scale):
    """A figure for one map whose shape follows the patch."""
    return plt.subplots(figsize=(6.4, 1.4 + 5.2 * min(max(scale.ratio, 0.4), 1.6)))


def draw_maps(run, fields):
    """Each panel as a picture of its own."""
    scale = maps.Scale(fields, peaks=run.peaks)
    names = ("pressure_contour", "shear_contour", "stick_slip")
    captions = ("Normal pressure, contours", "Shear traction on the rail, contours and directions", "Stick and slip")
    pictures = []
    for (draw, bar, title), name, caption in zip(maps.PANELS, names, captions):
        figure, axes = new_map(scale)
        bar(figure, axes, draw(axes, fields, scale, title))
        pictures.append((caption, style.save(run, figure, name)))
    return pictures


def draw_instants(run):
    """Shear traction at the chosen instants, one scale, and where they lie on the longitudinal force."""
    ticks = [run_data.tick_of(run.patches, number) for number in run.instants]
    fields = [Fields(tick, margin=4) for tick in ticks]
    scale = maps.Scale(*fields)
    figure = plt.figure(figsize=(5.6 * len(ticks) + 1, 3.2 + 5.4 * min(max(scale.ratio, 0.5), 1.4)))
    grid = figure.add_gridspec(2, len(ticks), height_ratios=(1, 2.2), hspace=0.42, wspace=0.22)
    names = [chr(ord("A") + k) if len(ticks) <= 26 else str(k + 1) for k in range(len(ticks))]
    if run.history and "longitudinal_force" in run.history:
        axes = figure.add_subplot(grid[0, :])
        rolled, force = 1e3 * run.history["rolled_distance"], 1e-3 * run.history["longitudinal_force"]
        axes.plot(rolled, force, color=style.BLUE, linewidth=1.2)
        for name, tick in zip(names, ticks):
            place = 1e3 * tick.attributes["rolled_distance_m"]
            axes.axvline(place, color=style.RED, linewidth=0.9, linestyle="--")
            axes.annotate(name, (place, np.interp(place, rolled, force)), textcoords="offset points", xytext=(4, 6),
                          weight="bold", color=style.RED)
        axes.set_xlabel("rolled distance [mm]")
        axes.set_ylabel("longitudinal force\non the wheel [kN]")
        axes.margins(x=0.02, y=0.15)
        axes.grid(True)
    for k, (name, tick, field) in enumerate(zip(names, ticks, fields)):
        axes = figure.add_subplot(grid[1, k])
        image = maps.shear(axes, field, scale, f"{name}: {1e3 * tick.attributes['rolled_distance_m']:.1f} mm rolled")
    maps.shear_bar(figure, axes, image)
    return [("Shear traction at the chosen instants", style.save(run, figure, "shear_instants"))]


def draw_others(run, prefix=""):
    """The further patches of a half-space solution, each in a plane of its own."""
    pictures = []
    for number, tick in run.other_patches():
        if tick["pressure"].max() > 0 and min(tick["pressure"].shape) > 1:
            figure = maps.draw_panels({"": Fields(tick, margin=4)})
            pictures.append((f"Patch {number} in its own plane: pressure, shear traction, stick and slip",
                             style.save(run, figure, f"{prefix}sheet_patch_{number}")))
    return pictures


def draw_all(run):
    """All pictures of the patch, a list of (caption, path)."""
    if run.patch is None:
        return []
    if not run.patch["pressure"].max() > 0:
        run.remarks.append(f"Output step {run.tick} has no pressure anywhere; its pictures are left out.")
        return []
    if min(run.patch["pressure"].shape) < 2:
        run.remarks.append("The contact patch is a single row of nodes; its pictures are left out.")
        return []
    fields = Fields(run.patch, margin=4)
    if run.friction is None:
        run.remarks.append("The friction coefficient is neither in summary.json nor in parameters.prm; "
                           "the traction bound is left out.")
    pictures = [("Pressure, shear traction, stick and slip",
                 style.save(run, maps.draw_panels({"": fields}, run.sections, run.peaks), "sheet"))]
    near = Fields(run.patch)
    pictures.append(("Normal pressure, surface", draw_surface(run, near, near.pressure, "pressure [MPa]",
                                                              "Normal pressure", "pressure_surface")))
    pictures.append(("Shear traction on the rail, surface",
                     draw_surface(run, near, near.shear, "shear traction [MPa]", "Magnitude of the shear traction",
                                  "shear_surface")))
    pictures += draw_maps(run, fields)
    pictures += [cuts.draw(run, {"": fields}, plane, f"cut_{plane.lower()}") for plane in ("AA", "BB")]
    if len(run.instants) > 1:
        pictures += draw_instants(run)
    return pictures + (draw_others(run) if run.is_halfspace else [])
