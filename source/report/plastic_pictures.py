"""Pictures of what plastic flow leaves in the rail: the running band from above and the plane AA below it.

Both come from the last VTU files and need Python's vtk; without it they are left out.
"""

import glob
import os

import matplotlib.pyplot as plt
import numpy as np

import style

RESIDUAL, STRAIN = "von_mises_stress_behind_wheel", "plastic_strain"
DEPTH = 8    # of the section [mm]: steel of 280 MPa yields down to 6.5 mm (doc/theory/material.md)
BEFORE = 10  # of the part that has flowed [mm]: the rail that nothing has rolled over, for comparison


class Triangles:
    """Triangles of a VTU file with the fields at their corners; places in mm."""

    def __init__(self, places, corners, fields):
        self.x, self.y, self.z = (1e3 * places[:, i] for i in range(3))
        known = np.isfinite(fields[RESIDUAL][corners]).all(axis=1)
        self.corners = corners[known]
        self.begin = -np.inf  # pictures begin here along the rail
        self.residual, self.strain = 1e-6 * fields[RESIDUAL], 1e3 * fields[STRAIN]


def read(path, cut_at=None):
    """Triangles of the faces of a file, or of the cut of its cells by the plane x = cut_at [m]."""
    from vtkmodules.util.numpy_support import vtk_to_numpy
    from vtkmodules.vtkCommonDataModel import vtkPlane
    from vtkmodules.vtkFiltersCore import vtkCutter, vtkTriangleFilter
    from vtkmodules.vtkFiltersGeometry import vtkGeometryFilter
    from vtkmodules.vtkIOXML import vtkXMLUnstructuredGridReader

    reader = vtkXMLUnstructuredGridReader()
    reader.SetFileName(path)
    if cut_at is None:
        faces = vtkGeometryFilter()
    else:
        plane = vtkPlane()
        plane.SetOrigin(cut_at, 0, 0)
        plane.SetNormal(1, 0, 0)
        faces = vtkCutter()
        faces.SetCutFunction(plane)
    faces.SetInputConnection(reader.GetOutputPort())
    triangles = vtkTriangleFilter()
    triangles.SetInputConnection(faces.GetOutputPort())
    triangles.Update()
    data = triangles.GetOutput()
    if data.GetNumberOfPolys() == 0 or not data.GetPointData().HasArray(RESIDUAL):
        return None
    corners = vtk_to_numpy(data.GetPolys().GetData()).reshape(-1, 4)[:, 1:]
    fields = {name: vtk_to_numpy(data.GetPointData().GetArray(name)) for name in (RESIDUAL, STRAIN)}
    return Triangles(vtk_to_numpy(data.GetPoints().GetData()), corners, fields)


def panel(axes, horizontal, vertical, triangles, values, label, color_map, stretch=1):
    """One field with its bar; `stretch` draws heights that many times as large as lengths."""
    top = style.round_top(values[np.unique(triangles.corners)].max())
    image = axes.tripcolor(horizontal, vertical, triangles.corners, values, shading="gouraud", cmap=color_map, vmin=0,
                           vmax=top)
    axes.set_aspect(stretch)
    bar = style.color_bar(axes.figure, axes, image, label, 0.05 if stretch == 1 else 0.025)
    bar.set_ticks([tick for tick in style.round_levels(0, top, 8 if stretch == 1 else 4) if tick <= top])


PANELS = (("residual", "von Mises stress behind the wheel [MPa]", "viridis"),
          ("strain", "plastic strain [10$^{-3}$]", "magma_r"))


def draw_above(run, band):
    """The running band, rolling direction up, gauge corner on the left as in the maps of the patch."""
    length, width = np.ptp(band.z[band.corners]), np.ptp(band.x[band.corners])
    figure, rows = plt.subplots(1, 2, figsize=(11, 1.6 + 3.6 * min(max(length / width, 0.4), 2.2)),
                                gridspec_kw={"wspace": 0.5})
    for axes, (name, label, colors) in zip(rows, PANELS):
        panel(axes, band.x, band.z, band, getattr(band, name), label, colors)
        axes.set_xlim(band.x[band.corners].max(), band.x[band.corners].min())  # X to the left
        axes.set_ylim(band.z[band.corners].min(), band.z[band.corners].max())
        axes.set_xlabel("lateral X [mm]")
        axes.set_ylabel("along the rail [mm]")
        style.sides(axes)
        style.rolling_arrow(axes)
    return style.save(run, figure, "residual_above")


def draw_section(run, section):
    """The plane along the rail below the band, rolling direction to the right."""
    length = np.ptp(section.z[section.corners]) - max(section.begin - section.z[section.corners].min(), 0)
    figure, rows = plt.subplots(2, 1, figsize=(9.5, 1.2 + min(4 * DEPTH * 9.5 / length, 8)), sharex=True,
                                gridspec_kw={"hspace": 0.3})
    for axes, (name, label, colors) in zip(rows, PANELS):
        panel(axes, section.z, section.y, section, getattr(section, name), label.replace(" behind", "\nbehind"), colors, 2)
        axes.set_xlim(max(section.z[section.corners].min(), section.begin), section.z[section.corners].max())
        axes.set_ylim(section.y[section.corners].min(), section.y[section.corners].max())
        axes.set_ylabel("height Y [mm]\n(twice as large)")
    rows[1].set_xlabel("along the rail [mm]   (rolling direction to the right)")
    return style.save(run, figure, "residual_section")


def draw_all(run):
    """Both pictures of a run that has yielded, a list of (caption, path)."""
    if not ((run.summary or {}).get("max_plastic_strain") or 0) > 0:
        return []
    surfaces = sorted(glob.glob(os.path.join(run.folder, "surface_*.vtu")))
    volume = run.data.path("volume_end.vtu")
    try:
        band = read(surfaces[-1]) if surfaces else None
    except ImportError:
        run.remarks.append("Python's vtk is not installed (package python3-vtk9); the pictures of residual stress are "
                           "left out.")
        return []
    if band is None or len(band.corners) == 0:
        run.remarks.append("No part of the rail lies unloaded behind the wheel; the pictures of residual stress are "
                           "left out. Roll farther.")
        return []
    pictures = [("Running band from above, behind the wheel: stress that is left and plastic strain",
                 draw_above(run, band))]
    nodes = np.unique(band.corners)
    middle = band.x[nodes[np.argmax(band.strain[nodes])]]
    section = read(volume, 1e-3 * middle) if os.path.exists(volume) else None
    if section is None:
        run.remarks.append("There is no volume_end.vtu; the section of residual stress is left out.")
        return pictures
    flowed = section.z[np.unique(section.corners[(section.strain[section.corners] > 0).any(axis=1)])]
    if len(flowed) == 0:
        return pictures
    upper = section.y[section.corners].mean(axis=1) > section.y[section.corners].max() - DEPTH
    section.begin = flowed.min() - BEFORE
    near = section.z[section.corners].max(axis=1) > section.begin
    section.corners = section.corners[upper & near]
    pictures.append((f"Plane AA below the band at X = {middle:.1f} mm, upper {DEPTH} mm of the rail",
                     draw_section(run, section)))
    return pictures
