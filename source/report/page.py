"""The one page of a run: figures and pictures in a single HTML file that needs no network."""

import base64
import html
import os

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


def unit_text(figure):
    """The unit of a figure as it is printed in a page."""
    return {"mm2": "mm\u00b2", "1e-3": "10\u207b\u00b3"}.get(figure["unit"], figure["unit"])


def label_text(figure):
    remark = f" ({figure['remark']})" if figure["remark"] else ""
    return figure["label"][0].upper() + figure["label"][1:] + remark


def figure_rows(summary, figures):
    """Rows of name, value, standard deviation, unit."""
    rows = []
    for figure in figures:
        value, deviation = summary.get(figure["key"]), summary.get(figure["std_key"])
        if not is_number(value):
            continue
        spread = ""
        if is_number(deviation):
            spread = "\u00b1 " + number(deviation, figure["factor"], figure["decimals"])
        rows.append((label_text(figure), number(value, figure["factor"], figure["decimals"]), spread, unit_text(figure)))
    return rows


def further_rows(summary, figures):
    known = {figure[key] for figure in figures for key in ("key", "std_key")}
    return [(key, f"{value:.6g}", "", "") for key, value in summary.items() if is_number(value) and key not in known]


def table(rows):
    lines = ["<table>"]
    for label, value, spread, unit in rows:
        lines.append(f"<tr><td>{html.escape(label)}</td><td class=number>{value}</td><td>{spread}</td>"
                     f"<td>{unit}</td></tr>")
    return "\n".join(lines + ["</table>"])


def state_sentence(summary):
    if summary.get("finished"):
        doubts = html.escape(str(summary.get("doubts") or ""))
        if doubts:
            return f"<p class=bad>The run finished, but should not be trusted: {doubts}</p>"
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
        if run.figures:
            parts += ["<h2>Figures</h2>", table(figure_rows(run.summary, run.figures))]
        further = further_rows(run.summary, run.figures)
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
