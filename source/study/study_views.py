"""The interactive views of a study's page: curves of the figures over the first axis, the patches of all cases with a
slider over them, cuts through them, stresses below the contact."""

import numpy as np

import family_pictures
import views
from study_folder import SOURCES

# what a page under 5 MB holds of nine cases: digits of the patches; planes, depths and digits of the stresses below
PATCH_DIGITS, PLANES, DEPTHS, DIGITS = 5, ("AA", "BB"), 26, 4


#: how the curves of finite elements, half-spaces and true bodies are told apart
STYLES = {"": {}, "halfspace_": {"dash": "dash", "symbol": "square-open"}, "bodies_": {"dash": "dot", "symbol": "triangle-up-open"}}


def curve_view(columns, keys, x, curves):
    """Figures over the axis; the same points as in the pictures."""
    groups = []
    for key in keys:
        shown, label = [], None
        for prefix, who in SOURCES.items():
            column, style = columns.get(prefix + key), STYLES[prefix]
            if column is None or not np.any(column.values[np.isfinite(column.values)]):
                continue
            label = column.title
            for number, (name, rows) in enumerate(curves.items()):
                rows = sorted((row for row in rows if np.isfinite(column.values[row])), key=lambda row: x.places[row])
                places = [x.texts[row] for row in rows] if x.words else views.plain(x.places[rows])
                color = number if len(curves) > 1 else list(STYLES).index(prefix)
                shown.append({"name": f"{name}, {who.lower()}" if name else who, "x": places, "color": color,
                              "y": views.plain(column.values[rows] * column.factor), **style})
        if shown:
            title = label.split(" [")[0]
            groups.append({"title": title[0].upper() + title[1:], "label": label, "curves": shown})
    if not groups:
        return []
    return [{"id": "view-figures", "type": "curves", "title": "Results over the cases", "groups": groups, "marks": True,
             "abscissa": x.label, "unit": ""}]


def case_views(members):
    """Patches, cuts and stresses of the cases that have all that is shown."""
    shown = []
    kinds = family_pictures.kinds_of(members, lambda case, kind: case.patches[kind])
    ticks = {case: [views.patch_tick(case.patches[kind], case.label, PATCH_DIGITS, case.sections) if case.patches[kind] is not None else None
                    for kind in kinds] for case in members}
    there = [case for case in members if kinds and all(tick is not None for tick in ticks[case])]
    for case in there:
        for tick in ticks[case]:
            tick["friction"] = case.friction
    sources = [{"name": kind, "ticks": [ticks[case][k] for case in there]} for k, kind in enumerate(kinds)]
    shown += views.patch_views(sources, None, 0)
    kinds = family_pictures.kinds_of(members, lambda case, kind: case.slices[kind])
    there = [case for case in members if kinds and all(case.slices[kind] is not None for kind in kinds)]
    stresses = [(case.label, views.slice_views({kind: case.slices[kind] for kind in kinds}, PLANES, DIGITS, DEPTHS)) for case in there]
    stresses = [(label, view[0]["planes"]) for label, view in stresses if view]
    if stresses:
        same_scales(stresses)
        shown.append({"id": "view-slices", "type": "slices", "title": "Stresses below the contact",
                      "planes": stresses[0][1], "cases": [{"label": label, "planes": planes} for label, planes in stresses]})
    return shown


def same_scales(stresses):
    """One scale and one view for all cases."""
    for plane in stresses[0][1]:
        cases = [planes[plane] for _, planes in stresses if plane in planes]
        top = {kind: max(case["top"][kind] for case in cases) for kind in cases[0]["top"]}
        view = [min(case["view"][0] for case in cases), max(case["view"][1] for case in cases)]
        for case in cases:
            case["top"], case["view"] = top, view


def make(columns, keys, x, curves, members):
    return curve_view(columns, keys, x, curves) + case_views(members)
