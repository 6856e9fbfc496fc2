"""What the interactive views of a page show: numbers in the units that are shown, with six digits, from the files.

Each view is a dictionary that views.js draws: "patch" (maps and surfaces tick by tick), "cuts" (lines through them),
"slices" (stresses below the contact) and "curves" (over the rolled distance).
"""

import matplotlib.pyplot as plt
import numpy as np

import style
from fields import Fields

#: keys of the fields of a patch: attribute of Fields, label, unit, kind of the scale, factor
FIELDS = (("pressure", "pressure", "MPa", "positive", 1), ("shear", "shear traction, magnitude", "MPa", "positive", 1),
          ("shear_along", "shear traction on the rail along the track", "MPa", "signed", 1),
          ("shear_lateral", "shear traction on the rail, lateral", "MPa", "signed", 1),
          ("slip", "relative slip velocity", "10\u207b\u00b3", "positive", 1e3),
          ("state", "stick and slip", "", "states", 1))


def plain(values, digits=6):
    """Lists of numbers with that many digits; what is not finite becomes None."""
    values = np.asarray(values, dtype=float)
    if values.ndim > 1:
        return [plain(row, digits) for row in values]
    return [float(f"{value:.{digits}g}") if np.isfinite(value) else None for value in values]


def edge_lines(fields):
    """The fitted edge as s and along, pieces parted by None."""
    figure, axes = plt.subplots()
    pieces = axes.contour(fields.lateral, fields.along, fields.edge, levels=[0]).allsegs[0]
    plt.close(figure)
    s, along = [], []
    for piece in pieces:
        s += plain(piece[:, 0], 5) + [None]
        along += plain(piece[:, 1], 5) + [None]
    return [s, along]


def head_of(fields, where):
    """The rail head of a patch for a view, in mm: outline, the part that the patch covers, and where that is."""
    import sections as rails

    first, last = rails.patch_span(fields)
    patch = where.on_rail(np.linspace(first, last, 24))
    return {"rail": [plain(line, 5) for line in where.rail.T], "patch": [plain(line, 5) for line in patch.T],
            "face": plain(where.face, 5), "words": where.words(where.on_rail(0.5 * (first + last))[0])}


def is_shown(tick):
    """Whether a view has this tick: not where nothing is loaded."""
    return bool(tick["pressure"].max() > 0) and min(tick["pressure"].shape) >= 2


def patch_tick(tick, label, digits=6, where=None):
    """One tick of a patch for a view; None where nothing is loaded. `where`: the Sections of its rail."""
    if not is_shown(tick):
        return None
    fields = Fields(tick, margin=3)
    values = {}
    for key, _, _, _, factor in FIELDS:
        array = getattr(fields, key)
        if array is not None:
            inside = np.where(fields.loaded, factor * array, 0 if key == "state" else np.nan)
            values[key] = plain(inside, digits)
    head = {} if where is None else {"head": head_of(fields, where)}
    between = {name: plain(values, digits) for name, values in fields.between.items()}
    return {**head, "label": label, "between": between, "peak_shear": plain(fields.peak_shear(), digits), "s": plain(fields.lateral[0]), "along": plain(fields.along[:, 0]), "fields": values,
            "edge": edge_lines(fields), "places": {name: round(float(v), 4) for name, v in fields.places().items()}}


def patch_source(name, ticks, labels, where=None):
    shown = [patch_tick(tick, label, where=where) for tick, label in zip(ticks, labels)]
    return {"name": name, "ticks": [tick for tick in shown if tick is not None]}


def tick_labels(ticks, names):
    return [f"output step {int(name[5:])}: {1e3 * tick.attributes['rolled_distance_m']:.2f} mm rolled"
            for tick, name in zip(ticks, names)]


def patch_views(sources, friction, start, peaks=None):
    """Maps, and cuts through them; `start` is the number of the tick that is shown first, `peaks` (Run.peaks) end the
    scales."""
    sources = [source for source in sources if source["ticks"]]
    if not sources:
        return []
    shown = [key for key, *_ in FIELDS if all(key in tick["fields"] for source in sources for tick in source["ticks"])]
    fields = [{"key": key, "label": label, "unit": unit, "kind": kind}
              for key, label, unit, kind, _ in FIELDS if key in shown]
    for field in fields:
        values = [abs(value) for source in sources for tick in source["ticks"] for row in tick["fields"][field["key"]]
                  for value in row if value is not None]
        if field["key"] == "shear":
            values += [tick["peak_shear"][2] for source in sources for tick in source["ticks"]]
        field["top"] = float(f"{(peaks or {}).get(field['key'], max(values, default=1.0) or 1.0):.4g}")
    start = min(start, max(len(source["ticks"]) for source in sources) - 1)
    return [{"id": "view-patch", "type": "patch", "title": "Contact patch", "sources": sources, "fields": fields,
             "start": start},
            {"id": "view-cuts", "type": "cuts", "title": "Cuts through the patch", "patch": "view-patch",
             "friction": friction, "start": start}]


def slice_views(ticks, names=("AA_peak", "BB_peak", "AA", "BB"), digits=6, most_depths=1000):
    """Stresses below the contact in these planes, at so many depths at most; `ticks`: name -> tick of slices."""
    import subsurface_pictures as below

    planes = {}
    for plane in names:
        sources = []
        for who, tick in ticks.items():
            if f"{plane}_rail" not in tick:
                continue
            cut = below.Cut(tick, plane)
            step = -(-len(cut.bodies[0][2]) // most_depths)
            sources.append({"name": who, "offset": round(cut.offset + 0.0, 4), "bodies": [
                {"name": body, "position": plain(position), "depth": plain(depth[::step]),
                 "fields": {kind: plain(values[kind].T[::step], digits) for kind in ("von Mises", "shear")}}
                for body, position, depth, values in cut.bodies]})
        if len(sources) == len(ticks):
            cuts = [below.Cut(tick, plane) for tick in ticks.values()]
            planes[plane] = {"sources": sources, "view": plain(below.view_of(cuts), 4),
                             "top": {kind: float(f"{max(cut.largest(kind) for cut in cuts):.4g}")
                                     for kind in ("von Mises", "shear")},
                             "shear": below.SHEAR[plane[:2]][1][:-6]}
    if not planes:
        return []
    return [{"id": "view-slices", "type": "slices", "title": "Stresses below the contact", "planes": planes}]


def curve_views(run, groups):
    """Histories; `groups`: title -> (label of the axis, [(name, distance in mm, values, mean)]); the mean is that of
    the summary with begin and end of the stretch over which it is taken, or None."""
    shown = [{"title": title, "label": label,
              "curves": [{"name": name, "x": plain(x), "y": plain(y), **({} if mean is None else {"mean": plain(mean)})}
                         for name, x, y, mean in curves]}
             for title, (label, curves) in groups.items() if curves]
    return [{"id": "view-curves", "type": "curves", "title": "Over the rolled distance", "groups": shown}] if shown else []
