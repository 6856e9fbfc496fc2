"""The one page of a run, of a comparison or of a study: figures, pictures and interactive views in a single HTML file
that needs no network.

Interactive views are drawn by plotly's script (Debian package python3-plotly), which is in the page once, compressed;
each has its picture beside it, which is shown in print and where the script cannot run.
"""

import base64
import gzip
import html
import io
import json
import os
import sys

from whole_file import part_of

STYLE = """
body { font-family: sans-serif; color: #222; max-width: 76rem; margin: 2rem auto; padding: 0 1rem; line-height: 1.45; }
h1 { font-size: 1.6rem; margin-bottom: 0.2rem; } h2 { font-size: 1.2rem; margin-top: 2.2rem; }
table { border-collapse: collapse; } td, th { padding: 0.2rem 0.8rem 0.2rem 0; border-bottom: 1px solid #e2e2e2; text-align: left; }
td.number, th.number { text-align: right; font-variant-numeric: tabular-nums; }
.wide { overflow-x: auto; } .tables { display: flex; flex-wrap: wrap; gap: 0 2.5rem; align-items: flex-start; font-size: 0.92rem; }
.pictures { display: flex; flex-wrap: wrap; gap: 1.2rem; align-items: flex-start; }
figure { margin: 0; flex: 1 1 26rem; max-width: 48rem; } figure.broad { flex-basis: 100%; max-width: none; }
img { max-width: 100%; height: auto; }
figcaption { color: #555; font-size: 0.9rem; }
.top { display: flex; flex-wrap: wrap; gap: 0.4rem 3rem; align-items: flex-start; }
.top h2 { margin: 0.6rem 0 0.3rem; }
.good { color: #1d6b3a; } .care { color: #8a5a00; } .bad { color: #a32116; } .remark { color: #7a5500; }
.view { margin: 0 0 1.6rem; } .view .controls { display: flex; flex-wrap: wrap; gap: 0.4rem 1.2rem; align-items: center; font-size: 0.9rem; }
.view .plot { width: 100%; } .view input[type=range] { width: 16rem; max-width: 60vw; vertical-align: middle; }
body:not(.scripted) .view, .scripted .print { display: none; }
@media print {
  body { max-width: none; margin: 0; font-size: 10pt; } h2 { break-after: avoid; }
  .view { display: none; } .scripted .print, .print { display: block; }
  figure { break-inside: avoid; flex: 1 1 45%; } tr { break-inside: avoid; }
}
@page { margin: 15mm; }
"""

#: unpacks what lies in the page compressed; plotly's script first, then the data of the views
UNPACK = """
async function unpack(id) {
  const text = atob(document.getElementById(id).textContent);
  const bytes = Uint8Array.from(text, c => c.charCodeAt(0));
  const stream = new Blob([bytes]).stream().pipeThrough(new DecompressionStream("gzip"));
  return new Response(stream).text();
}
(async () => {
  if (typeof DecompressionStream === "undefined") return;  // the pictures stay
  const script = document.createElement("script");
  script.textContent = await unpack("plotly");
  document.head.appendChild(script);
  const data = JSON.parse(await unpack("data"));
  document.body.classList.add("scripted");
  for (const view of data) await drawView(view);
  document.body.dataset.ready = "yes";
})().catch(error => { document.body.classList.remove("scripted"); console.error(error); });
"""


def number(value, factor, decimals):
    return f"{factor * value:z.{decimals}f}".replace("-", "\u2212")


def is_number(value):
    return isinstance(value, (int, float)) and not isinstance(value, bool)


def printed_unit(unit):
    """A unit as it is printed in a page."""
    return {"mm2": "mm\u00b2", "um2": "\u00b5m\u00b2", "N/mm2": "N/mm\u00b2", "ug/m/mm2": "\u00b5g/m/mm\u00b2", "um": "\u00b5m",
            "m/s2": "m/s\u00b2", "1e-3": "10\u207b\u00b3", "1e-6": "10\u207b\u2076"}.get(unit, unit)


def unit_text(figure):
    """The unit of a figure as it is printed in a page."""
    return printed_unit(figure["unit"])


def printed_header(header):
    """The head of a column, "contact area [mm2]", with its unit as it is printed."""
    label, bracket, unit = header.partition(" [")
    return label + bracket + (printed_unit(unit[:-1]) + "]" if bracket else "")


def label_text(figure):
    remark = f" ({figure['remark']})" if figure["remark"] else ""
    return figure["label"][0].upper() + figure["label"][1:] + remark


def figure_rows(summary, figures):
    """Rows of name, value, standard deviation with the standard error of the mean and the interval of 95 %, unit."""
    rows = []
    for figure in figures:
        value, deviation = summary.get(figure["key"]), summary.get(figure["std_key"])
        if not is_number(value):
            continue
        spread = []
        if is_number(deviation):
            spread.append("\u00b1 " + number(deviation, figure["factor"], figure["decimals"]))
        error = summary.get(figure.get("error_key"))
        if is_number(error):
            spread.append("mean \u00b1 " + number(error, figure["factor"], figure["decimals"] + 1))
        spread = ", ".join(spread)
        ends = [summary.get(figure.get(key)) for key in ("low_key", "high_key")]
        if all(map(is_number, ends)):
            spread += " (" + " to ".join(number(end, figure["factor"], figure["decimals"]) for end in ends) + ")"
        rows.append((label_text(figure), number(value, figure["factor"], figure["decimals"]), spread, unit_text(figure)))
    return rows


#: the results that stand at the top of a page, as far as there are such figures
KEY_RESULTS = ["largest_vertical_force_N", "largest_vertical_force_at_m", "least_vertical_force_N",
               "least_vertical_force_at_m", "first_rail_force_N", "first_rail_force_at_m", "second_rail_force_N",
               "second_rail_force_at_m", "impact_factor", "contact_loss_m", "largest_pressure_Pa",
               "largest_pressure_at_m", "von_mises_on_way_Pa", "von_mises_on_way_at_m", "plastic_strain_on_way",
               "plastic_strain_on_way_at_m", "axle_acceleration_up_m_per_s2", "axle_acceleration_down_m_per_s2",
               "vertical_force_N", "lateral_force_N", "lateral_over_vertical", "longitudinal_force_N", "max_pressure_Pa",
               "contact_area_m2", "patch_lateral_m", "patch_longitudinal_m", "patch_centre_from_axis_m",
               "patch_centre_from_gauge_face_m", "patch_centre_below_top_m", "creepage", "stick_fraction", "t_gamma_N",
               "max_shear_traction_Pa", "max_von_mises_Pa", "von_mises_below_cell_Pa", "von_mises_below_cell_depth_m",
               "subsurface_von_mises_Pa", "subsurface_von_mises_depth_m", "max_plastic_strain",
               "max_residual_von_mises_Pa"]


def key_figures(figures, keys=None):
    """Those figures that stand at the top, in their order there."""
    by_key = {figure["key"]: figure for figure in figures}
    return [by_key[key] for key in keys or KEY_RESULTS if key in by_key]


def top(summary, figures, inputs_table, keys=None):
    """Verdict, inputs and key results, with which each page of a result begins."""
    lines = lines_of(figure_rows(summary, key_figures(figures, keys)))
    note = summary.get("note")
    parts = [verdict_sentence(summary), f"<p>{html.escape(note)}</p>" if note else "", "<div class=top>"]
    if inputs_table:
        parts.append("<div><h2>Inputs</h2>" + inputs_table + "</div>")
    if lines:
        parts.append("<div><h2>Key results</h2><table>" + "\n".join(lines) + "</table></div>")
    return parts + ["</div>"]


def further_rows(summary, figures):
    """Figures that the table of figures does not know; those of compare stand in its own page."""
    known = {figure.get(key) for figure in figures for key in ("key", "std_key", "error_key", "low_key", "high_key")}
    return [(key, f"{value:.6g}", "", "") for key, value in summary.items()
            if is_number(value) and key not in known and not key.startswith(("halfspace_", "relative_difference_"))]


def lines_of(rows):
    return [f"<tr><td>{html.escape(label)}</td><td class=number>{value}</td><td>{spread}</td><td>{unit}</td></tr>"
            for label, value, spread, unit in rows]


def table(rows):
    """Rows of name, value, standard deviation, unit in two columns."""
    lines = lines_of(rows)
    half = (len(lines) + 1) // 2
    return "<div class=tables>" + "".join("<table>" + "\n".join(part) + "</table>"
                                          for part in (lines[:half], lines[half:]) if part) + "</div>"


#: how a verdict is coloured; what has none is older than verdicts, or not there
VERDICT_CLASS = {"trusted": "good", "with care": "care", "not trusted": "bad"}


def verdict_of(summary):
    """The verdict that a summary holds, also one written before there were three; "" without figures."""
    if summary.get("verdict"):
        return summary["verdict"]
    if "max_pressure_Pa" not in summary:
        return ""
    return "trusted" if summary.get("trusted", True) else "not trusted"


def verdict_counts(grades, what):
    """How many rows of a table have which verdict (2 trusted, 1 with care, 0 not trusted), a list of one sentence;
    empty where a table of an earlier version has none."""
    if grades is None or not len(grades):
        return []
    counts = {word: sum(grade == number for grade in grades)
              for number, word in ((2, "trusted"), (1, "with care"), (0, "not trusted"))}
    worst = next(word for word in ("not trusted", "with care", "trusted") if counts[word])
    text = ", ".join(f"{count} {word}" for word, count in counts.items() if count)
    return [f"<p class={VERDICT_CLASS[worst]}><b>{html.escape(what.capitalize())}</b>: {text}</p>"]


def verdict_sentence(summary):
    """What stands first on each page of a result."""
    verdict = verdict_of(summary) or "not trusted"
    text = summary.get("doubts") or ""
    if not summary.get("finished"):
        text = "It did not finish. " + str(summary.get("stopped_because") or "No reason is recorded.")
    ended = summary.get("ended_because") if summary.get("ended") in ("steady", "not steady") else None
    return (f"<p class={VERDICT_CLASS.get(verdict, 'bad')}><b>{html.escape(verdict.capitalize())}</b>"
            f"{': ' if text else ''}{html.escape(str(text))}</p>" +
            (f"<p>{html.escape(ended[0].upper() + ended[1:])}.</p>" if ended else ""))


def smaller(path, colors=256):
    """The bytes of a picture with so many colours where that is smaller, as it goes into the page."""
    from PIL import Image

    with open(path, "rb") as file:
        whole = file.read()
    packed = io.BytesIO()
    with Image.open(path) as image:
        image.convert("RGB").quantize(colors, method=Image.Quantize.FASTOCTREE, dither=Image.Dither.NONE).save(
            packed, "PNG", optimize=True)
    return min(whole, packed.getvalue(), key=len)


def picture(caption, path, kind="", colors=256):
    """A picture; kind: print (only there and without script), broad (over the whole width), or both."""
    data = base64.b64encode(smaller(path, colors)).decode()
    caption = html.escape(caption)
    return (f'<figure class="{kind}"><img alt="{caption}" src="data:image/png;base64,{data}">'
            f"<figcaption>{caption}</figcaption></figure>")


def pictures_html(pictures, covered=(), broad=()):
    """Pictures; those whose file names are in `covered` have an interactive view and are for print alone."""
    parts = []
    for caption, path in pictures:
        name = os.path.basename(path)[:-4]
        kind = ("print " if name in covered else "") + ("broad" if name in broad else "")
        parts.append(picture(caption, path, kind.strip()))
    return '<div class=pictures>' + "".join(parts) + "</div>"


def plotly_script():
    """The text of plotly's script; None where the package is not there."""
    try:
        from plotly.offline import get_plotlyjs
    except ImportError:
        return None
    return get_plotlyjs()


def packed(text):
    return base64.b64encode(gzip.compress(text.encode(), 9, mtime=0)).decode()


def views_html(views):
    """Places for the interactive views, which show once the script runs."""
    return "".join(f'<section class=view id="{view["id"]}"><h3>{html.escape(view["title"])}</h3>'
                   '<div class=controls></div><div class=plot></div></section>' for view in views)


def scripts_html(views, script):
    """Plotly's script, the data of the views, and what draws them."""
    if not views:
        return ""
    with open(os.path.join(os.path.dirname(os.path.abspath(__file__)), "views.js"), encoding="utf-8") as file:
        draw = file.read()
    data = json.dumps(views, separators=(",", ":"), allow_nan=False)
    return (f'<script type="application/gzip" id="plotly">{packed(script)}</script>'
            f'<script type="application/gzip" id="data">{packed(data)}</script>'
            f"<script>{draw}{UNPACK}</script>")


def run_script(usage, make_page, arguments):
    """The script of a page: make_page(FOLDER) gives the path of what it made; returns the exit code."""
    if len(arguments) != 1:
        print(usage, file=sys.stderr)
        return 1
    try:
        path = make_page(arguments[0])
    except OSError as error:
        print(error, file=sys.stderr)
        return 1
    print(f"Page in {path}")
    return 0


def write(path, title, parts, views, script):
    """Writes a page as a whole (temporary file, rename); returns its path."""
    text = "\n".join(["<!DOCTYPE html>", '<html lang="en"><head><meta charset="utf-8">',
                      '<meta name="viewport" content="width=device-width, initial-scale=1">',
                      f"<title>{html.escape(title)}</title><style>{STYLE}</style></head><body>",
                      f"<h1>{html.escape(title)}</h1>", *parts, scripts_html(views, script), "</body></html>"])
    with part_of(path) as part, open(part, "w", encoding="utf-8") as file:
        file.write(text)
    return path
