#!/usr/bin/python3
"""Makes the page of a wheelset on its rails: both wheels seen along the track, and their results side by side.

Usage: wheelset.py FOLDER

FOLDER holds wheelset.csv and summary.json of the command halfspace with Wheelset/Wheels = both; the page is
FOLDER/wheelset.html, its picture is in FOLDER/pictures. The pages of the wheels lie in FOLDER/right and FOLDER/left.
"""

import csv
import html
import json
import os
import sys

sys.dont_write_bytecode = True  # the scripts may lie in a folder that is not ours to write to

import matplotlib.pyplot as plt
import numpy as np

import inputs
import page
import style


def read_lines(path):
    """Rows of the table by side and what they are."""
    lines = {}
    with open(path, encoding="utf-8", newline="") as file:
        for row in csv.DictReader(file):
            lines.setdefault((row["side"], row["what"]), []).append((float(row["x"]), float(row["y"])))
    return {key: np.array(places) for key, places in lines.items()}


def draw_side(axes, lines, side, scale):
    """One wheel on its rail; forces as arrows that end in the contact, `scale` kN for each mm."""
    for what, color in (("rail", style.RED), ("wheel", style.BLUE)):
        axes.plot(*lines[side, what].T, color=color, label=what)
    contacts = lines.get((side, "contact"), np.zeros((0, 2)))
    edges = lines.get((side, "edge"), np.zeros((0, 2)))
    forces = lines.get((side, "force"), np.zeros((0, 2)))
    lowest = min((contacts - forces / scale)[:, 1], default=0.0)
    for k, (place, force) in enumerate(zip(contacts, forces)):
        axes.plot(*edges[2 * k:2 * k + 2].T, color="black", linewidth=4, solid_capstyle="butt",
                  label="patch" if k == 0 else None)
        start = place - force / scale
        axes.annotate("", place, start, arrowprops={"arrowstyle": "-|>", "color": style.GREEN, "linewidth": 2})
        pressure, area = lines[side, "peak pressure"][k]
        axes.annotate(f"Y {abs(force[0]):.1f} kN {'to the left' if force[0] < 0 else 'to the right'}, Q {force[1]:.1f} kN\n"
                      f"{pressure:.0f} MPa, {area:.0f} mm\N{SUPERSCRIPT TWO}", (start[0], lowest), (0, -4 - 26 * k), textcoords="offset points",
                      ha="center", va="top", fontsize=8, color=style.GREEN)
    if not len(contacts):
        axes.text(0.5, 0.9, "lifted", transform=axes.transAxes, ha="center")
    middle = lines[side, "rail"][:, 0]
    axes.set_xlim(middle.min() - 35, middle.max() + 35)
    axes.set_ylim(-75, 45)
    axes.set_aspect("equal")
    axes.grid(True)
    axes.set_title(f"{side}-hand wheel")
    axes.set_xlabel("from the middle of the track to the right, mm")
    axes.legend(loc="upper right" if side == "left" else "upper left")


def draw(lines, path):
    forces = np.concatenate([np.abs(lines[key]) for key in lines if key[1] == "force"] + [np.zeros((1, 2))])
    figure, axes = plt.subplots(1, 2, figsize=(12, 5.4), constrained_layout=True)
    scale = max(forces.max(), 1e-3) / 45  # the largest component is 45 mm long
    for side, part in zip(("left", "right"), axes):
        draw_side(part, lines, side, scale)
    axes[0].set_ylabel("height above the running circles, mm")
    figure.suptitle("Both wheels seen in the rolling direction; arrows: forces on the wheels")
    figure.savefig(path, bbox_inches="tight", pad_inches=0.12)
    plt.close(figure)


def shown(figure, value):
    return page.number(value, figure["factor"], figure["decimals"]) if page.is_number(value) else "-"


def table_of_wheels(summary, figures):
    """Both wheels side by side, Y/Q first."""
    figures = dict(sorted(figures.items(), key=lambda item: item[0] != "lateral_over_vertical"))
    figures.pop("rolling_radius_m", None)  # of the rigid contact; creepages are those of the reference point
    rows = ["<table><tr><th></th><th class=number>left</th><th class=number>right</th><th></th></tr>"]
    for key, figure in figures.items():
        sides = [side + key for side in ("left_", "right_")]
        if any(page.is_number(summary.get(side)) for side in sides):
            cells = "".join(f"<td class=number>{shown(figure, summary[side]) if side in summary else 'lifted'}</td>"
                            for side in sides)
            rows.append(f"<tr><td>{html.escape(page.label_text(figure))}</td>{cells}<td>{page.unit_text(figure)}</td></tr>")
    return "\n".join(rows) + "</table>"


def table_of_axle(summary, figures):
    rows = page.figure_rows(summary, [figure for key, figure in figures.items() if key.startswith("axle_")])
    return "<table>" + "\n".join(page.lines_of(rows)) + "</table>"


def make_page(folder):
    """Draws the picture and writes the page; returns its path."""
    with open(os.path.join(folder, "summary.json"), encoding="utf-8") as file:
        summary = json.load(file)
    with open(os.path.join(folder, "figures.json"), encoding="utf-8") as file:
        figures = {figure["key"]: figure for figure in json.load(file)}
    os.makedirs(os.path.join(folder, "pictures"), exist_ok=True)
    picture = os.path.join(folder, "pictures", "wheelset.png")
    draw(read_lines(os.path.join(folder, "wheelset.csv")), picture)
    rows = [row for row in inputs.rows(inputs.read(folder), of=inputs.HALF) if row[0] != "wheel load"]
    if page.is_number(summary.get("axle_load_N")):
        rows.insert(1, ("load", f"{1e-3 * summary['axle_load_N']:.2f} kN on the axle"))
    note = summary.get("note")
    parts = [page.verdict_sentence(summary), f"<p>{html.escape(note)}</p>" if note else "", "<div class=top><div><h2>Inputs</h2>", inputs.table(rows),
             "</div><div><h2>Key results: wheels</h2>", table_of_wheels(summary, figures), "</div><div><h2>Axle</h2>", table_of_axle(summary, figures), "</div></div>",
             page.pictures_html([("Wheels on their rails", picture)], broad=("wheelset",))]
    links = [f'<a href="{side}/report.html">{side}-hand wheel</a>' for side in ("left", "right")
             if os.path.exists(os.path.join(folder, side, "report.html"))]
    if links:
        parts.append("<p>Pages of the wheels: " + ", ".join(links) + "</p>")
    return page.write(os.path.join(folder, "wheelset.html"), summary.get("title") or "Wheelset", parts, [], "")


if __name__ == "__main__":
    sys.exit(page.run_script(__doc__, make_page, sys.argv[1:]))
