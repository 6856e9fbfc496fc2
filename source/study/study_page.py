"""The one page of a study: curves of the main figures over what varies, in a single HTML file."""

import functools
import html
import os
import sys

import numpy as np

sys.path.insert(0, os.path.join(os.path.dirname(os.path.abspath(__file__)), os.pardir, "report"))

import cell_limits
import drawing
import family_pictures
import inputs
import page
import style
import study_table
import study_views
from study_folder import SOURCES

import matplotlib.pyplot as plt  # after style, which chooses the backend
from matplotlib.ticker import LogFormatter

# the figures of the page, as far as they are there
CURVES = study_table.IMPACT + \
         ["max_pressure_Pa", "contact_area_m2", "max_shear_traction_Pa", "longitudinal_force_N", "lateral_force_N", "creepage",
          "stick_fraction", "traction_over_friction", "max_von_mises_Pa", "subsurface_von_mises_Pa",
          "subsurface_von_mises_depth_m", "max_plastic_strain", "max_residual_von_mises_Pa"] + study_table.WHEELSET + \
         ["axle_yaw_moment_Nm", "left_lateral_over_vertical", "right_longitudinal_force_N", "left_max_pressure_Pa"]

# errors drawn over the time that they cost
ERRORS = ["max_pressure", "contact_area", "max_shear_traction", "creepage"]
# of the pictures with all cases in the page, which is to stay below 5 MB; those in pictures/ have all of theirs
COLORS = 32
# cases that are drawn side by side at most
MOST_CASES = 16

SMALLEST = 0.1  # per cent; smaller errors are drawn there


class Axis:
    """Places of the cases along an axis; words have places of their own, side by side."""

    def __init__(self, study, a):
        axis = study.axes[a]
        self.label = study_table.header(axis["name"], study_table.unit_of(axis))
        texts = [case["values"][a] for case in study.cases]
        numbers = [study_table.number_of(text) for text in texts]
        self.words = None
        if None in numbers:
            self.words = axis["values"]
            numbers = [self.words.index(text) for text in texts]
        self.places = np.array(numbers, dtype=float)
        self.texts = texts

    def dress(self, axes):
        axes.set_xlabel(self.label)
        if self.words:
            axes.set_xticks(range(len(self.words)), self.words)


def curves_of(study):
    """Rows of cases that make one curve over the first axis, with what they have in common; one curve where each case
    has a value of its own on that axis."""
    first = [case["values"][0] for case in study.cases]
    if len(set(first)) == len(first):
        return {"": list(range(len(first)))}
    curves = {}
    for row, case in enumerate(study.cases):
        name = ", ".join(f"{axis['name'].lower()} {value}" for axis, value in zip(study.axes[1:], case["values"][1:]))
        curves.setdefault(name, []).append(row)
    return curves


def draw_curves(study, columns, key, x, curves):
    """Finite elements with dots and lines, half-spaces and true bodies with open marks and broken lines; the path, or None
    without figures."""
    marks = {"": ("o", "-", None), "halfspace_": ("s", "--", "white"), "bodies_": ("^", ":", "white")}
    pair = [(columns.get(prefix + key), who, own, *marks[prefix]) for (prefix, who), own in zip(SOURCES.items(), style.COLORS)]
    pair = [part for part in pair if part[0] is not None]
    if not pair or not any(np.any(column.values) for column, *_ in pair if np.isfinite(column.values).any()):
        return None
    figure, axes = plt.subplots(figsize=(6.4, 4.0))
    for color, (name, rows) in zip(np.tile(style.COLORS, 1 + len(curves) // len(style.COLORS)), curves.items()):
        for column, who, alone, mark, line, face in pair:
            rows_here = [row for row in rows if np.isfinite(column.values[row])]
            rows_here.sort(key=lambda row: x.places[row])
            own = color if len(curves) > 1 else alone
            label = who if not name else f"{name}, {who.lower()}" if len(pair) > 1 else name
            axes.plot(x.places[rows_here], column.values[rows_here] * column.factor, mark + line, color=own,
                      markerfacecolor=face or own, markersize=5, linewidth=1.3, label=label)
            if column.low is not None and column.high is not None:
                low, high = np.array(column.low)[rows_here], np.array(column.high)[rows_here]
                style.fill_band(axes, x.places[rows_here], low, high, column.factor, own)
    x.dress(axes)
    axes.set_ylabel(pair[0][0].title)
    axes.grid(True)
    if len(pair) > 1 or len(curves) > 1:
        axes.legend(fontsize=8)
    label = pair[0][0].title.split(" [")[0]
    return label[0].upper() + label[1:], save(study, figure, key)


def save(study, figure, name):
    path = study.path("pictures", name + ".png")
    figure.savefig(path, bbox_inches="tight", pad_inches=0.1, dpi=110)
    plt.close(figure)
    return path


def draw_errors(study, x, curves):
    """Wall time of the runs over their difference from half-spaces where the mesh varies: a picture for each figure."""
    if not any(axis["entry"].startswith("Mesh/") for axis in study.axes):
        return []
    summaries = [study.summaries(case)[0] or {} for case in study.cases]
    pictures = []
    for name in ERRORS:
        points = [(100 * abs(study_table.number(s.get("relative_difference_" + name))), study_table.number(s.get("wall_time_s")))
                  for s in summaries]
        if not any(np.isfinite(error) for error, _ in points):
            continue
        label = next(figure["label"] for figure in study.figures if figure["std_key"].split("_std")[0] == name)
        figure, axes = plt.subplots(figsize=(6.4, 4.4))
        for color, (curve, rows) in zip(np.tile(style.COLORS, 1 + len(curves) // len(style.COLORS)), curves.items()):
            rows = sorted((row for row in rows if np.isfinite(points[row][0])), key=lambda row: x.places[row])
            errors, times = [max(SMALLEST, points[row][0]) for row in rows], [points[row][1] for row in rows]
            axes.plot(errors, times, "o-", color=color, label=curve or None, linewidth=1.2, markersize=5)
            for k, row in enumerate(rows):
                axes.annotate(x.texts[row], (errors[k], times[k]), fontsize=8, ha="center", textcoords="offset points",
                              xytext=(0, 7 if k % 2 else -13))
        axes.set(xscale="log", yscale="log", xlabel=f"difference of the {label} from half-spaces [%]",
                 ylabel="wall time of the run [s]")
        for axis in (axes.xaxis, axes.yaxis):  # 2.9 in place of 2.9 x 10^0
            axis.set_major_formatter(LogFormatter())
            axis.set_minor_formatter(LogFormatter(labelOnlyBase=False))
        axes.grid(True, which="both", alpha=0.4)
        axes.margins(0.15)
        if len(curves) > 1:
            axes.legend(fontsize=8)
        pictures.append((f"Error of the {label} and its cost, at the points: {x.label.lower()}",
                         save(study, figure, "error_" + name)))
    return pictures


def table(study, columns, states):
    """The cases with their main figures; who has none says why."""
    axes = study_table.axis_columns(study)
    shown = [columns[prefix + key] for key in study_table.SHOWN for prefix in SOURCES if prefix + key in columns]
    heads = [head for head, _ in axes] + ["verdict"] + [page.printed_header(column.header) for column in shown]
    rows = ["<table><tr>" + "".join(f"<th>{html.escape(head)}</th>" for head in heads) + "</tr>"]
    for row, state in enumerate(states):
        cells = [f"<td class=number>{html.escape(texts[row])}</td>" for _, texts in axes]
        word, doubts = study_table.verdict(study.summaries(study.cases[row]))
        word = word if state.word == "finished" and word else state.word
        cells.append(f'<td class={page.VERDICT_CLASS.get(word, "bad")} title="{html.escape(doubts)}">{html.escape(word)}</td>')
        for column in shown:
            value = column.values[row]
            cells.append(f"<td class=number>{page.number(value, column.factor, column.decimals) if np.isfinite(value) else ''}</td>")
        rows.append("<tr>" + "".join(cells) + "</tr>")
    return "\n".join(rows + ["</table>"])


class Place:
    """Where the pictures of all cases go."""

    def __init__(self, study):
        self.pictures_folder = study.path("pictures")


def members_of(study):
    """The cases that are drawn side by side; of many, some at equal steps."""
    members = []
    step = -(-len(study.cases) // MOST_CASES)
    for case in study.cases[::step]:
        folders = [study.path(case["name"]), study.path(case["name"] + "-halfspace")]
        run, halfspace = (folder if os.path.exists(os.path.join(folder, "summary.json")) else None for folder in folders)
        if run or halfspace:
            members.append(family_pictures.Case(study.label(case), run, halfspace))
    return members


def verdicts(study):
    """How many cases have which verdict."""
    numbers = {"trusted": 2, "with care": 1, "not trusted": 0}
    words = [study_table.verdict(study.summaries(case))[0] for case in study.cases]
    return page.verdict_counts([numbers[word] for word in words if word in numbers], "cases")


def inputs_of(study, members):
    """What all cases have in common, from the first that is there; what varies is named."""
    for member in members:
        data, of = (member.run, inputs.FINITE) if member.run else (member.halfspace, inputs.HALF)
        rows = inputs.rows(inputs.read(data.folder), data.summary if data.has("summary.json") else None, of)
        if rows:
            varied = ", ".join(axis["name"].lower() for axis in study.axes)
            return inputs.table(rows + [("varied", varied + f" (the values above are those of {member.label})")])
    return ""


def write(study, failures, processes):
    """Draws the pictures, by so many processes, and writes study.html; returns its path."""
    os.makedirs(study.path("pictures"), exist_ok=True)
    columns = {column.key: column for column in study_table.columns_of(study)}
    states = [study.state(case, failures) for case in study.cases]
    x, curves = Axis(study, 0), curves_of(study)
    members = members_of(study)
    script = page.plotly_script()
    of_curves = [functools.partial(draw_curves, study, columns, key, x, curves) for key in CURVES]
    of_errors = functools.partial(draw_errors, study, x, curves)
    of_family = family_pictures.calls(Place(study), members)
    with drawing.Drawing([*of_curves, of_errors, *of_family], processes) as drawn:
        shown = study_views.make(columns, CURVES, x, curves, members) if script else []
        results = drawn.results()
    pictures = [picture for picture in results[:len(CURVES)] if picture]
    errors = results[len(CURVES)]
    family = [picture for pictures_of in results[len(CURVES) + 1:] for picture in pictures_of]
    varied = ", ".join(axis["entry"] for axis in study.axes)
    parts = verdicts(study) + [f"<p>{len(study.cases)} cases over {html.escape(varied)}; from {html.escape(study.plan['file'])}, "
             f"version {html.escape(study.version)}.</p>"]
    if script is None:
        parts.append("<p class=remark>Python's plotly is not installed (package python3-plotly); the page shows pictures alone.</p>")
    parts += [f"<p class=bad>{html.escape(study.label(case))}: {html.escape(state.word)}: {html.escape(state.sentence)}</p>"
              for case, state in zip(study.cases, states) if state.sentence]
    parts += [f"<p class={page.VERDICT_CLASS.get(word, 'bad')}>{html.escape(study.label(case))}: {html.escape(word)}: "
              f"{html.escape(doubts)}</p>"
              for case in study.cases for word, doubts in [study_table.verdict(study.summaries(case))] if doubts]
    parts += ["<div class=top><div><h2>Inputs</h2>", inputs_of(study, members), "</div></div>", "<h2>Key results</h2><div class=wide>",
              table(study, columns, states), "</div>", *cell_limits.table(study, columns)]
    if family and os.path.basename(family[0][1]) == "family_head.png":
        parts += ["<div class=pictures>", page.picture(*family.pop(0), "broad", COLORS), "</div>"]
    if shown:
        parts += ["<h2>Views</h2>", page.views_html(shown)]
    covered = "print" if any(view["id"] == "view-figures" for view in shown) else ""
    for head, list_of, kind in (("Curves", pictures, covered), ("Error and cost", errors, "")):
        if list_of:
            parts += [f'<div class="{kind}"><h2>{head}</h2>', "<div class=pictures>", *[page.picture(*item) for item in list_of],
                      "</div></div>"]
    if family:
        parts += ["<h2>Cases side by side</h2><p>Last output step of each run. Tractions act on the rail; maps show the right-hand rail "
                  "from above, rolling direction up. G.C.: side of the gauge corner (track centre), F.S.: field side.</p>",
                  "<div class=pictures>", *[page.picture(*item, "broad", COLORS) for item in family], "</div>"]
    return page.write(study.path("study.html"), study.title, parts, shown, script)
