#!/usr/bin/python3
"""Draws wheel and rail of a VTU file in three dimensions with VTK: body_scene.py FILE.vtu FOLDER

Writes FOLDER/bodies.png (both bodies, from the track centre and behind) and FOLDER/bodies_cut.png (cut across the track
through the contact, seen in the rolling direction, which has the gauge corner of the right-hand rail on
the left).
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


def behind(grid, z):
    """Whole cells at z and beyond, so that the cut shows faces of the mesh."""
    plane = vtkPlane()
    plane.SetOrigin(0, 0, z)
    plane.SetNormal(0, 0, -1)
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


def draw(path, actors, table, words, camera):
    """One picture: the bodies on the left, scale and words on white around them."""
    scene, around = vtkRenderer(), vtkRenderer()
    scene.SetViewport(0, 0.06, 0.85, 0.94)
    for actor in actors:
        scene.AddActor(actor)
    around.AddViewProp(bar(table))
    for actor in words:
        around.AddViewProp(actor)
    window = vtkRenderWindow()
    window.SetOffScreenRendering(1)
    window.SetMultiSamples(4)
    window.SetSize(1200, 850)
    for renderer in (around, scene):
        renderer.SetBackground(1, 1, 1)
        window.AddRenderer(renderer)
    camera(scene.GetActiveCamera())
    scene.ResetCameraClippingRange()
    window.Render()
    image = vtkWindowToImageFilter()
    image.SetInput(window)
    image.ReadFrontBufferOff()
    writer = vtkPNGWriter()
    writer.SetInputConnection(image.GetOutputPort())
    writer.SetFileName(path)
    writer.Write()


def main(arguments):
    if len(arguments) != 2:
        print(__doc__, file=sys.stderr)
        return 1
    grid = read(arguments[0])
    place, largest = contact_of(grid)
    top = max(np.ceil(largest / 100) * 100, 100)
    table = colors(top)
    bounds = grid.GetBounds()
    height = bounds[3] - bounds[2]

    def from_afar(camera):
        middle = np.array([0.5 * (bounds[0] + bounds[1]), bounds[2] + 0.40 * height, place[2]])
        camera.SetFocalPoint(*middle)
        camera.SetPosition(*(middle + 2.5 * height * np.array([0.75, 0.42, -0.85])))
        camera.SetViewUp(0, 1, 0)
        camera.SetViewAngle(26)

    whole = [actor_of(skin(grid), table, 0.6)]
    draw(os.path.join(arguments[1], "bodies.png"), whole, table,
         [text("seen from the track centre and from behind, rolling direction away from the eye", 20, 14)], from_afar)

    def on_the_cut(camera):
        middle = np.array([place[0] - 0.006, place[1], place[2]])
        camera.SetFocalPoint(*middle)
        camera.SetPosition(*(middle - np.array([0, 0, 1.0])))
        camera.SetViewUp(0, 1, 0)
        camera.ParallelProjectionOn()
        camera.SetParallelScale(0.022)

    cut = [actor_of(skin(behind(grid, place[2])), table, 1.0)]
    draw(os.path.join(arguments[1], "bodies_cut.png"), cut, table,
         [text("G.C.", 20, 810, 24, True), text("F.S.", 960, 810, 24, True),
          text("seen in the rolling direction; the picture is 44 mm high", 20, 14)], on_the_cut)
    return 0


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))
