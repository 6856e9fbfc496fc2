"""Pictures of what plastic flow leaves in the rail: the running band from above and the plane AA below it.

Both come from the last VTU files and need Python's vtk; without it they are left out.
"""

import glob
import os

import matplotlib.pyplot as plt
import numpy as np

import style

RESIDUAL, STRAIN = "residual_von_mises_stress", "plastic_strain"
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


def panel(axes, across, along, triangles, values, label, color_map):
    image = axes.tripcolor(along, across, triangles.corners, values, shading="gouraud", cmap=color_map, vmin=0)
    axes.set_aspect("equal")
    axes.set_xlim(max(along[triangles.corners].min(), triangles.begin), along[triangles.corners].max())
    axes.set_ylim(across[triangles.corners].min(), across[triangles.corners].max())
    axes.figure.colorbar(image, ax=axes, label=label, shrink=0.8)


def draw(run, name, triangles, across, across_label):
    figure, axes = plt.subplots(2, 1, figsize=(7.5, 6), sharex=True)
    panel(axes[0], across, triangles.z, triangles, triangles.residual, "residual von Mises [MPa]", "viridis")
    panel(axes[1], across, triangles.z, triangles, triangles.strain, "plastic strain [$10^{-3}$]", "magma_r")
    for one in axes:
        one.set_ylabel(across_label)
    axes[1].set_xlabel("along the rail, rolling direction to the right [mm]")
    return style.save(run, figure, name)


def draw_all(run):
    """Both pictures of a run that has yielded, a list of (caption, path)."""
    if not ((run.summary or {}).get("max_plastic_strain") or 0) > 0:
        return []
    surfaces = sorted(glob.glob(os.path.join(run.folder, "surface_*.vtu")))
    volume = os.path.join(run.folder, "volume_end.vtu")
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
    pictures = [("Running band from above, unloaded behind the wheel: residual stress and plastic strain",
                 draw(run, "residual_above", band, band.x, "lateral X [mm], gauge corner up"))]
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
                     draw(run, "residual_section", section, section.y, "height Y [mm]")))
    return pictures
