#!/usr/bin/python3
"""Draws wheel and rail of VTU files in three dimensions with VTK: body_scene.py FOLDER FILE.vtu TITLE...

Writes FOLDER/bodies.png (both bodies of the last file, from the track centre and behind), FOLDER/bodies_cut.png (cut across
the track through the contact, seen in the rolling direction, which has the gauge corner of the right-hand rail on the left)
and FOLDER/mesh_places.png (the meshes of all files, up to three, under their titles: cut across and along the track).
"""

import os
import sys

import numpy as np
from vtkmodules.util.numpy_support import numpy_to_vtk, vtk_to_numpy
from vtkmodules.vtkCommonCore import vtkLookupTable
from vtkmodules.vtkCommonDataModel import vtkPlane
from vtkmodules.vtkFiltersCore import vtkClipPolyData, vtkCutter
from vtkmodules.vtkFiltersExtraction import vtkExtractGeometry
from vtkmodules.vtkFiltersGeometry import vtkGeometryFilter
from vtkmodules.vtkIOImage import vtkPNGWriter
from vtkmodules.vtkIOXML import vtkXMLUnstructuredGridReader
from vtkmodules.vtkRenderingAnnotation import vtkAxesActor, vtkScalarBarActor
from vtkmodules.vtkRenderingCore import (vtkActor, vtkPolyDataMapper, vtkRenderer, vtkRenderWindow, vtkTextActor,
                                         vtkWindowToImageFilter)
import vtkmodules.vtkRenderingFreeType  # noqa: F401  (texts)
import vtkmodules.vtkRenderingOpenGL2  # noqa: F401  (the renderer)

import matplotlib

FIELD = "von_mises_stress"


def read(path):
    reader = vtkXMLUnstructuredGridReader()
    reader.SetFileName(path)
    reader.Update()
    grid = reader.GetOutput()
    stress = numpy_to_vtk(1e-6 * vtk_to_numpy(grid.GetPointData().GetArray(FIELD)).astype(np.float64), deep=True)
    stress.SetName("stress")
    grid.GetPointData().SetScalars(stress)
    return grid


def contact_of(grid):
    """The place of the largest stress: the contact."""
    stress = vtk_to_numpy(grid.GetPointData().GetScalars())
    return np.array(grid.GetPoint(int(np.argmax(stress)))), stress.max()


def colors(top):
    table = vtkLookupTable()
    table.SetRange(0, top)
    table.SetNumberOfTableValues(16)
    table.Build()
    table.SetTableValue(0, 0.80, 0.82, 0.84)  # unloaded steel
    for k in range(1, 16):
        table.SetTableValue(k, *matplotlib.colormaps["YlOrRd"](k / 16))
    return table


def actor_of(poly, table, edge_width):
    mapper = vtkPolyDataMapper()
    mapper.SetInputData(poly)
    mapper.SetLookupTable(table)
    mapper.SetScalarRange(table.GetRange())
    actor = vtkActor()
    actor.SetMapper(mapper)
    shown = actor.GetProperty()
    shown.SetEdgeVisibility(edge_width > 0)
    shown.SetEdgeColor(0.15, 0.15, 0.15)
    shown.SetLineWidth(max(edge_width, 0.1))
    shown.SetAmbient(0.35)
    shown.SetDiffuse(0.65)
    return actor


def skin(grid):
    faces = vtkGeometryFilter()
    faces.SetInputData(grid)
    faces.Update()
    return faces.GetOutput()


def behind(grid, place, axis):
    """Whole cells at `place` and beyond along the axis (0 lateral, 2 along), so that the cut shows faces of the mesh."""
    plane = vtkPlane()
    plane.SetOrigin(*place)
    plane.SetNormal(*[-float(k == axis) for k in range(3)])
    part = vtkExtractGeometry()
    part.SetInputData(grid)
    part.SetImplicitFunction(plane)
    part.ExtractInsideOn()
    part.Update()
    return part.GetOutput()


def text(words, x, y, size=20, bold=False):
    actor = vtkTextActor()
    actor.SetInput(words)
    shown = actor.GetTextProperty()
    shown.SetFontSize(size)
    shown.SetColor(0.2, 0.2, 0.2)
    shown.SetBold(bold)
    actor.SetPosition(x, y)
    return actor


def bar(table):
    actor = vtkScalarBarActor()
    actor.SetLookupTable(table)
    actor.SetTitle("von Mises [MPa]")
    actor.SetVerticalTitleSeparation(12)
    actor.SetNumberOfLabels(5)
    actor.SetLabelFormat("%.0f")
    actor.UnconstrainedFontSizeOn()
    for shown, size in ((actor.GetTitleTextProperty(), 20), (actor.GetLabelTextProperty(), 18)):
        shown.SetColor(0.1, 0.1, 0.1)
        shown.SetFontSize(size)
        shown.SetItalic(False)
        shown.SetShadow(False)
        shown.SetBold(False)
    actor.SetPosition(0.86, 0.2)
    actor.SetWidth(0.12)
    actor.SetHeight(0.6)
    return actor


def write(path, renderers, size):
    """One picture of all renderers, on white."""
    window = vtkRenderWindow()
    window.SetOffScreenRendering(1)
    window.SetMultiSamples(4)
    window.SetSize(*size)
    for renderer in renderers:
        renderer.SetBackground(1, 1, 1)
        window.AddRenderer(renderer)
    window.Render()
    image = vtkWindowToImageFilter()
    image.SetInput(window)
    image.ReadFrontBufferOff()
    writer = vtkPNGWriter()
    writer.SetInputConnection(image.GetOutputPort())
    writer.SetFileName(path)
    writer.Write()


def scene_of(actor, viewport, camera):
    scene = vtkRenderer()
    scene.SetViewport(*viewport)
    scene.AddActor(actor)
    camera(scene.GetActiveCamera())
    scene.ResetCameraClippingRange()
    return scene


def draw(path, actor, table, words, camera):
    """One picture: the bodies on the left, scale and words on white around them."""
    around = vtkRenderer()
    around.AddViewProp(bar(table))
    for word in words:
        around.AddViewProp(word)
    write(path, (around, scene_of(actor, (0, 0.06, 0.85, 0.94), camera)), (1200, 850))


def onto_cut(middle, axis, height):
    """A camera that looks along the axis onto a cut, over a stretch of this height [m]."""
    def set_up(camera):
        camera.SetFocalPoint(*middle)
        camera.SetPosition(*(middle - np.eye(3)[axis]))
        camera.SetViewUp(0, 1, 0)
        camera.ParallelProjectionOn()
        camera.SetParallelScale(0.5 * height)
    return set_up


def draw_places(path, grids, titles):
    """A column for each file: cut across the track (44 mm high) and along it (100 mm)."""
    width, scenes, around = 1 / len(grids), [], vtkRenderer()
    top = max(contact_of(grid)[1] for grid in grids)
    table = colors(max(np.ceil(top / 100) * 100, 100))
    columns = 420
    for number, (grid, title) in enumerate(zip(grids, titles)):
        place = contact_of(grid)[0]
        left = number * width + 0.005
        for axis, height, low, high in ((2, 0.044, 0.50, 0.93), (0, 0.1, 0.04, 0.47)):
            actor = actor_of(skin(behind(grid, place, axis)), table, 1.0)
            scenes.append(scene_of(actor, (left, low, left + width - 0.01, high), onto_cut(place, axis, height)))
        around.AddViewProp(text(title, columns * number + 10, 790, 20, True))
        around.AddViewProp(text("across the track, 44 mm high", columns * number + 10, 391, 15))
        around.AddViewProp(text("along the track, 100 mm high, rolling to the right", columns * number + 10, 10, 15))
    write(path, (around, *scenes), (columns * len(grids), 825))


def main(arguments):
    if len(arguments) < 3 or len(arguments) % 2 == 0:
        print(__doc__, file=sys.stderr)
        return 1
    folder, files, titles = arguments[0], arguments[1::2], arguments[2::2]
    grids = [read(file) for file in files]
    grid = grids[-1]
    place, largest = contact_of(grid)
    table = colors(max(np.ceil(largest / 100) * 100, 100))
    bounds = grid.GetBounds()
    height = bounds[3] - bounds[2]

    def from_afar(camera):
        middle = np.array([0.5 * (bounds[0] + bounds[1]), bounds[2] + 0.40 * height, place[2]])
        camera.SetFocalPoint(*middle)
        camera.SetPosition(*(middle + 2.5 * height * np.array([0.75, 0.42, -0.85])))
        camera.SetViewUp(0, 1, 0)
        camera.SetViewAngle(26)

    draw(os.path.join(folder, "bodies.png"), actor_of(skin(grid), table, 0.6), table,
         [text("seen from the track centre and from behind, rolling direction away from the eye", 20, 14)], from_afar)
    draw(os.path.join(folder, "bodies_cut.png"), actor_of(skin(behind(grid, place, 2)), table, 1.0), table,
         [text("G.C.", 20, 810, 24, True), text("F.S.", 960, 810, 24, True),
          text("seen in the rolling direction; the picture is 44 mm high", 20, 14)],
         onto_cut(place - np.array([0.006, 0, 0]), 2, 0.044))
    draw_places(os.path.join(folder, "mesh_places.png"), grids, titles)
    return 0


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))
