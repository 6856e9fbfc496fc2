"""Pictures of the contact patch: pressure, shear traction, stick and slip, a cut along the rail.

The lateral coordinate s grows to the track centre, which is the side of the gauge corner (G.C.); the
field side (F.S.) is at negative s. The rolling direction points up in the maps, which show the right-hand
rail from above: the track centre is then on the left, so s is drawn growing to the left.
"""

import matplotlib.pyplot as plt
import numpy as np
from matplotlib.colors import BoundaryNorm, ListedColormap
from matplotlib.patches import Patch, PathPatch
from matplotlib.path import Path
from matplotlib.ticker import MaxNLocator

import style

LOADED = 1e-3  # a node counts as loaded above this part of the peak, as in sampling/patch_edge.cc
FAINT = 0.03   # arrows shorter than this part of the longest would be dots


class Fields:
    """The patch in mm and MPa, cut to the loaded nodes and a margin; arrays [along, lateral]."""

    def __init__(self, patch, margin=2):
        loaded = patch["pressure"] > LOADED * patch["pressure"].max()
        rows, columns = np.nonzero(loaded.any(axis=1))[0], np.nonzero(loaded.any(axis=0))[0]
        cut = (slice(max(rows[0] - margin, 0), rows[-1] + margin + 1),
               slice(max(columns[0] - margin, 0), columns[-1] + margin + 1))
        self.along, self.lateral = 1e3 * patch["along"][cut], 1e3 * patch["lateral"][cut]
        self.pressure = 1e-6 * patch["pressure"][cut]
        self.shear_along, self.shear_lateral = 1e-6 * patch["shear_along"][cut], 1e-6 * patch["shear_lateral"][cut]
        self.shear = np.hypot(self.shear_along, self.shear_lateral)
        self.state = np.rint(patch["state"][cut]).astype(int)
        self.loaded = loaded[cut]
        self.edge = self.edge_level(patch, cut)

    def edge_level(self, patch, cut):
        """A field whose zero line is the edge: gap^(2/3) outside, -(p^2) inside, both linear at the edge,
        scaled so that they have the same slope there."""
        square = (self.pressure / self.pressure.max()) ** 2
        if "gap" not in patch:
            return LOADED - square
        opening = np.cbrt(np.clip(patch["gap"][cut], 0, None)) ** 2
        rim_in = self.loaded & touches(~self.loaded)
        rim_out = ~self.loaded & touches(self.loaded)
        if not rim_in.any() or not opening[rim_out].any():
            return LOADED - square
        scale = np.mean(square[rim_in]) / np.mean(opening[rim_out])
        return np.where(self.loaded, -square, np.minimum(scale * opening, 1))


def touches(mask):
    """Nodes that have a neighbour in the mask."""
    near = np.zeros_like(mask)
    near[1:] |= mask[:-1]
    near[:-1] |= mask[1:]
    near[:, 1:] |= mask[:, :-1]
    near[:, :-1] |= mask[:, 1:]
    return near


def dress(axes, fields, title):
    """Labels, equal scales, sides of the rail and the rolling direction."""
    axes.set_aspect("equal")
    axes.set_xlim(fields.lateral.max(), fields.lateral.min())
    axes.set_ylim(fields.along.min(), fields.along.max())
    axes.set_xlabel("lateral $s$ [mm]")
    axes.set_ylabel("rolling direction [mm]")
    axes.set_title(title, pad=22)
    axes.text(0, 1.02, "G.C.", transform=axes.transAxes, ha="left", va="bottom", weight="bold", color=style.GREY)
    axes.text(1, 1.02, "F.S.", transform=axes.transAxes, ha="right", va="bottom", weight="bold", color=style.GREY)
    axes.annotate("", xy=(0.06, 0.97), xytext=(0.06, 0.80), xycoords="axes fraction",
                  arrowprops=dict(arrowstyle="-|>", color="black", linewidth=1.4))
    axes.text(0.085, 0.965, "rolling", transform=axes.transAxes, ha="left", va="top", fontsize=9,
              bbox=dict(facecolor="white", edgecolor="none", alpha=0.7, pad=1))


def draw_edge(axes, fields):
    """Draws the edge line; returns it as a path."""
    lines = axes.contour(fields.lateral, fields.along, fields.edge, levels=[0], colors="black", linewidths=1.2)
    return Path.make_compound_path(*lines.collections[0].get_paths())


def round_levels(top):
    """A dozen or so round values from zero to at least `top`."""
    return MaxNLocator(nbins=14, steps=[1, 2, 2.5, 5, 10]).tick_values(0, max(top, 1e-9))


def new_map(fields):
    """A figure for one map whose shape follows the patch."""
    ratio = np.ptp(fields.along) / np.ptp(fields.lateral)
    return plt.subplots(figsize=(6.2, 1.4 + 5.0 * min(max(ratio, 0.4), 1.6)))


def color_bar(figure, axes, mappable, label):
    bar = figure.colorbar(mappable, cax=axes.inset_axes([1.03, 0, 0.04, 1]))
    bar.set_label(label)
    return bar


def draw_surface(run, fields, values, label, title, name):
    figure = plt.figure(figsize=(7.0, 5.4))
    axes = figure.add_subplot(projection="3d")
    surface = axes.plot_surface(fields.lateral, fields.along, values, cmap="viridis", rstride=1, cstride=1,
                                linewidth=0.15, edgecolor="#00000055", antialiased=True)
    axes.set_box_aspect((np.ptp(fields.lateral), np.ptp(fields.along), 0.6 * np.ptp(fields.lateral)))
    axes.set_xlabel("lateral $s$ [mm]\nG.C. $\\leftarrow$   $\\rightarrow$ F.S.", labelpad=14)
    axes.set_ylabel("rolling direction [mm]", labelpad=8)
    axes.set_xlim(fields.lateral.max(), fields.lateral.min())  # s to the left, as in the maps
    axes.set_zlim(0, None)
    axes.xaxis.set_major_locator(MaxNLocator(5))
    axes.yaxis.set_major_locator(MaxNLocator(5))
    axes.view_init(elev=28, azim=-58)
    axes.set_title(title)
    figure.colorbar(surface, cax=figure.add_axes([0.93, 0.22, 0.022, 0.5])).set_label(label)
    return style.save(run, figure, name)


def draw_pressure(run, fields):
    peak = np.unravel_index(np.argmax(fields.pressure), fields.pressure.shape)
    figure, axes = new_map(fields)
    # p^2 is smooth across the edge once continued by the opening, p is not: lines of equal p are drawn as
    # lines of equal p^2
    levels = round_levels(fields.pressure.max())
    squares = (levels / fields.pressure.max()) ** 2
    filled = axes.contourf(fields.lateral, fields.along, -fields.edge, levels=squares, cmap="viridis",
                           norm=BoundaryNorm(squares, 256))
    axes.contour(fields.lateral, fields.along, -fields.edge, levels=squares[1:], colors="white", linewidths=0.4,
                 alpha=0.7)
    draw_edge(axes, fields)
    axes.plot(fields.lateral[peak], fields.along[peak], "+", color=style.RED, markersize=11, markeredgewidth=1.8)
    dress(axes, fields, f"Normal pressure, peak {fields.pressure.max():.0f} MPa (+)")
    bar = color_bar(figure, axes, filled, "pressure [MPa]")
    bar.set_ticks(squares, labels=[f"{level:g}" for level in levels])
    return [("Normal pressure, surface", draw_surface(run, fields, fields.pressure, "pressure [MPa]",
                                                      "Normal pressure", "pressure_surface")),
            ("Normal pressure, contours", style.save(run, figure, "pressure_contour"))]


def draw_shear(run, fields):
    figure, axes = new_map(fields)
    top = max(fields.shear.max(), 1e-9)
    filled = axes.contourf(fields.lateral, fields.along, fields.shear, levels=round_levels(top), cmap="YlOrRd")
    inside = PathPatch(draw_edge(axes, fields), transform=axes.transData, facecolor="none", edgecolor="none")
    axes.add_patch(inside)
    for area in filled.collections:
        area.set_clip_path(inside)
    step = max(1, max(fields.shear.shape) // 24)
    pick = np.zeros_like(fields.loaded)
    pick[::step, ::step] = True
    pick &= fields.loaded & (fields.shear > FAINT * top)
    spacing = step * np.ptp(fields.along) / (fields.along.shape[0] - 1)
    axes.quiver(fields.lateral[pick], fields.along[pick], fields.shear_lateral[pick], fields.shear_along[pick],
                angles="xy", scale_units="xy", scale=top / (1.6 * spacing), width=0.0035, color="#1a1a1a")
    dress(axes, fields, f"Shear traction on the rail, nodes up to {fields.shear.max():.0f} MPa")
    color_bar(figure, axes, filled, "shear traction [MPa]")
    return [("Shear traction on the rail, surface", draw_surface(run, fields, fields.shear, "shear traction [MPa]",
                                                     "Magnitude of the shear traction", "shear_surface")),
            ("Shear traction on the rail, contours and directions", style.save(run, figure, "shear_contour"))]


def draw_states(run, fields):
    figure, axes = new_map(fields)
    colors = ["#f4f4f4", style.BLUE, style.RED]
    axes.pcolormesh(fields.lateral, fields.along, np.where(fields.loaded, fields.state, 0), shading="nearest",
                    cmap=ListedColormap(colors), vmin=-0.5, vmax=2.5, edgecolors="white", linewidth=0.3)
    draw_edge(axes, fields)
    stick, loaded = np.sum((fields.state == 1) & fields.loaded), np.sum(fields.loaded)
    dress(axes, fields, f"Stick and slip: {100 * stick / loaded:.0f} % of the loaded nodes stick")
    axes.legend(handles=[Patch(color=style.BLUE, label="stick"), Patch(color=style.RED, label="slip"),
                         Patch(facecolor=colors[0], edgecolor=style.GREY, label="open")],
                loc="upper left", bbox_to_anchor=(1.02, 1), borderaxespad=0)
    return [("Stick and slip", style.save(run, figure, "stick_slip"))]


def draw_cut(run, fields):
    """Along the rail through the node of the largest pressure."""
    column = np.unravel_index(np.argmax(fields.pressure), fields.pressure.shape)[1]
    along, bound = fields.along[:, column], fields.pressure[:, column]
    figure, axes = plt.subplots(figsize=(7.2, 4.0))
    if run.friction is not None:
        axes.plot(along, run.friction * bound, color=style.RED, linewidth=1.6,
                  label=f"traction bound $\\mu p$, $\\mu$ = {run.friction:g}")
        axes.plot(along, -run.friction * bound, color=style.RED, linewidth=0.8, linestyle="--",
                  label="$-\\mu p$")
    axes.plot(along, fields.shear[:, column], "o-", color=style.BLUE, markersize=3.5, linewidth=1.4,
              label="shear traction, magnitude")
    axes.plot(along, fields.shear_along[:, column], color=style.ORANGE, linewidth=1.2,
              label="on the rail, along the track")
    axes.plot(along, fields.shear_lateral[:, column], color=style.GREEN, linewidth=1.2,
              label="on the rail, lateral")
    axes.axhline(0, color=style.GREY, linewidth=0.7)
    axes.grid(True)
    axes.set_xlim(along[0], along[-1])
    axes.set_xlabel("rolling direction [mm]   (leading edge on the right)")
    axes.set_ylabel("traction [MPa]")
    axes.set_title(f"Cut along the rail through the peak, $s$ = {fields.lateral[0, column]:.2f} mm")
    axes.legend(loc="upper left", bbox_to_anchor=(1.01, 1), borderaxespad=0)
    return [("Cut along the rolling direction", style.save(run, figure, "cut_along"))]


def draw_all(run):
    """All pictures of the patch, a list of (caption, path)."""
    if run.patch is None:
        return []
    if not run.patch["pressure"].max() > 0:
        run.remarks.append(f"Tick {run.patch['tick']} has no pressure anywhere; its pictures are left out.")
        return []
    if min(run.patch["pressure"].shape) < 2:
        run.remarks.append("The contact patch is a single row of nodes; its pictures are left out.")
        return []
    fields = Fields(run.patch)
    if run.friction is None:
        run.remarks.append("The friction coefficient is neither in summary.json nor in parameters.prm; "
                           "the traction bound is left out.")
    return draw_pressure(run, fields) + draw_shear(run, fields) + draw_states(run, fields) + draw_cut(run, fields)
