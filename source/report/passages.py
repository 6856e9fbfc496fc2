"""Pictures and page of passages: what wheel after wheel leaves in the rail.

The folder holds passages.csv and, of runs of this version, passages.h5 (doc/manual/passages.md).
"""

import html
import os
import re
import shlex

import h5py
import matplotlib.pyplot as plt
import numpy as np
from matplotlib.colors import LogNorm, SymLogNorm

import columns
import inputs
import page
import shakedown
import style
import wheelrail

DEPTH = 8  # shown [mm]

#: curves over passages: (key, factor, label) in one panel each
CURVES = [
    [("max_pressure_Pa", 1e-6, "peak pressure [MPa]")],
    [("contact_area_m2", 1e6, "area of the patch [mm$^2$]")],
    [("patch_lateral_m", 1e3, "patch across [mm]"), ("patch_longitudinal_m", 1e3, "along [mm]")],
    [("plastic_band_width_m", 1e3, "width of the plastic zone [mm]"), ("plastic_band_depth_m", 1e3, "depth [mm]")],
    [("residual_lateral_stress_Pa", 1e-6, "residual stress across [MPa]"),
     ("residual_longitudinal_stress_Pa", 1e-6, "along [MPa]")],
    [("plastic_work_rail_J", 1, "plastic work in the rail [J]")],
]


class Family:
    """Figures and fields over passages."""

    def __init__(self, folder):
        self.folder = folder
        self.pictures_folder = os.path.join(folder, "pictures")
        self.remarks = []
        self.table = columns.read(os.path.join(folder, "passages.csv"))
        self.passages = self.table["passage"]
        self.fields = self.read_fields()
        os.makedirs(self.pictures_folder, exist_ok=True)

    def read_fields(self):
        """The cuts of passages.h5 below the lateral place that has flowed most, [passage, depth]; None without."""
        path = os.path.join(self.folder, "passages.h5")
        if not os.path.exists(path):
            self.remarks.append("There is no passages.h5; the pictures over depth are left out.")
            return None
        with h5py.File(path, "r") as file:
            if "BB_behind_rail" not in file:
                self.remarks.append("passages.h5 has no cuts behind the wheels, which need a longer distance; the pictures "
                                    "over depth are left out.")
                return None
            cut = file["BB_behind_rail"]
            strain = cut["plastic_strain"][-1]
            column = np.unravel_index(np.nanargmax(strain), strain.shape)[0]
            fields = {name: data[:, column, :] for name, data in cut.items() if data.ndim == 3}
            fields["depth"] = 1e3 * cut["depth"][:]
            fields["passages"] = cut["passage"][:]
            fields["lateral"] = 1e3 * cut["position"][column]
        return fields

    def has(self, key):
        return key in self.table and np.isfinite(self.table[key]).any()


def chosen(count):
    """Some passages of many: the first, then about each twice the one before, and the last."""
    picked = {0, count - 1}
    step = 1
    while step < count:
        picked.add(step)
        step *= 2
    return sorted(picked)


def passage_axis(axes, passages):
    axes.set_xlabel("passage")
    axes.set_xlim(passages[0] - 0.5, passages[-1] + 0.5)
    axes.xaxis.set_major_locator(plt.MaxNLocator(integer=True))


def draw_growth(family):
    """What each passage adds to the plastic strain and to the forward flow."""
    rows = [(key, factor, label) for key, factor, label in
            (("plastic_strain_increment", 1, "growth of the largest\nplastic strain"),
             ("forward_flow_increment_m", 1e6, "growth of the\nforward flow [um]")) if family.has(key)]
    if not rows:
        return []
    figure, all_axes = plt.subplots(len(rows), 1, figsize=(7.5, 1 + 2.4 * len(rows)), sharex=True, squeeze=False)
    for axes, (key, factor, label) in zip(all_axes[:, 0], rows):
        values = factor * family.table[key]
        for sign, color, name in ((1, style.BLUE, "positive"), (-1, style.RED, "negative (backwards)")):
            part = sign * values > 0
            if part.any():
                axes.plot(family.passages[part], np.abs(values[part]), "o-", color=color, markersize=4, label=name)
        axes.set_yscale("log")
        axes.set_ylabel(label)
        axes.grid(True)
        if (values < 0).any():
            axes.legend(loc="best")
    passage_axis(all_axes[-1, 0], family.passages)
    return [("What each passage adds: largest plastic strain across the rail behind the wheel, and forward flow of "
             "the surface", style.save(family, figure, "growth"))]


def draw_curves(family):
    panels = [[row for row in rows if family.has(row[0])] for rows in CURVES]
    panels = [rows for rows in panels if rows]
    if not panels:
        return []
    lines = (len(panels) + 1) // 2
    figure, all_axes = plt.subplots(lines, 2, figsize=(10, 0.6 + 2.5 * lines), squeeze=False,
                                    gridspec_kw={"wspace": 0.3, "hspace": 0.35})
    for axes in all_axes.flat[len(panels):]:
        axes.set_visible(False)
    for axes, rows in zip(all_axes.flat, panels):
        for (key, factor, label), color in zip(rows, style.COLORS):
            axes.plot(family.passages, factor * family.table[key], "o-", color=color, markersize=3.5, label=label)
            style.band(axes, family.passages, family.table, key, factor, color)
        axes.grid(True)
        if len(rows) > 1:
            axes.legend(loc="best")
        else:
            axes.set_ylabel(rows[0][2])
        passage_axis(axes, family.passages)
    return [("Patch, pressure, plastic zone and residual stresses over the passages",
             style.save(family, figure, "passages"))]


def map_panel(axes, fields, values, label, norm, colors, ticks=None):
    edges = np.append(fields["depth"] - 0.5 * (fields["depth"][1] - fields["depth"][0]),
                      fields["depth"][-1] + 0.5 * (fields["depth"][1] - fields["depth"][0]))
    along = np.append(fields["passages"] - 0.5, fields["passages"][-1] + 0.5)
    image = axes.pcolormesh(along, edges, values.T, norm=norm, cmap=colors)
    bar = style.color_bar(axes.figure, axes, image, label)
    if ticks is not None:
        bar.set_ticks(ticks)
    axes.set_ylim(DEPTH, 0)
    axes.set_ylabel("depth [mm]")


def draw_maps(family):
    """Growth of plastic strain and of forward shear over passages and depth."""
    fields = family.fields
    if fields is None or len(fields["passages"]) < 2:
        return []
    strain = fields["plastic_strain_increment"]
    top = np.nanmax(strain)
    if not top > 0:
        return []
    rows = 2 if "forward_shear_increment" in fields else 1
    figure, all_axes = plt.subplots(rows, 1, figsize=(8, 0.8 + 2.9 * rows), sharex=True, squeeze=False)
    map_panel(all_axes[0, 0], fields, np.where(strain > 1e-5 * top, strain, np.nan), "growth of plastic strain",
              LogNorm(max(1e-5 * top, np.nanmin(strain[strain > 1e-5 * top])), top), "magma_r")
    if rows == 2:
        shear = fields["forward_shear_increment"]
        size = np.nanmax(np.abs(shear))
        decades = 10.0 ** np.arange(np.floor(np.log10(size)), np.log10(1e-3 * size), -1)  # those that are not linear
        map_panel(all_axes[1, 0], fields, shear, "growth of forward shear",
                  SymLogNorm(1e-3 * size, vmin=-size, vmax=size), "RdBu_r", [*-decades, 0, *decades[::-1]])
    passage_axis(all_axes[-1, 0], fields["passages"])
    return [(f"What each passage adds over depth, below the lateral place {fields['lateral']:.1f} mm, which has "
             "flowed most", style.save(family, figure, "growth_depth"))]


def draw_residual(family):
    """Residual stresses and plastic strain over depth after chosen passages."""
    fields = family.fields
    if fields is None:
        return []
    panels = [(name, factor, label) for name, factor, label in
              (("stress_xx", 1e-6, "residual stress across [MPa]"), ("stress_zz", 1e-6, "residual stress along [MPa]"),
               ("plastic_strain", 1e3, "plastic strain [10$^{-3}$]"),
               ("forward_shear", 1e3, "forward shear [10$^{-3}$]"))
              if name in fields]
    figure, all_axes = plt.subplots(1, len(panels), figsize=(3.1 * len(panels), 4.4), sharey=True, squeeze=False)
    picked = chosen(len(fields["passages"]))
    colors = style.in_order(len(picked))
    for axes, (name, factor, label) in zip(all_axes[0], panels):
        for passage, color in zip(picked, colors):
            axes.plot(factor * fields[name][passage], fields["depth"], color=color,
                      label=f"{fields['passages'][passage]:.0f}")
        axes.axvline(0, color="black", linewidth=0.6)
        axes.set_xlabel(label)
        axes.grid(True)
    all_axes[0, 0].set_ylim(DEPTH, 0)
    all_axes[0, 0].set_ylabel("depth [mm]")
    all_axes[0, -1].legend(title="after passage", loc="upper left", bbox_to_anchor=(1.01, 1), borderaxespad=0)
    return [("Left over depth after some passages, the loads taken off, below the lateral place "
             f"{fields['lateral']:.1f} mm", style.save(family, figure, "residual_depth"))]


def pressure_of(text):
    """A stress as parameters.prm writes it, "480 MPa" [Pa]; None for a word."""
    found = re.fullmatch(r"([0-9.eE+-]+)\s*(GPa|MPa|kPa|Pa|)", text.strip())
    return float(found.group(1)) * {"GPa": 1e9, "MPa": 1e6, "kPa": 1e3}.get(found.group(2), 1) if found else None


def hardened(entries, strain):
    """The yield stress [Pa] that isotropic hardening has given the steel at these plastic strains; None where the law is
    not known. Kinematic hardening moves the yield surface and leaves its size."""
    def entry(name):
        return entries.get("Rail material/" + name, "")

    first = pressure_of(entry("Yield stress"))
    if first is None:
        return None
    if entry("Law") == "Chaboche":
        more, rate = pressure_of(entry("Isotropic hardening")), pressure_of(entry("Isotropic rate"))
        return None if more is None or rate is None else first + more * (1 - np.exp(-rate * strain))
    young, tangent = pressure_of(entry("Young's modulus")), pressure_of(entry("Tangent modulus"))
    kinematic = pressure_of(entry("Kinematic hardening fraction"))
    if None in (young, tangent, kinematic) or not tangent < young:
        return None
    return first + (1 - kinematic) * tangent * young / (young - tangent) * strain


def draw_map(family):
    """The shakedown map with the passages on it, by the shear yield stress of the new and of the hardened steel."""
    entries = inputs.read(family.folder)
    stress = pressure_of(entries.get("Rail material/Yield stress", ""))
    if stress is None or not family.has("max_pressure_Pa"):
        family.remarks.append("The yield stress of the rail is not in parameters.prm; the shakedown map is left out.")
        return []
    strain = family.table["rail_plastic_strain"] if family.has("rail_plastic_strain") else np.zeros(len(family.passages))
    later = hardened(entries, np.nan_to_num(strain))
    traction = np.abs(family.table["longitudinal_force_N"] / family.table["vertical_force_N"])
    figure, axes = plt.subplots(figsize=(8.5, 5.4))
    shakedown.draw(axes)
    sets = [("first k", np.full(len(strain), stress), "white")]
    if later is not None and np.nanmax(later) > 1.005 * stress:
        sets.append(("hardened k", later, None))
    top = 0
    for name, yields, face in sets:
        load = family.table["max_pressure_Pa"] / (yields / np.sqrt(3))
        top = max(top, np.nanmax(load))
        axes.plot(traction, load, "-", color=style.GREY, linewidth=0.8)
        for row, mark, color in ((0, "o", style.RED), (-1, "s", style.BLUE)):
            if row == 0 or len(load) > 1:
                axes.plot(traction[row], load[row], mark, color=color, markerfacecolor=face or color, markersize=7,
                          label=f"passage {family.passages[row]:.0f}, {name} = {1e-6 * yields[row] / np.sqrt(3):.0f} MPa")
    axes.set_xlim(0, max(0.6, 1.1 * np.nanmax(traction)))
    axes.set_ylim(0, max(6, 1.1 * top))
    style.legend_beside(axes)
    return [("Shakedown map: peak pressure over the shear yield stress k, over the traction coefficient. First k: yield "
             "stress of the new rail over the root of 3. Hardened k: with the isotropic hardening at the largest plastic "
             "strain so far; a steel that hardens moves down in the map. Below the green line nothing yields, below the orange "
             "line the rail shakes down, above it every wheel yields it anew. The lines hold for line contact with full "
             "slip in perfectly plastic steel (Melan's theorem; Johnson, Contact Mechanics, 1985, section 9.2); a patch that "
             "is short across the track, or that sticks in part, bears more",
             style.save(family, figure, "shakedown_map"))]


def summary_of(family):
    try:
        return wheelrail.load(family.folder).summary
    except wheelrail.DataError:
        return {}


def outcome(family, summary):
    """Where the passages lead to, as the run says it; of a run of an earlier version, what the last passage added."""
    text = summary.get("note")
    if not text and family.has("plastic_strain_increment"):
        growth = family.table["plastic_strain_increment"][-1]
        text = (f"After {family.passages[-1]:.0f} passages: the largest plastic strain grew by {growth:.2g} in the last one."
                if np.isfinite(growth) else "")
    return [f"<p><b>{html.escape(text)}</b></p>"] if text else []


def key_results(family):
    """The last passage beside the first."""
    rows = [("max_pressure_Pa", 1e-6, "peak pressure", "MPa", 0), ("contact_area_m2", 1e6, "contact area", "mm\u00b2", 1),
            ("plastic_band_width_m", 1e3, "width of the plastic zone", "mm", 1),
            ("plastic_band_depth_m", 1e3, "depth of the plastic zone", "mm", 1),
            ("rail_plastic_strain", 1e3, "largest plastic strain", "10\u207b\u00b3", 2),
            ("plastic_strain_increment", 1e3, "added by the passage", "10\u207b\u00b3", 3),
            ("residual_longitudinal_stress_Pa", 1e-6, "largest residual stress along the rail", "MPa", 0),
            ("residual_lateral_stress_Pa", 1e-6, "and across it", "MPa", 0)]
    first, last = family.passages[0], family.passages[-1]
    lines = [f"<tr><th></th><th class=number>passage {first:.0f}</th><th class=number>passage {last:.0f}</th><th></th></tr>"]
    for key, factor, label, unit, decimals in rows:
        if family.has(key):
            cells = "".join(f"<td class=number>{page.number(value, factor, decimals) if np.isfinite(value) else ''}</td>"
                            for value in (family.table[key][0], family.table[key][-1]))
            lines.append(f"<tr><td>{label}</td>{cells}<td>{unit}</td></tr>")
    return "<table>" + "\n".join(lines) + "</table>"


def folders(folder):
    """The folders of the passages that there are, by their numbers."""
    found = {}
    for name in sorted(os.listdir(folder)):
        match = re.fullmatch(r"passage_(\d+)", name)
        if match and os.path.exists(os.path.join(folder, name, "summary.json")):
            found[int(match.group(1))] = os.path.join(folder, name)
    return found


def has_page(folder):
    """Whether the page of a passage is there and newer than its results."""
    made, source = (os.path.join(folder, name) for name in ("report.html", "summary.json"))
    return os.path.exists(made) and os.path.getmtime(made) >= os.path.getmtime(source)


def links(family):
    """The pages of single passages, and how to make those that are not there."""
    there = folders(family.folder)
    words = [f'<a href="{os.path.basename(path)}/report.html">{number}</a>' for number, path in there.items()
             if has_page(path)]
    parts = ["Pages of single passages: " + " ".join(words) + ". "] if words else []
    if len(words) < len(there):
        call, place = html.escape(wheelrail.CALL), html.escape(shlex.quote(family.folder.rstrip("/")))
        missing = os.path.basename(next(path for path in there.values() if not has_page(path)))
        parts.append(f"<code>{call} report {place}/{missing}</code> makes the page of one passage, "
                     f"<code>{call} report {place} --each</code> those of all.")
    return "<p>" + "".join(parts) + "</p>" if parts else ""


def make_report(folder):
    """Draws everything; returns the family, the number of pictures and the path of the page."""
    family = Family(folder)
    pictures = (draw_growth(family) + draw_maps(family) + draw_residual(family) + draw_curves(family) +
                draw_map(family))
    summary = summary_of(family)
    parts = outcome(family, summary) + page.verdict_counts(family.table.get("verdict"), "passages")
    parts += ["<div class=top><div><h2>Inputs</h2>",
              inputs.table(inputs.rows(inputs.read(folder), summary) + [("passages", f"{len(family.passages)}")]),
              "</div><div><h2>Key results</h2>", key_results(family), "</div></div>", links(family)]
    parts += [f"<p class=remark>{html.escape(sentence)}</p>" for sentence in family.remarks]
    parts += ["<h2>Pictures</h2>", page.pictures_html(pictures, (), {"passages", "residual_depth"})]
    title = summary.get("title") or os.path.basename(os.path.abspath(folder)) + ": passages"
    return family, len(pictures), page.write(os.path.join(folder, "report.html"), title, parts, [], "")
