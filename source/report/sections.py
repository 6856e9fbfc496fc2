"""Rail head and wheel of a result, and where on the head its patch lies: read from sections.json.

Points are in the track plane in mm: X to the track centre from the running circle, Y up from the top of the rail. s is
the lateral coordinate of all maps, along the common tangent at the rigid contact point. Pictures show the gauge side
(G.C., track centre) on the left, as the maps do.
"""

import json
import os

import numpy as np

import style


class Sections:
    """Outlines of rail head and wheel tread, and the frame of s."""

    def __init__(self, content):
        def points(line):
            return 1e3 * np.column_stack([line["x_m"], line["y_m"]])
        self.rail_name, self.wheel_name = content["rail_name"], content["wheel_name"]
        self.rail, self.wheel = points(content["rail"]), points(content["wheel"])
        contact, axis, face = content["contact"], content["rail_axis"], content["gauge_face"]
        self.contact = 1e3 * np.array([contact["x_m"], contact["y_m"]])
        angle = contact["angle_rad"]
        self.tangent, self.normal = np.array([np.cos(angle), np.sin(angle)]), np.array([-np.sin(angle), np.cos(angle)])
        self.axis, self.axis_angle = 1e3 * np.array([axis["x_m"], axis["y_m"]]), axis["angle_rad"]
        self.face = 1e3 * np.array([face["x_m"], face["y_m"]])

    def surface(self):
        """s and height of the rail along its outline, the part around the contact point on which s grows."""
        away = self.rail - self.contact
        s, height = away @ self.tangent, away @ self.normal
        start = int(np.argmin(np.hypot(*away.T)))
        first, last = start, start
        while first > 0 and s[first - 1] < s[first]:
            first -= 1
        while last + 1 < len(s) and s[last + 1] > s[last]:
            last += 1
        return s[first:last + 1], height[first:last + 1]

    def on_rail(self, s):
        """Points of the rail's surface at s [mm]."""
        s = np.atleast_1d(np.asarray(s, dtype=float))
        along, height = self.surface()
        return self.contact + np.outer(s, self.tangent) + np.outer(np.interp(s, along, height), self.normal)

    def at_x(self, x):
        """Points of the rail's surface at places X, for points of the head that see the sky."""
        head = self.rail[np.argsort(self.rail[:, 0], kind="stable")]
        return np.column_stack([x, np.interp(x, *head.T)])

    def place(self, point):
        """Distance from the rail's axis (to the gauge side), from the gauge face (to the field side), depth below the
        top of the rail [mm]."""
        x, y = point[0] - self.axis[0], point[1] - self.axis[1]
        return np.cos(self.axis_angle) * x + np.sin(self.axis_angle) * y, self.face[0] - point[0], -point[1]

    def words(self, point):
        return in_words(*self.place(point))


def in_words(axis, face, below):
    """A place on the head as a sentence part; all in mm."""
    side = "field" if axis < 0 else "gauge"
    return (f"{abs(axis):.1f} mm to the {side} side of the rail's axis, {face:.1f} mm from the gauge face, "
            f"{abs(below):.1f} mm {'above' if below < -0.05 else 'below'} the top of the rail")


def load(folder, name="sections.json"):
    """None where the folder has no such file, as those of earlier versions."""
    path = os.path.join(folder, name)
    if not os.path.exists(path):
        return None
    with open(path, encoding="utf-8") as file:
        return Sections(json.load(file))


def outward(points):
    """Unit normals of a line that runs to the track centre, out of the rail."""
    along = np.gradient(points, axis=0)
    return np.column_stack([-along[:, 1], along[:, 0]]) / np.maximum(np.hypot(*along.T), 1e-12)[:, None]


def draw_head(axes, sections, with_wheel=True):
    """The rail's head, its axis and the gauge face, the gauge side on the left; the wheel above."""
    x, y = sections.rail.T
    axes.fill(x, y, color="#e9edf2", zorder=0)
    axes.plot(x, y, color=style.GREY, linewidth=1.2, zorder=1)
    if with_wheel:
        axes.plot(*sections.wheel.T, color=style.GREY, linewidth=0.9, linestyle=(0, (6, 3)), zorder=1)
    axes.plot(*sections.face, "|", color=style.GREY, markersize=10)
    axes.annotate("gauge face", sections.face, (-6, 0), textcoords="offset points", ha="right", va="center", fontsize=8,
                  color=style.GREY)
    down = np.array([np.sin(sections.axis_angle), -np.cos(sections.axis_angle)])
    ends = np.array([sections.axis - 6 * down, sections.axis + 30 * down])
    axes.plot(*ends.T, color=style.GREY, linewidth=0.7, linestyle=(0, (8, 3, 2, 3)))
    middle, low = sections.axis[0], y.min()
    axes.set_xlim(max(x.max(), middle + 36) + 14, min(x.min(), middle - 36) - 6)  # the track centre is on the left
    axes.set_ylim(max(low, -36), 14)
    axes.set_aspect("equal")
    axes.set_yticks([])
    axes.set_xlabel("X from the running circle [mm]")
    style.sides(axes, "gauge side", "field side")


def draw_patch(axes, sections, span, color=style.RED, label=None):
    """The patch between two places s, drawn on the head, with a mark in its middle."""
    points = sections.on_rail(np.linspace(*sorted(span), 40))
    axes.plot(*points.T, color=color, linewidth=4, solid_capstyle="butt", label=label, zorder=3)
    middle = sections.on_rail(0.5 * sum(span))[0]
    axes.plot(*middle, "v", color=color, markersize=6, zorder=4)
    return middle


def patch_span(fields):
    """First and last place s of the patch [mm]: those of the results, or else of the edge line that is drawn."""
    import views

    if fields.span is not None:
        return fields.span
    s = [value for value in views.edge_lines(fields)[0] if value is not None]
    return (min(s), max(s)) if s else (fields.lateral[fields.loaded].min(), fields.lateral[fields.loaded].max())
