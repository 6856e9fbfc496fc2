"""Pressure and shear traction with the traction bound on the lines AA and BB, of one patch or of several in one
axis."""

import matplotlib.pyplot as plt

import style

LABELS = {"AA": "along the rail [mm]   (rolling direction to the right)",
          "BB": "lateral s [mm]   (G.C. on the left, F.S. on the right)"}
NAMES = {"AA": "Cut AA along the rail, s = {:.2f} mm", "BB": "Cut BB across the rail, {:.2f} mm ahead of the contact point"}


def title_of(plane, place):
    return NAMES[plane].format(place + 0.0)


def draw(run, fields_of, plane, name):
    """One picture of a plane; `fields_of`: name -> Fields, the first of which says where the planes lie. Returns
    caption and path."""
    place = next(iter(fields_of.values())).places()[plane]
    figure, axes = plt.subplots(2, 1, figsize=(8.6, 6.6), sharex=True)
    several = len(fields_of) > 1
    for (who, fields), color in zip(fields_of.items(), style.COLORS):
        x, on_line = fields.line(plane, place)
        options = dict(color=color, linewidth=1.4)
        mark = dict(marker="o", markersize=3) if fields is next(iter(fields_of.values())) else {}
        label = who or "pressure"
        axes[0].plot(x, on_line("pressure"), label=label, **options, **mark)
        axes[1].plot(x, on_line("shear"), label=f"magnitude, {who}" if several else "magnitude",
                     **options, **mark)
        if run.friction is not None:
            axes[1].plot(x, run.friction * on_line("pressure"), color=color, linewidth=1.0, linestyle="--",
                         label=f"bound, {who}" if several else f"bound $\\mu p$, $\\mu$ = {run.friction:g}")
        if not several:
            axes[1].plot(x, on_line("shear_along"), color=style.ORANGE, linewidth=1.2,
                         label="component along the track")
            axes[1].plot(x, on_line("shear_lateral"), color=style.GREEN, linewidth=1.2,
                         label="lateral component")
    axes[0].set_ylabel("pressure [MPa]")
    axes[0].set_ylim(0, None)
    axes[1].set_ylabel("traction on the rail [MPa]")
    for part in axes:
        part.grid(True)
        part.axhline(0, color=style.GREY, linewidth=0.7)
        style.legend_beside(part)
    if not several:
        axes[0].get_legend().remove()
    axes[1].set_xlabel(LABELS[plane])
    if plane == "BB":
        axes[0].invert_xaxis()  # shared; s to the left, as in the maps
    caption = title_of(plane, place)
    axes[0].set_title(caption)
    return caption + ": pressure, shear traction, traction bound", style.save(run, figure, name)
