"""Maps of a patch on given axes: pressure, shear traction with arrows, stick and slip, all with the fitted edge and
the lines AA and BB.

They show the right-hand rail from above, rolling direction up; the track centre is then on the left, so s is drawn
growing to the left. The functions take the ends of the scales, so that patches can be set side by side.
"""

import matplotlib.pyplot as plt
import numpy as np
from matplotlib.colors import BoundaryNorm, ListedColormap
from matplotlib.patches import Patch, PathPatch
from matplotlib.path import Path

import sections
import style

FAINT = 0.03  # arrows shorter than this part of the longest would be dots


class Scale:
    """Common limits of maps that are compared: extents in mm, ends of pressure and shear in MPa: those of the results
    (Run.peaks), or of the fields."""

    def __init__(self, *fields, peaks=None):
        self.peaks = peaks or {}
        inside = [(f.lateral[f.loaded], f.along[f.loaded]) for f in fields]
        # the edge of the patch lies up to a cell beyond the last loaded nodes
        across = max(1.5, 1.25 * max(abs(f.lateral[0, 1] - f.lateral[0, 0]) for f in fields))
        along = max(1.5, 1.25 * max(f.spacing for f in fields))
        self.lateral = (min(s.min() for s, _ in inside) - across, max(s.max() for s, _ in inside) + across)
        self.along = (min(x.min() for _, x in inside) - along, max(x.max() for _, x in inside) + along)
        self.pressure = self.peaks.get("pressure", max(f.pressure.max() for f in fields))
        self.shear_peak = max(max(f.peak_shear()[2] for f in fields), 1e-9)
        self.shear = self.peaks.get("shear", self.shear_peak)

    @property
    def ratio(self):
        """Height over width of a map."""
        return (self.along[1] - self.along[0]) / (self.lateral[1] - self.lateral[0])


def dress(axes, fields, scale, title, lines=True):
    """Labels, equal scales, sides of the rail, rolling direction, AA and BB."""
    axes.set_aspect("equal")
    axes.set_xlim(scale.lateral[1], scale.lateral[0])
    axes.set_ylim(*scale.along)
    axes.set_xlabel("lateral s [mm]")
    axes.set_ylabel("along the rail [mm]")
    axes.set_title(title, pad=22)
    style.sides(axes)
    style.rolling_arrow(axes)
    if not lines:
        return
    places = fields.places()
    options = dict(color="#1a3fbf", linewidth=0.8, linestyle=(0, (5, 4)))
    axes.axvline(places["AA"], **options)
    axes.axhline(places["BB"], **options)
    # above a patch that reaches the border
    words = dict(color="#1a3fbf", fontsize=8, ha="right", va="bottom", zorder=6,
                 bbox=dict(facecolor="white", edgecolor="none", alpha=0.7, pad=0.3))
    axes.text(places["AA"], scale.along[0], "AA ", **words)
    axes.text(scale.lateral[0], places["BB"], "BB ", **words)


def draw_edge(axes, fields):
    """Draws the edge line; returns it as a path."""
    lines = axes.contour(fields.lateral, fields.along, fields.edge, levels=[0], colors="black", linewidths=1.2)
    return Path.make_compound_path(*lines.collections[0].get_paths())


def pressure(axes, fields, scale, title):
    # p^2 is smooth across the edge once continued by the opening, p is not: lines of equal p are drawn as
    # lines of equal p^2
    levels = style.levels_to(scale.pressure)
    top = fields.pressure.max()
    squares = (np.array(levels) / top) ** 2
    filled = axes.contourf(fields.lateral, fields.along, np.minimum(-fields.edge, squares[-1]), levels=squares, cmap=style.HIGH,
                           norm=BoundaryNorm(squares, 256))
    axes.contour(fields.lateral, fields.along, -fields.edge, levels=squares[1:], colors="white", linewidths=0.4,
                 alpha=0.7)
    draw_edge(axes, fields)
    peak = fields.peak_place()
    axes.plot(fields.lateral[peak], fields.along[peak], "+", color=style.RED, markersize=11, markeredgewidth=1.8)
    dress(axes, fields, scale, f"{title}, peak {scale.peaks.get('pressure', top):.0f} MPa (+)")
    filled.pressures = levels
    return filled


def pressure_bar(figure, axes, filled):
    """The bar of pressure(): its levels are squares."""
    style.level_bar(figure, axes, filled, "pressure [MPa]", filled.pressures)


def arrows(axes, fields, scale, most=18):
    """Directions and sizes of the shear traction on the rail, some `most` of them on the longer side."""
    step = max(1, round(max((scale.lateral[1] - scale.lateral[0]), (scale.along[1] - scale.along[0])) /
                        (most * fields.spacing)))
    across = max(1, round(step * fields.spacing / abs(fields.lateral[0, 1] - fields.lateral[0, 0])))
    pick = np.zeros_like(fields.loaded)
    pick[::step, ::across] = True
    pick &= fields.loaded & (fields.shear > FAINT * scale.shear_peak)
    axes.quiver(fields.lateral[pick], fields.along[pick], fields.shear_lateral[pick], fields.shear_along[pick],
                angles="xy", scale_units="xy", scale=scale.shear_peak / (1.6 * step * fields.spacing), width=0.0035,
                color="#1a1a1a")


def shear(axes, fields, scale, title):
    places = [fields.lateral, fields.along, np.minimum(fields.shear, scale.shear)]
    draw = axes.contourf
    if fields.between["shear"].size:  # no grid any more
        places = [np.append(nodal.ravel(), np.minimum(between, limit)) for nodal, between, limit in
                  zip(places, (fields.between[name] for name in ("lateral", "along", "shear")), (np.inf, np.inf, scale.shear))]
        draw = axes.tricontourf
    filled = draw(*places, levels=style.levels_to(scale.shear), cmap="YlOrRd")
    inside = PathPatch(draw_edge(axes, fields), transform=axes.transData, facecolor="none", edgecolor="none")
    axes.add_patch(inside)
    for area in filled.collections:
        area.set_clip_path(inside)
    arrows(axes, fields, scale)
    s, along, peak = fields.peak_shear()
    axes.plot(s, along, "+", color=style.BLUE, markersize=11, markeredgewidth=1.8)
    dress(axes, fields, scale, f"{title}, peak {scale.peaks.get('shear', peak):.0f} MPa (+)")
    return filled


def shear_bar(figure, axes, filled):
    style.level_bar(figure, axes, filled, "shear traction on the rail [MPa]")


def states(axes, fields, scale, title):
    image = axes.pcolormesh(fields.lateral, fields.along, np.where(fields.loaded, fields.state, fields.nearest(fields.state)),
                            shading="nearest", cmap=ListedColormap([style.OPEN, style.STICK, style.SLIP]), vmin=-0.5,
                            vmax=2.5, edgecolors="white", linewidth=0.2)
    inside = PathPatch(draw_edge(axes, fields), transform=axes.transData, facecolor="none", edgecolor="none")
    axes.add_patch(inside)
    image.set_clip_path(inside)  # half a cell of the outermost nodes lies beyond the edge
    dress(axes, fields, scale, f"{title}, {100 * fields.stick_share:.0f} % of the area sticks")


def states_legend(_figure, axes, _image):
    axes.legend(handles=[Patch(color=style.STICK, label="stick"), Patch(color=style.SLIP, label="slip"),
                         Patch(facecolor=style.OPEN, edgecolor=style.GREY, label="open")],
                loc="lower left", bbox_to_anchor=(1.02, 0), borderaxespad=0)


#: the panels: how they are drawn, their bar or legend, title
PANELS = ((pressure, pressure_bar, "Pressure"), (shear, shear_bar, "Shear traction"),
          (states, states_legend, "Stick and slip"))


def draw_place(figure, grid, fields, where):
    """The rail head with the patch on it, below the maps and with the gauge side on the same side."""
    axes = figure.add_subplot(grid)
    sections.draw_head(axes, where)
    middle = sections.draw_patch(axes, where, sections.patch_span(fields))
    axes.set_title("Patch " + where.words(middle).replace(", ", ",\n", 1), fontsize=9, pad=22)


def draw_panels(fields_of, where=None, peaks=None):
    """A figure of one row for each patch (name -> Fields) and a column for each panel, one scale a column; below them
    the rail head with the first patch where `where` (Sections) is known. `peaks`: Run.peaks."""
    scale = Scale(*fields_of.values(), peaks=peaks)
    height = min(max(6.0 * scale.ratio, 3.0), 8.0) + 0.9
    heights = [height] * len(fields_of) + ([4.2] if where is not None else [])
    figure = plt.figure(figsize=(20, sum(heights)))
    grid = figure.add_gridspec(len(heights), 3, height_ratios=heights, wspace=0.36, hspace=0.42)
    for k, (name, fields) in enumerate(fields_of.items()):
        for column, (draw, bar, title) in enumerate(PANELS):
            place = figure.add_subplot(grid[k, column])
            bar(figure, place, draw(place, fields, scale, f"{name}: {title.lower()}" if name else title))
    if where is not None:
        draw_place(figure, grid[-1, :2], next(iter(fields_of.values())), where)
    return figure
