"""The one page of a run: figures and pictures in a single HTML file that needs no network."""

import base64
import html
import os

# key in summary.json, label, unit shown, factor from SI, decimals
FIGURES = [
    ("normal_force_N", "Normal force", "kN", 1e-3, 2),
    ("vertical_force_N", "Vertical force", "kN", 1e-3, 2),
    ("longitudinal_force_N", "Longitudinal force on the wheel (positive forward)", "kN", 1e-3, 2),
    ("lateral_force_N", "Lateral force on the wheel (positive to the track centre)", "kN", 1e-3, 2),
    ("max_pressure_Pa", "Peak pressure", "MPa", 1e-6, 1),
    ("max_pressure_fitted_Pa", "Peak pressure, fitted", "MPa", 1e-6, 1),
    ("contact_area_m2", "Contact area", "mm\u00b2", 1e6, 1),
    ("patch_lateral_m", "Patch across the rail", "mm", 1e3, 2),
    ("patch_longitudinal_m", "Patch along the rail", "mm", 1e3, 2),
    ("max_shear_traction_Pa", "Peak shear traction", "MPa", 1e-6, 1),
    ("stick_fraction", "Sticking part of the patch", "%", 1e2, 1),
    ("creepage", "Creepage", "10\u207b\u00b3", 1e3, 3),
    ("friction_coefficient", "Friction coefficient", "", 1, 3),
    ("max_von_mises_Pa", "Largest von Mises stress", "MPa", 1e-6, 1),
    ("max_plastic_strain", "Largest plastic strain", "10\u207b\u00b3", 1e3, 3),
    ("max_residual_von_mises_Pa", "Largest residual von Mises stress", "MPa", 1e-6, 1),
    ("rolled_distance_m", "Rolled distance", "mm", 1e3, 1),
    ("velocity_m_per_s", "Velocity", "km/h", 3.6, 1),
    ("elements", "Elements", "", 1, 0),
    ("time_steps", "Time steps", "", 1, 0),
    ("time_step_s", "Time step", "ns", 1e9, 2),
    ("element_updates_per_second", "Element updates per second", "million", 1e-6, 2),
    ("energy_error", "Energy error", "%", 1e2, 3),
    ("wall_time_s", "Wall time", "s", 1, 1),
    ("peak_memory_bytes", "Peak memory, all ranks", "MB", 1e-6, 0),
    ("ranks", "Ranks", "", 1, 0),
]

STYLE = """
body { font-family: sans-serif; color: #222; max-width: 62rem; margin: 2rem auto; padding: 0 1rem; line-height: 1.45; }
h1 { font-size: 1.6rem; margin-bottom: 0.2rem; } h2 { font-size: 1.2rem; margin-top: 2.2rem; }
table { border-collapse: collapse; } td, th { padding: 0.2rem 0.8rem 0.2rem 0; border-bottom: 1px solid #e2e2e2; text-align: left; }
td.number { text-align: right; font-variant-numeric: tabular-nums; }
.pictures { display: flex; flex-wrap: wrap; gap: 1.2rem; align-items: flex-start; }
figure { margin: 0; flex: 1 1 26rem; max-width: 48rem; } img { max-width: 100%; height: auto; }
figcaption { color: #555; font-size: 0.9rem; }
.good { color: #1d6b3a; } .bad { color: #a32116; } .remark { color: #7a5500; }
"""


def number(value, factor, decimals):
    return f"{factor * value:.{decimals}f}".replace("-", "\u2212")


def is_number(value):
    return isinstance(value, (int, float)) and not isinstance(value, bool)


def figure_rows(summary):
    """Rows of name, value, standard deviation, unit."""
    rows = []
    for key, label, unit, factor, decimals in FIGURES:
        value = summary.get(key)
        if not is_number(value):
            continue
        base, _, si = key.rpartition("_")
        deviation = summary.get(f"{base}_std_{si}", summary.get(f"{key}_std"))
        spread = "\u00b1 " + number(deviation, factor, decimals) if is_number(deviation) else ""
        rows.append((label, number(value, factor, decimals), spread, unit))
    return rows


def further_rows(summary):
    known = {key for key, *_ in FIGURES}
    return [(key, f"{value:.6g}", "", "") for key, value in summary.items()
            if is_number(value) and key not in known and "_std" not in key]


def table(rows):
    lines = ["<table>"]
    for label, value, spread, unit in rows:
        lines.append(f"<tr><td>{html.escape(label)}</td><td class=number>{value}</td><td>{spread}</td>"
                     f"<td>{unit}</td></tr>")
    return "\n".join(lines + ["</table>"])


def state_sentence(summary):
    if summary.get("finished"):
        return "<p class=good>The run finished.</p>"
    reason = html.escape(str(summary.get("stopped_because") or "No reason is recorded."))
    return f"<p class=bad>The run did not finish. {reason}</p>"


def picture(caption, path):
    with open(path, "rb") as file:
        data = base64.b64encode(file.read()).decode()
    caption = html.escape(caption)
    return (f'<figure><img alt="{caption}" src="data:image/png;base64,{data}">'
            f"<figcaption>{caption}</figcaption></figure>")


def write(run, pictures):
    """Writes report.html as a whole (temporary file, rename); returns its path."""
    parts = ["<!DOCTYPE html>", '<html lang="en"><head><meta charset="utf-8">',
             f"<title>{html.escape(run.title)}</title><style>{STYLE}</style></head><body>",
             f"<h1>{html.escape(run.title)}</h1>"]
    if run.summary is not None:
        parts.append(state_sentence(run.summary))
    parts += [f"<p class=remark>{html.escape(sentence)}</p>" for sentence in run.remarks]
    if run.summary is not None:
        parts += ["<h2>Figures</h2>", table(figure_rows(run.summary))]
        further = further_rows(run.summary)
        if further:
            parts += ["<h2>Further figures (SI)</h2>", table(further)]
    if run.patch is not None:
        parts.append(f"<h2>Pictures</h2><p>Contact patch of tick {run.patch['tick']}: "
                     f"{1e3 * run.patch['time_s']:.3f} ms, {1e3 * run.patch['rolled_distance_m']:.2f} mm rolled. "
                     "Tractions act on the rail. G.C.: side of the gauge corner (track centre), "
                     "F.S.: field side.</p>")
    elif pictures:
        parts.append("<h2>Pictures</h2>")
    parts += ["<div class=pictures>", *[picture(*item) for item in pictures], "</div></body></html>"]

    path = os.path.join(run.folder, "report.html")
    with open(path + ".part", "w", encoding="utf-8") as file:
        file.write("\n".join(parts))
    os.replace(path + ".part", path)
    return path
