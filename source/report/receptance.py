#!/usr/bin/python3
"""Makes the page of the command receptance: mobility with its phase, accelerance, cross mobility and decay rate.

Usage: receptance.py FOLDER

FOLDER holds receptance.csv, resonances.csv and summary.json, and waves.csv or beside.csv where there are such; the page is
FOLDER/receptance.html, its pictures are in FOLDER/pictures.
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

#: of each table: file, label, how it is drawn
SOURCES = [("receptance.csv", "hammer on the elements", {"color": style.BLUE, "linewidth": 1.6}),
           ("waves.csv", "waves of the section", {"color": style.RED, "linestyle": "none", "marker": "o", "markersize": 3.5,
                                                  "fillstyle": "none"}),
           ("beside.csv", "beside", {"color": style.GREEN, "linewidth": 1.2, "linestyle": "--"})]


#: frequencies that axes name [Hz]
TICKS = [20, 50, 100, 200, 500, 1000, 2000, 5000]


def name_frequencies(axes):
    axes.set_xticks(TICKS, [str(tick) for tick in TICKS])
    axes.set_xticks([], minor=True)
    axes.set_xlim(TICKS[0], TICKS[-1])
    axes.set_xlabel("frequency [Hz]")


def draw_curves(tables, name, label, axes):
    for table, text, how in tables:
        if name in table:
            axes.loglog(table["frequency_Hz"], table[name], label=text, **how)
    axes.set_ylabel(label)
    axes.grid(True, which="both", alpha=0.5)
    axes.legend(loc="best")




def draw_mobility(tables, peaks, summary, path):
    figure, (upper, lower) = plt.subplots(2, 1, figsize=(9, 6.4), sharex=True, height_ratios=[3, 1.2],
                                          constrained_layout=True)
    if summary.get("pinned_pinned_Hz"):
        upper.axvline(summary["pinned_pinned_Hz"], color=style.GREY, linewidth=0.9, linestyle=":",
                      label=f"pinned-pinned, {summary['pinned_pinned_Hz']:.0f} Hz")
    draw_curves(tables, "mobility_m_per_Ns", "mobility [m/(N s)]", upper)
    for table, _, how in tables:
        if "phase_rad" in table:  # the velocity is a quarter of a turn ahead
            degrees = (np.degrees(table["phase_rad"]) + 90 + 180) % 360 - 180
            lower.semilogx(table["frequency_Hz"], degrees, **how)
    name_frequencies(lower)
    lower.set(ylabel="phase [degrees]", ylim=(-100, 100), yticks=[-90, -45, 0, 45, 90])
    lower.grid(True, which="both", alpha=0.5)
    style.name_places(upper, peaks["frequency_Hz"], peaks["mobility_m_per_Ns"],
                      [f"{frequency:.0f}" for frequency in peaks["frequency_Hz"]])
    figure.savefig(path)
    plt.close(figure)
    return "Mobility where the hammer hits: size and phase", path


def draw_one(tables, name, label, title, path):
    figure, axes = plt.subplots(figsize=(7.5, 4.4), constrained_layout=True)
    draw_curves(tables, name, label, axes)
    name_frequencies(axes)
    figure.savefig(path)
    plt.close(figure)
    return title, path


def results(peaks, summary):
    rows = ["<table><tr><th class=number>resonance [Hz]</th><th class=number>mobility [m/(N s)]</th>"
            "<th class=number>loss factor</th></tr>"]
    for frequency, mobility, loss in zip(peaks["frequency_Hz"], peaks["mobility_m_per_Ns"], peaks["loss_factor"]):
        rows.append(f"<tr><td class=number>{frequency:.0f}</td><td class=number>{mobility:.2e}</td>"
                    f"<td class=number>{'' if np.isnan(loss) else format(loss, '.3f')}</td></tr>")
    rows.append("</table>")
    if summary.get("pinned_pinned_Hz"):
        rows.append(f"<p>Pinned-pinned, a wave of two bays on the unsupported rail: {summary['pinned_pinned_Hz']:.0f} Hz.</p>")
    if "waves_mean_difference_dB" in summary:
        rows.append(f"<p>Mobility by waves of the section differs by {summary['waves_mean_difference_dB']:.1f} dB in the mean, by "
                    f"{summary['waves_largest_difference_dB']:.1f} dB at most ({summary['waves_largest_difference_at_Hz']:.0f} Hz).</p>")
    if summary.get("cut_peak_dB"):
        rows.append(f"<p>The peak at {summary['cut_peak_Hz']:.0f} Hz is cut by {summary['cut_peak_dB']:.1f} dB by the length of "
                    f"record and rail: its height is that of the waves.</p>")
    if summary["fading_per_s"] > 0:
        rows.append(f"<p>{100 * summary['left_at_the_end']:.0f} % of the motion were left at the end of the record; it is "
                    f"faded, which makes peaks {summary['fading_per_s'] / np.pi:.0f} Hz broader.</p>")
    return "\n".join(rows)


def make_page(folder):
    tables = [(columns.read(os.path.join(folder, name)), label, how) for name, label, how in SOURCES
              if os.path.exists(os.path.join(folder, name))]
    peaks = columns.read(os.path.join(folder, "resonances.csv"))
    with open(os.path.join(folder, "summary.json"), encoding="utf-8") as file:
        summary = json.load(file)
    pictures_folder = os.path.join(folder, "pictures")
    os.makedirs(pictures_folder, exist_ok=True)

    def path(name):
        return os.path.join(pictures_folder, name + ".png")

    pictures = [draw_mobility(tables, peaks, summary, path("mobility")),
                draw_one(tables, "receptance_m_per_N", "receptance [m/N]", "Receptance", path("receptance")),
                draw_one(tables, "accelerance_per_kg", "accelerance [m/s\u00b2 per N]", "Accelerance", path("accelerance")),
                draw_one(tables, "cross_mobility_m_per_Ns", "mobility [m/(N s)]",
                         "Cross mobility: motion across the blow", path("cross"))]
    along = next((name for name in tables[0][0] if name.startswith("at_") and "mobility" in name), None)
    if along:
        pictures.append(draw_one(tables, along, "mobility [m/(N s)]",
                                 f"Mobility {along.split('_')[1].replace('mm', ' mm')} farther along the rail", path("along")))
    if "decay_rate_dB_per_m" in tables[0][0]:
        pictures.append(draw_one(tables, "decay_rate_dB_per_m", "decay rate [dB/m]", "Decay along the track", path("decay")))
    given = inputs.table(inputs.track_rows(inputs.read(folder), summary))
    parts = [f"<div class=top><div><h2>Inputs</h2>{given}</div>", f"<div><h2>Key results</h2>{results(peaks, summary)}</div></div>",
             "<h2>Pictures</h2>", page.pictures_html(pictures, broad=("mobility",))]
    return page.write(os.path.join(folder, "receptance.html"), html.unescape(summary["title"]) + ": receptance", parts, [], "")


if __name__ == "__main__":
    sys.exit(page.run_script(__doc__, make_page, sys.argv[1:]))
