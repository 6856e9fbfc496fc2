"""Stresses below the contact in the planes AA and BB: finite elements, half-spaces, or both side by side.

Wheel above, rail below, depth along the contact normal from the surface where they meet. AA shows the rolling
direction to the right, BB the gauge corner on the left.
"""

import matplotlib.pyplot as plt
import numpy as np

import run_data
import style

DEPTH = 10.0  # shown of each body [mm]
SHEAR = {"AA": ("stress_yz", "shear stress yz [MPa]"), "BB": ("stress_xy", "shear stress xy [MPa]")}
ACROSS = {"AA": "along the rail [mm]   (rolling direction to the right)",
          "BB": "lateral s [mm]   (G.C. on the left, F.S. on the right)"}


def through_peak(tick, plane):
    """The plane AA or BB through the highest pressure; of an earlier version that through the first contact point."""
    return plane + "_peak" if f"{plane}_peak_rail" in tick else plane


class Cut:
    """One plane through wheel and rail: positions and depths in mm (wheel positive, rail negative), stresses in
    MPa, arrays [position, depth] per body."""

    def __init__(self, tick, plane):
        self.plane = plane
        self.bodies = []
        for body, sign in (("wheel", 1), ("rail", -1)):
            group = tick[f"{plane}_{body}"]
            keep = 1e3 * group["depth"] <= DEPTH + 1e-6
            values = {"von Mises": 1e-6 * group["von_mises_stress"][:, keep],
                      "shear": 1e-6 * group[SHEAR[plane[:2]][0]][:, keep]}
            self.bodies.append((body, 1e3 * group["position"], sign * 1e3 * group["depth"][keep], values))
        self.offset = 1e3 * tick[f"{plane}_rail"].attributes["lateral_m" if plane[0] == "A" else "along_m"]

    def largest(self, kind, depth_from=0.0):
        """Largest absolute value of both bodies at a depth and below."""
        return max(np.nanmax(np.abs(values[kind][:, np.abs(depth) >= depth_from - 1e-6]))
                   for _, _, depth, values in self.bodies)


def panel(axes, cut, kind, top, title, view):
    """One map; `top` ends its scale, which is symmetric for shear."""
    levels = style.levels_to(top, 14 if kind == "von Mises" else 8)
    if kind == "shear":
        levels = [*(-level for level in levels[:0:-1]), *levels]
    colors = style.HIGH if kind == "von Mises" else "RdBu_r"
    for body, position, depth, values in cut.bodies:
        image = axes.contourf(position, depth, values[kind].T, levels=levels, cmap=colors, extend="neither")
        crossed = [level for level in levels if np.nanmin(values[kind]) < level < np.nanmax(values[kind])]
        if crossed:  # none without stress, while the wheel is off the rail
            axes.contour(position, depth, values[kind].T, levels=crossed, colors="black", linewidths=0.25, alpha=0.5)
        axes.text(0.01, 0.97 if body == "wheel" else 0.03, body, transform=axes.transAxes, weight="bold",
                  va="top" if body == "wheel" else "bottom", color=style.GREY,
                  bbox=dict(facecolor="white", edgecolor="none", alpha=0.7, pad=1))
    axes.axhline(0, color="black", linewidth=0.8)
    axes.set_aspect("equal")
    axes.set_xlim(*(view if cut.plane[0] == "A" else view[::-1]))
    axes.set_ylim(-DEPTH, DEPTH)
    axes.set_xlabel(ACROSS[cut.plane[:2]])
    axes.set_ylabel("from the surface [mm]")
    axes.set_title(title)
    return image


def view_of(cuts):
    """What all cuts of a plane show: the range in which the stress is not small, 12 mm at least."""
    reach = 6.0
    for cut in cuts:
        for _, position, _, values in cut.bodies:
            strong = np.nanmax(values["von Mises"], axis=1, initial=0) > 0.12 * cut.largest("von Mises")
            if strong.any():
                reach = max(reach, np.abs(position[strong]).max())
    position = cuts[0].bodies[1][1]
    return max(-reach - 1, position.min()), min(reach + 1, position.max())


def draw_plane(run, ticks, plane, name):
    """Von Mises and shear stress of a plane; `ticks`: name -> tick of slices. Returns caption and path."""
    cuts = {who: Cut(tick, through_peak(tick, plane)) for who, tick in ticks.items()}
    view = view_of(list(cuts.values()))
    ratio = 2 * DEPTH / (view[1] - view[0])
    rows, columns = (2, len(cuts)) if len(cuts) > 1 else (1, 2)
    figure, axes = plt.subplots(rows, columns, figsize=(5.6 * columns + 1, rows * (1.1 + 4.4 * ratio)), squeeze=False,
                                gridspec_kw={"wspace": 0.25 if rows > 1 else 0.42, "hspace": 0.32})
    if rows == 1:
        axes = axes.T
    for row, kind, label in zip(axes, ("von Mises", "shear"), ("von Mises stress [MPa]", SHEAR[plane[:2]][1])):
        top = max(cut.largest(kind) for cut in cuts.values())
        for place, (who, cut) in zip(row, cuts.items()):
            title = f"up to {cut.largest(kind):.0f} MPa, {cut.largest(kind, 1.0):.0f} MPa from 1 mm depth on"
            image = panel(place, cut, kind, top, f"{who}: {title}" if who else title, view)
            if kind == "shear" and rows == 1:  # the bar of the other map stands there
                place.set_ylabel("")
        style.level_bar(figure, row[-1], image, label)
    first = next(iter(cuts.values()))
    where = (f"s = {first.offset + 0.0:.2f} mm" if plane[0] == "A" else
             f"{first.offset + 0.0:.2f} mm ahead of the contact point")
    caption = f"Stresses below the contact in plane {plane}, {where}: von Mises and shear"
    return caption, style.save(run, figure, name)


def ticks_of(run):
    """Name -> tick of the slices that there are: of the run at the tick that is drawn, and of the half-spaces."""
    ticks = {}
    slices = None if run.is_halfspace else run.try_to(lambda: run.data.slices,
                                                      "The stresses below the contact are left out.")
    if slices is not None and run.tick is not None and f"tick_{run.tick:04d}" in slices.names:
        ticks["Finite elements"] = run_data.tick_of(slices, run.tick)
    last = run.patches is not None and run.tick == int(run.patches.names[-1][5:])
    if (run.is_halfspace and run.data.has("slices.h5")) or (run.data.has("halfspace_slices.h5") and last):
        ticks["Half-spaces"] = run.data.halfspace_slices[-1]
    return ticks if len(ticks) != 1 else {"": next(iter(ticks.values()))}


def draw_all(run, prefix=""):
    """All pictures, a list of (caption, path)."""
    ticks = ticks_of(run)
    return [draw_plane(run, ticks, plane, f"{prefix}subsurface_{plane.lower()}")
            for plane in ("AA", "BB") if ticks]
