#!/usr/bin/python3
"""Makes the page of the command wear: profiles, worn depth across them, and what changes over the traffic.

Usage: wear_evolution.py FOLDER

FOLDER holds wear.csv and profiles/; the page is FOLDER/wear.html, its pictures are in FOLDER/pictures.
"""

import html
import json
import os
import sys

sys.dont_write_bytecode = True  # the scripts may lie in a folder that is not ours to write to

import matplotlib.pyplot as plt
import numpy as np

import columns
import inputs
import page
import style

#: states that are drawn on top of each other
MOST_STATES = 6
#: over the traffic: name of the picture, title, (column, factor, label)
HISTORIES = [
    ("depth", "Worn off", [("rail_depth_m", 1e3, "deepest on\nthe rail [mm]"), ("wheel_depth_m", 1e3, "deepest on\nthe wheel [mm]"),
                           ("rail_section_m2", 1e6, "section of the\nrail [mm\u00b2]"),
                           ("wheel_section_m2", 1e6, "section of the\nwheel [mm\u00b2]")]),
    ("limits", "Measures that have limits (EN 15313)", [("rail_height_loss_m", 1e3, "height lost at\nthe rail's axis [mm]"),
                                           ("rail_side_wear_m", 1e3, "gauge side of\nthe rail [mm]"),
                                           ("flange_height_m", 1e3, "flange height\nSh [mm]"),
                                           ("flange_thickness_m", 1e3, "flange thickness\nSd [mm]"),
                                           ("flange_gradient_m", 1e3, "flange gradient\nqR [mm]")]),
    ("contact", "Contact", [("mean_peak_pressure_Pa", 1e-6, "peak pressure,\nmean of the mix [MPa]"),
                            ("largest_peak_pressure_Pa", 1e-6, "peak pressure,\nlargest [MPa]"),
                            ("mean_t_gamma_N", 1, "T-gamma, mean [N]"), ("largest_t_gamma_N", 1, "T-gamma, largest [N]"),
                            ("equivalent_conicity", 1, "equivalent conicity\nat 3 mm")]),
    ("damage", "Crack damage, 1: cracks", [("rail_damage", 1, "rail, after Burstow"), ("rail_net_cracks", 1, "rail, net of\ncracks and wear"),
                                           ("wheel_damage", 1, "wheel, after Burstow"), ("wheel_net_cracks", 1, "wheel, net")]),
]
#: of the table at the top: column, factor, label, unit, digits
FIGURES = [("rail_section_m2", 1e6, "rail: section lost", "mm\u00b2", 2), ("rail_height_loss_m", 1e3, "rail: height lost at its axis", "mm", 3),
           ("rail_side_wear_m", 1e3, "rail: gauge side, 14 mm below the new top", "mm", 3),
           ("rail_damage", 1, "rail: largest damage", "1: cracks", 3), ("rail_net_cracks", 1, "rail: net of cracks and wear", "1: cracks", 3),
           ("rail_ground_section_m2", 1e6, "rail: section ground off", "mm\u00b2", 2), ("wheel_section_m2", 1e6, "wheel: section lost", "mm\u00b2", 2),
           ("flange_height_m", 1e3, "wheel: flange height Sh", "mm", 2), ("flange_thickness_m", 1e3, "wheel: flange thickness Sd, 10 mm below the tread", "mm", 2),
           ("flange_gradient_m", 1e3, "wheel: flange gradient qR", "mm", 2), ("wheel_damage", 1, "wheel: largest damage", "1: cracks", 3), ("wheel_net_cracks", 1, "wheel: net of cracks and wear", "1: cracks", 3),
           ("wheel_turned_section_m2", 1e6, "wheel: section turned off", "mm\u00b2", 2),
           ("equivalent_conicity", 1, "equivalent conicity at 3 mm", "", 3),
           ("mean_peak_pressure_Pa", 1e-6, "peak pressure, mean of the mix", "MPa", 1), ("mean_t_gamma_N", 1, "T-gamma, mean of the mix", "N", 2)]


def traffic(table):
    """Values and label of what passes from state to state."""
    if np.isfinite(table["gross_load_kg"]).any():
        return table["gross_load_kg"] * 1e-9, "gross load [Mt]"
    return table["distance_m"] * 1e-3, "distance of the wheel [km]"


def drawn_states(number):
    return sorted({round(k) for k in np.linspace(0, number - 1, min(number, MOST_STATES))})


def shapes(folder, body, states):
    """Of each state x, y, depth [mm] and damage."""
    return [np.loadtxt(os.path.join(folder, "profiles", f"{body}_{state:04d}.txt"), comments="#") for state in states]


def draw_profiles(folder, body, states, over, label, path):
    """Profile above, worn depth and damage below, over the same places; gauge side on the left."""
    all_shapes = shapes(folder, body, states)
    rows = 3 if (all_shapes[-1][:, 3] > 0).any() else 2
    # as high as makes both scales of the profile about equal, axes being 8 inches wide and 5 % wider than the profile
    wide, high = (1.05 * np.ptp(all_shapes[0][:, k]) for k in (0, 1))
    heights = [8 * high / wide + 0.5, 3, 1.5][:rows]
    figure, all_axes = plt.subplots(rows, 1, figsize=(9, sum(heights)), sharex=True, constrained_layout=True,
                                    height_ratios=heights)
    colors = style.in_order(len(states))
    for shape, state, color in zip(all_shapes, states, colors):
        name = f"{over[state]:.4g}"
        all_axes[0].plot(shape[:, 0], shape[:, 1], color=color, linewidth=1.2, label=name)
        all_axes[1].plot(shape[:, 0], shape[:, 2], color=color, linewidth=1.2, label=name)
        if rows == 3:
            all_axes[2].plot(shape[:, 0], shape[:, 3], color=color, linewidth=1.2)
            all_axes[2].set_ylabel("crack damage")
    all_axes[0].set(ylabel="y [mm]", title=f"Profile of the {body}")
    all_axes[1].set(ylabel="worn depth, along the normal [mm]")
    all_axes[1].set_ylim(bottom=0)
    all_axes[1].legend(title=label, fontsize=8)
    all_axes[-1].set(xlabel="x [mm]   (gauge side or flange on the left, field side on the right)")
    for axes in all_axes:
        axes.grid(True, alpha=0.4)
    figure.savefig(path)
    plt.close(figure)
    return f"{body.capitalize()}: profile, worn depth, damage", path


def kept(table):
    """The body whose profile stays, as its columns and labels begin; empty where both wear."""
    return tuple(body for body in ("rail", "wheel") if not (table[body + "_depth_m"] > 0).any())


def draw_history(table, over, label, title, rows, path):
    """One row of axes a column of a worn body that changes; None where nothing does."""
    rows = [row for row in rows if not row[0].startswith(kept(table)) and np.isfinite(table[row[0]]).any() and np.ptp(table[row[0]][np.isfinite(table[row[0]])]) > 0]
    if not rows:
        return None
    figure, all_axes = plt.subplots(len(rows), 1, figsize=(7.5, 1 + 1.9 * len(rows)), sharex=True, squeeze=False,
                                    constrained_layout=True)
    for axes, (key, factor, text) in zip(all_axes[:, 0], rows):
        axes.plot(over, factor * table[key], ".-", color=style.COLORS[0], linewidth=1.2)
        style.band(axes, over, table, key, factor, style.COLORS[0])
        axes.set_ylabel(text, fontsize=10)
        axes.grid(True, alpha=0.4)
    all_axes[-1, 0].set_xlabel(label)
    all_axes[0, 0].set_title(title)
    figure.savefig(path)
    plt.close(figure)
    return title, path


def figures(table):
    rows = ["<table><tr><th></th><th>new</th><th>worn</th><th></th></tr>"]
    for key, factor, label, unit, digits in FIGURES:
        values = factor * table[key][[0, -1]]
        if np.isfinite(values).all() and (values != 0).any() and not label.startswith(kept(table)):
            rows.append(f"<tr><td>{html.escape(label)}</td>" + "".join(f"<td class=number>{value:.{digits}f}</td>" for value in values) +
                        f"<td>{unit}</td></tr>")
    return "\n".join(rows + ["</table>"])


def remarks(folder):
    """What wear.json says besides: that the plan is not done, and what was found before; "" without that file."""
    path = os.path.join(folder, "wear.json")
    if not os.path.exists(path):
        return ""
    with open(path, encoding="utf-8") as file:
        state = json.load(file)
    sentences = [] if state["finished"] else ["Not finished: the same command resumes here."]
    sentences += [state["note"], state.get("beside_bodies")]
    verdict = page.verdict_sentence({**state, "finished": True}) if "verdict" in state else ""
    return verdict + "".join(f"<p>{html.escape(sentence)}</p>" for sentence in sentences if sentence)


def make_page(folder):
    table = columns.read(os.path.join(folder, "wear.csv"))
    over, label = traffic(table)
    pictures_folder = os.path.join(folder, "pictures")
    os.makedirs(pictures_folder, exist_ok=True)
    states = drawn_states(len(over))
    pictures = [draw_profiles(folder, body, states, over, label, os.path.join(pictures_folder, body + ".png"))
                for body in ("rail", "wheel") if (table[body + "_depth_m"] > 0).any()]
    pictures += [draw_history(table, over, label, title, rows, os.path.join(pictures_folder, name + ".png"))
                 for name, title, rows in HISTORIES]
    given = inputs.table(inputs.wear_rows(inputs.read(folder)))
    what, unit = label.rstrip("]").split(" [")
    parts = [remarks(folder), f"<p>{len(over) - 1} steps, {html.escape(what)} {over[-1]:.4g} {unit}.</p>",
             f"<div class=top><div><h2>Inputs</h2>{given}</div>" if given else "<div class=top>",
             f"<div><h2>Key results</h2>{figures(table)}</div></div>", "<h2>Pictures</h2>",
             page.pictures_html([picture for picture in pictures if picture], broad=("rail", "wheel"))]
    return page.write(os.path.join(folder, "wear.html"), inputs.title(inputs.read(folder), "wear of the profiles"), parts, [], "")


if __name__ == "__main__":
    sys.exit(page.run_script(__doc__, make_page, sys.argv[1:]))
