"""Pictures of a family of runs, as a study makes them: all cases with the same scales, finite elements and half-spaces
side by side or one above the other.

calls(run, cases) takes what has `pictures_folder` and a list of Case; what it returns draws one picture each.
"""

import functools

import matplotlib.pyplot as plt
import numpy as np

import cuts
import maps
import run_data
import sections
import style
import subsurface_pictures
import wheelrail
from fields import Fields

FINITE, HALF = "Finite elements", "Half-spaces"
COLUMNS = 5  # of maps in one row


class Case:
    """One member: its label, the folder of its run and the folder of its half-spaces; None where there is none.
    Half-spaces that compare left in the run's folder go before those of a folder of their own."""

    def __init__(self, label, run_folder=None, halfspace_folder=None):
        self.label = label
        self.run = wheelrail.load(run_folder) if run_folder else None
        alone = wheelrail.load(halfspace_folder) if halfspace_folder else None
        compared = self.run is not None and self.run.has("halfspace.h5")
        self.halfspace = self.run if compared else alone
        self.summary = (self.run or alone).summary if (self.run or alone).has("summary.json") else {}
        self.patches = {FINITE: self.shown(self.run, "patch.h5", "patch"),
                        HALF: self.shown(self.halfspace, "halfspace.h5", "halfspace")}
        name = "halfspace_slices.h5" if compared else "slices.h5"
        folders = [data.folder for data in (self.run, alone) if data is not None]
        self.sections = next((where for where in map(sections.load, folders) if where is not None), None)
        self.slices = {FINITE: self.shown(self.run, "slices.h5", "slices"),
                       HALF: self.shown(self.halfspace, name, "halfspace_slices")}
        self.friction = self.summary.get("friction_coefficient")

    def shown(self, data, name, attribute):
        """The output step that stands for a case; None where there is none."""
        if data is None or not data.has(name):
            return None
        ticks = getattr(data, attribute)
        return ticks[run_data.usual_tick(ticks, self.summary)] if len(ticks) else None

    def fields(self, kind):
        """The patch for maps; None where nothing is loaded."""
        patch = self.patches[kind]
        loaded = patch is not None and patch["pressure"].max() > 0 and min(patch["pressure"].shape) > 1
        return Fields(patch, margin=4) if loaded else None


def kinds_of(cases, there):
    """Finite elements and half-spaces, those of which some case has something."""
    return [kind for kind in (FINITE, HALF) if any(there(case, kind) is not None for case in cases)]


def draw_head(run, cases):
    """All patches on the head of the rail, one above the other so that they can be told apart."""
    shown = [(case, fields) for case in cases if case.sections is not None
             for fields in [next((f for f in map(case.fields, (FINITE, HALF)) if f is not None), None)] if fields is not None]
    if not shown:
        return []
    figure, axes = plt.subplots(figsize=(11, 4.6 + 0.16 * len(shown)), constrained_layout=True)
    sections.draw_head(axes, shown[0][0].sections, with_wheel=False)
    step, top = 1.1, 0.0
    norm = plt.Normalize(min(fields.pressure.max() for _, fields in shown) * 0.95, max(fields.pressure.max() for _, fields in shown))
    for k, (case, fields) in enumerate(shown):
        points = case.sections.on_rail(np.linspace(*sections.patch_span(fields), 60))
        middle = points[30]
        points = points + (0.8 + step * k) * sections.outward(points)
        axes.plot(*points.T, color=plt.get_cmap(style.HIGH)(norm(fields.pressure.max())), linewidth=5, solid_capstyle="butt", zorder=3)
        axes.plot([middle[0], points[30, 0]], [middle[1], points[30, 1]], color=style.GREY, linewidth=0.5, zorder=2)
        end = points[np.argmin(points[:, 0])]
        axes.annotate(case.label, end, (5, 0), textcoords="offset points", fontsize=8, va="center", zorder=4,
                      bbox={"facecolor": "white", "edgecolor": "none", "alpha": 0.85, "pad": 0.6})
        top = max(top, points[:, 1].max())
    axes.set_ylim(axes.get_ylim()[0], max(top + 4, 8))
    axes.set_title("Where the patches lie on the rail head", pad=22)
    figure.colorbar(plt.cm.ScalarMappable(norm, style.HIGH), ax=axes, label="pressure, highest node [MPa]", shrink=0.8)
    return [("The patches of all cases on the rail head, each above the one before; coloured by their highest pressure",
             style.save(run, figure, "family_head"))]


def draw_forces(run, cases):
    """Longitudinal and normal force of all runs over the rolled distance."""
    runs = [case for case in cases if case.run is not None and case.run.has("history.h5")]
    if not runs:
        return []
    figure, rows = plt.subplots(2, 1, figsize=(9, 6.4), sharex=True)
    for axes, name, label in zip(rows, ("longitudinal_force", "normal_force"),
                                 ("longitudinal force on the wheel [kN]", "normal force [kN]")):
        for case, color in zip(runs, style.in_order(len(runs))):
            history = case.run.history
            axes.plot(1e3 * history["rolled_distance"], 1e-3 * history[name], linewidth=1.1, label=case.label,
                      color=color)
        axes.set_ylabel(label)
        axes.grid(True)
        axes.margins(x=0)
    style.legend_beside(rows[0])
    rows[1].set_xlabel("rolled distance [mm]")
    return [("Forces over the rolled distance, all cases", style.save(run, figure, "family_forces"))]


def draw_maps(run, cases, panel, name):
    """One kind of map of all cases: rows of finite elements, then of half-spaces, one scale."""
    draw, bar, title = panel
    fields = {(case, kind): case.fields(kind) for case in cases for kind in (FINITE, HALF)}
    shown = [field for field in fields.values() if field is not None]
    if not shown:
        return []
    scale = maps.Scale(*shown)
    kinds = kinds_of(cases, lambda case, kind: fields[case, kind])
    blocks = [cases[k:k + COLUMNS] for k in range(0, len(cases), COLUMNS)]
    rows = [(block, kind) for block in blocks for kind in kinds]
    columns = min(COLUMNS, len(cases))
    height = 4.0 * scale.ratio + 1.0
    figure, axes = plt.subplots(len(rows), columns, figsize=(4.1 * columns + 1.2, height * len(rows)), squeeze=False,
                                gridspec_kw={"wspace": 0.28, "hspace": 0.45})
    for (block, kind), line in zip(rows, axes):
        last = None
        for place, case in zip(line, block):
            field = fields[case, kind]
            if field is None:
                place.set_axis_off()
                continue
            image = draw(place, field, scale, case.label)
            place.set_title(f"{case.label}\n{kind.lower()}" + place.get_title().replace(case.label, ""), fontsize=9, pad=18)
            last = place, image
            if place is not line[0]:
                place.set_ylabel("")
        for place in line[len(block):]:
            place.set_axis_off()
        if last is not None:
            bar(figure, *last)
    return [(f"{title}, all cases on one scale", style.save(run, figure, name))]


def draw_cuts(run, cases, plane):
    """Shear traction and bound of all cases on AA or BB: finite elements left, half-spaces right, one scale."""
    kinds = kinds_of(cases, lambda case, kind: case.fields(kind))
    if not kinds:
        return []
    figure, rows = plt.subplots(2, len(kinds), figsize=(6.2 * len(kinds) + 2, 7), squeeze=False, sharex=True,
                                sharey="row", gridspec_kw={"wspace": 0.06, "hspace": 0.08})
    for kind, column in zip(kinds, rows.T):
        for case, color in zip(cases, style.in_order(len(cases))):
            fields = case.fields(kind)
            if fields is None:
                continue
            x, on_line = fields.line(plane, fields.places()[plane])
            column[0].plot(x, on_line("pressure"), color=color, linewidth=1.2, label=case.label)
            # signed as the traction on the wheel: positive when it drives
            column[1].plot(x, -on_line("shear_along"), color=color, linewidth=1.3)
            if case.friction is not None:
                bound = case.friction * on_line("pressure")
                sign = -1 if np.sum(-fields.shear_along) < 0 else 1
                column[1].plot(x, sign * bound, color=color, linewidth=0.8, linestyle="--")
        column[0].set_title(f"{kind}, plane {plane}")
        column[1].set_xlabel(cuts.LABELS[plane])
        for axes in column:
            axes.grid(True)
    rows[0, 0].set_ylabel("pressure [MPa]")
    rows[1, 0].set_ylabel("shear traction along the track,\non the wheel, and bound (dashed) [MPa]")
    style.legend_beside(rows[0, -1])
    if plane == "BB":
        rows[0, 0].invert_xaxis()  # shared; s to the left, as in the maps
    return [(f"Cut {plane}: pressure, shear traction and traction bound, all cases",
             style.save(run, figure, f"family_cut_{plane.lower()}"))]


def draw_stresses(run, cases, plane, kind):
    """Von Mises or shear stress below the contact of all cases, one scale."""
    below = {(case, who): subsurface_pictures.Cut(case.slices[who], subsurface_pictures.through_peak(case.slices[who], plane)) if case.slices[who] is not None else None
             for case in cases for who in (FINITE, HALF)}
    shown = [cut for cut in below.values() if cut is not None]
    if not shown:
        return []
    view, top = subsurface_pictures.view_of(shown), max(cut.largest(kind) for cut in shown)
    kinds = kinds_of(cases, lambda case, who: below[case, who])
    rows = [(cases[k:k + COLUMNS], who) for k in range(0, len(cases), COLUMNS) for who in kinds]
    columns = min(COLUMNS, len(cases))
    ratio = 2 * subsurface_pictures.DEPTH / (view[1] - view[0])
    figure, axes = plt.subplots(len(rows), columns, figsize=(4.0 * columns + 1.2, (3.4 * ratio + 1.0) * len(rows)),
                                squeeze=False, gridspec_kw={"wspace": 0.22, "hspace": 0.35})
    for (block, who), line in zip(rows, axes):
        last = None
        for place, case in zip(line, block):
            cut = below[case, who]
            if cut is None:
                place.set_axis_off()
                continue
            title = f"{case.label}, {who.lower()}\nup to {cut.largest(kind):.0f} MPa"
            last = place, subsurface_pictures.panel(place, cut, kind, top, title, view)
            place.title.set_fontsize(9)
            place.xaxis.label.set_fontsize(8)
            if place is not line[0]:
                place.set_ylabel("")
        for place in line[len(block):]:
            place.set_axis_off()
        if last is not None:
            label = "von Mises stress [MPa]" if kind == "von Mises" else subsurface_pictures.SHEAR[plane][1]
            style.level_bar(figure, *last, label)
    name = f"family_{'mises' if kind == 'von Mises' else 'shear_stress'}_{plane.lower()}"
    return [(f"{'Von Mises' if kind == 'von Mises' else 'Shear'} stress below the contact in {plane}, all cases",
             style.save(run, figure, name))]


def calls(run, cases):
    """A call for each picture of the family, in their order; each gives a list of (caption, path). Those that take
    longest come last."""
    def each(draw, *arguments):
        return functools.partial(draw, run, cases, *arguments)

    return [each(draw_head), each(draw_forces)] + \
           [each(draw_maps, panel, name)
            for panel, name in zip(maps.PANELS, ("family_pressure", "family_shear", "family_states"))] + \
           [each(draw_cuts, plane) for plane in ("AA", "BB")] + \
           [each(draw_stresses, plane, kind) for plane in ("AA", "BB") for kind in ("von Mises", "shear")]
