"""Maps of a patch on one pair of axes: pressure, shear traction with arrows, stick and slip.

The functions draw into given axes and take the top of the scale, so that two patches can be set side by
side. For the sides of the rail and the rolling direction see patch_pictures.
"""

import matplotlib.pyplot as plt
import numpy as np
from matplotlib.colors import ListedColormap
from matplotlib.patches import Patch

import patch_pictures
import run_data
import style


class Scale:
    """Common limits of maps that are compared: extents in mm, tops of pressure and shear in MPa."""

    def __init__(self, *fields):
        inside = [(f.lateral[f.loaded], f.along[f.loaded]) for f in fields]
        self.lateral = (min(s.min() for s, _ in inside) - 1.5, max(s.max() for s, _ in inside) + 1.5)
        self.along = (min(x.min() for _, x in inside) - 1.5, max(x.max() for _, x in inside) + 1.5)
        self.pressure = max(f.pressure.max() for f in fields)
        self.shear = max(max(f.shear.max() for f in fields), 1e-9)


def dress(axes, fields, scale, title):
    patch_pictures.dress(axes, fields, title)
    axes.set_xlim(scale.lateral[1], scale.lateral[0])
    axes.set_ylim(*scale.along)


def pressure(axes, fields, scale, title):
    values = np.where(fields.loaded, fields.pressure, np.nan)
    image = axes.pcolormesh(fields.lateral, fields.along, values, shading="nearest", cmap="viridis", vmin=0,
                            vmax=scale.pressure)
    patch_pictures.draw_edge(axes, fields)
    peak = np.unravel_index(np.argmax(fields.pressure), fields.pressure.shape)
    axes.plot(fields.lateral[peak], fields.along[peak], "+", color=style.RED, markersize=11, markeredgewidth=1.8)
    dress(axes, fields, scale, f"{title}, peak {fields.pressure.max():.0f} MPa")
    return image


def shear(axes, fields, scale, title):
    values = np.where(fields.loaded, fields.shear, np.nan)
    image = axes.pcolormesh(fields.lateral, fields.along, values, shading="nearest", cmap="YlOrRd", vmin=0,
                            vmax=scale.shear)
    patch_pictures.draw_edge(axes, fields)
    spacing = abs(fields.along[1, 0] - fields.along[0, 0])
    step = max(1, round(1.0 / spacing))
    pick = np.zeros_like(fields.loaded)
    pick[::step, ::step] = True
    pick &= fields.loaded & (fields.shear > patch_pictures.FAINT * scale.shear)
    axes.quiver(fields.lateral[pick], fields.along[pick], fields.shear_lateral[pick], fields.shear_along[pick],
                angles="xy", scale_units="xy", scale=scale.shear / (1.6 * step * spacing), width=0.0035, color="#1a1a1a")
    dress(axes, fields, scale, f"{title}, nodes up to {fields.shear.max():.0f} MPa")
    return image


def states(axes, fields, scale, title):
    axes.pcolormesh(fields.lateral, fields.along, np.where(fields.loaded, fields.state, 0), shading="nearest",
                    cmap=ListedColormap(["#f4f4f4", style.BLUE, style.RED]), vmin=-0.5, vmax=2.5)
    patch_pictures.draw_edge(axes, fields)
    share = 100 * np.sum((fields.state == 1) & fields.loaded) / np.sum(fields.loaded)
    dress(axes, fields, scale, f"{title}, {share:.0f} % stick")
    axes.legend(handles=[Patch(color=style.BLUE, label="stick"), Patch(color=style.RED, label="slip")],
                loc="lower left", bbox_to_anchor=(1.02, 0), borderaxespad=0)


def draw_sheet(run):
    """The three maps of one patch side by side; returns the path."""
    if run.patch is None or not run.patch["pressure"].max() > 0:
        raise run_data.ReportError(f"There is no loaded contact patch in {run.folder}.")
    fields = patch_pictures.Fields(run.patch, margin=4)
    scale = Scale(fields)
    figure, axes = plt.subplots(1, 3, figsize=(20, 5.2), gridspec_kw={"wspace": 0.38})
    patch_pictures.color_bar(figure, axes[0], pressure(axes[0], fields, scale, "Pressure"), "pressure [MPa]")
    patch_pictures.color_bar(figure, axes[1], shear(axes[1], fields, scale, "Shear traction on the rail"),
                             "shear traction [MPa]")
    states(axes[2], fields, scale, "Stick and slip")
    return style.save(run, figure, "sheet")
