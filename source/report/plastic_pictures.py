"""Pictures of what plastic flow leaves in the rail: the running band from above and the plane AA below it.

Both come from the VTU files of the unloaded bodies and need Python's vtk; without it they are left out.
"""

import os

import matplotlib.pyplot as plt
import numpy as np

import style

RESIDUAL, STRAIN = "residual_von_mises_stress", "plastic_strain"
DEPTH = 8    # of the section [mm]: steel of 280 MPa yields down to 6.5 mm (doc/manual/material.md)
BEFORE = 10  # of the part that has flowed [mm]: the rail that nothing has rolled over, for comparison


class Triangles:
    """Triangles of the rail in a VTU file with the fields at their corners; places in mm. Of the rail's length what has
    flowed is kept, with a little before and ahead."""

    def __init__(self, places, corners, fields):
        self.x, self.y, self.z = (1e3 * places[:, i] for i in range(3))
        self.residual, self.strain = 1e-6 * fields[RESIDUAL], 1e3 * fields[STRAIN]
        flowed = self.z[np.unique(corners[(self.strain[corners] > 0).any(axis=1)])]
        self.along = None  # what pictures show of the rail's length
        if len(flowed) > 0:
            z = self.z[corners]
            self.along = max(z.min(), flowed.min() - BEFORE), min(z.max(), flowed.max() + BEFORE)
            corners = corners[(z.max(axis=1) > self.along[0]) & (z.min(axis=1) < self.along[1])]
        self.corners = corners if len(flowed) > 0 else corners[:0]


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
    rail = vtk_to_numpy(data.GetCellData().GetArray("body")) == 0
    corners = vtk_to_numpy(data.GetPolys().GetData()).reshape(-1, 4)[rail, 1:]
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


PANELS = (("residual", "residual von Mises stress [MPa]", style.HIGH),
          ("strain", "plastic strain [10$^{-3}$]", "magma_r"))


def draw_above(run, band):
    """The running band, rolling direction up, gauge corner on the left as in the maps of the patch."""
    length, width = np.ptp(band.along), np.ptp(band.x[band.corners])
    figure, rows = plt.subplots(1, 2, figsize=(11, 1.6 + 3.6 * min(max(length / width, 0.4), 2.2)),
                                gridspec_kw={"wspace": 0.5})
    for axes, (name, label, colors) in zip(rows, PANELS):
        panel(axes, band.x, band.z, band, getattr(band, name), label, colors)
        axes.set_xlim(band.x[band.corners].max(), band.x[band.corners].min())  # X to the left
        axes.set_ylim(*band.along)
        axes.set_xlabel("lateral X [mm]")
        axes.set_ylabel("along the rail [mm]")
        style.sides(axes)
        style.rolling_arrow(axes)
    return style.save(run, figure, "residual_above")


def draw_section(run, section):
    """The plane along the rail below the band, rolling direction to the right."""
    length, top = np.ptp(section.along), section.y[section.corners].max()
    figure, rows = plt.subplots(2, 1, figsize=(9.5, 1.2 + min(4 * DEPTH * 9.5 / length, 8)), sharex=True,
                                gridspec_kw={"hspace": 0.3})
    for axes, (name, label, colors) in zip(rows, PANELS):
        panel(axes, section.z, section.y, section, getattr(section, name), label.replace(" stress", "\nstress"), colors, 2)
        axes.set_xlim(*section.along)
        axes.set_ylim(top - DEPTH, top)
        axes.set_ylabel("height Y [mm]\n(twice as large)")
    rows[1].set_xlabel("along the rail [mm]   (rolling direction to the right)")
    return style.save(run, figure, "residual_section")


def draw_all(run):
    """Both pictures of a run that has yielded, a list of (caption, path)."""
    if not ((run.summary or {}).get("max_plastic_strain") or 0) > 0:
        return []
    surface, volume = run.data.path("residual_surface.vtu"), run.data.path("volume_end.vtu")
    try:
        band = read(surface) if os.path.exists(surface) else None
    except ImportError:
        run.remarks.append("Python's vtk is not installed (package python3-vtk9); the pictures of residual stress are "
                           "left out.")
        return []
    if band is None or len(band.corners) == 0:
        run.remarks.append("There is no residual_surface.vtu, which a run writes at its end; the pictures of residual "
                           "stress are left out.")
        return []
    pictures = [("Running band from above: residual stress, the loads taken off, and plastic strain",
                 draw_above(run, band))]
    nodes = np.unique(band.corners)
    middle = band.x[nodes[np.argmax(band.strain[nodes])]]
    section = read(volume, 1e-3 * middle) if os.path.exists(volume) else None
    if section is None:
        run.remarks.append("There is no volume_end.vtu; the section of residual stress is left out.")
        return pictures
    if len(section.corners) == 0:
        return pictures
    height = section.y[section.corners].max(axis=1)
    section.corners = section.corners[height > height.max() - DEPTH]  # coarse cells reach farther down
    pictures.append((f"Plane AA below the plastic zone at X = {middle:.1f} mm, upper {DEPTH} mm of the rail",
                     draw_section(run, section)))
    return pictures
