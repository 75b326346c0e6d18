# SPDX-License-Identifier: LGPL-2.1-or-later
"""Bodies as pictures, by VTK."""

import numpy as np
from colours import colour
from PIL import Image
from vtkmodules.util.numpy_support import (numpy_to_vtk, numpy_to_vtkIdTypeArray,
                                           vtk_to_numpy)
from vtkmodules.vtkCommonCore import vtkPoints
from vtkmodules.vtkCommonDataModel import vtkCellArray, vtkPolyData
from vtkmodules.vtkFiltersCore import vtkCleanPolyData, vtkFeatureEdges
from vtkmodules.vtkRenderingCore import (vtkActor, vtkMapper, vtkPolyDataMapper,
                                         vtkRenderer, vtkRenderWindow,
                                         vtkWindowToImageFilter)
import vtkmodules.vtkRenderingOpenGL2  # noqa: F401: what draws

SAMPLES = 4  # of a pixel, against jagged lines
BEHIND = 4  # units of depth by which faces are behind their edges
BLADE, DARK, GREY = (0.12, 0.31, 0.55), (0.15, 0.15, 0.15), (0.6, 0.6, 0.6)


class Painter:
    """A window that nobody sees, with a camera."""

    def __init__(self, camera, size, colours):
        self.camera, self.colours = camera, colours
        self.renderer = vtkRenderer()
        self.renderer.SetBackground(1, 1, 1)
        self.window = vtkRenderWindow()
        self.window.OffScreenRenderingOn()
        self.window.SetMultiSamples(SAMPLES)
        self.window.SetSize(*size)
        self.window.AddRenderer(self.renderer)
        vtkMapper.SetResolveCoincidentTopologyToPolygonOffset()
        camera.aim(self.renderer.GetActiveCamera())
        # A line's usual width, in units of the body.
        self.width = 2 * camera.half_height / size[1] * max(1, min(size) / 550)

    def paint(self, frame, outline, blade):
        """The picture of a frame."""
        self.renderer.RemoveAllViewProps()
        places = frame.surface
        body = polydata(places, frame.lattice.quadrilaterals())
        body.GetPointData().SetNormals(numpy_to_vtk(
            frame.lattice.normals(frame.places), deep=True))
        body.GetPointData().SetScalars(numpy_to_vtk(
            colour(frame.values(self.colours["field"]), self.colours), deep=True))
        actor = self.add(body, behind=BEHIND)
        actor.GetProperty().SetAmbient(0.74)
        actor.GetProperty().SetDiffuse(0.3)
        self.add_lines(places, frame.lattice.borders(), DARK, 1)
        self.add_lines(*outline, GREY, 0.9)
        for edge, back in blade:
            self.add_blade(edge, back).GetProperty().SetOpacity(0.25)
        if frame.blade:
            self.add_body_of_blade(frame.blade)
        self.renderer.ResetCameraClippingRange()
        return self.picture()

    def add(self, data, colour=None, behind=0):
        """Show polygons, a little behind those of the same place."""
        mapper = vtkPolyDataMapper()
        mapper.SetInputData(data)
        mapper.SetRelativeCoincidentTopologyPolygonOffsetParameters(behind, behind)
        actor = vtkActor()
        actor.SetMapper(mapper)
        if colour:
            mapper.ScalarVisibilityOff()
            actor.GetProperty().SetColor(colour)
            actor.GetProperty().LightingOff()
        self.renderer.AddActor(actor)
        return actor

    def add_lines(self, points, lines, colour, width):
        """Lines as ribbons towards the camera: lines of OpenGL have gaps."""
        half = width * self.width / 2
        start, end = (points[lines[:, part]].reshape(-1, 3)
                      for part in (slice(None, -1), slice(1, None)))
        along = end - start
        length = np.linalg.norm(along, axis=1, keepdims=True)
        along = half * along / np.where(length > 0, length, 1)
        aside = np.cross(along, self.camera.towards)
        length = np.linalg.norm(aside, axis=1, keepdims=True)
        aside = half * aside / np.where(length > 0, length, 1)
        corners = np.stack([start - along - aside, end + along - aside,
                            end + along + aside, start - along + aside], axis=1)
        i = np.arange(4 * len(start)).reshape(-1, 4)
        return self.add(polydata(corners.reshape(-1, 3), i), colour)

    def add_blade(self, edge, back):
        """The blade's sheet between its edge and its back; in 2D it is a line."""
        n = len(edge)
        i = np.arange(n - 1)
        points = np.vstack([edge, back])
        if n == 1:
            return self.add_lines(points, np.array([[0, 1]]), BLADE, 4)
        return self.add(polydata(points, np.stack(
            [i, i + 1, i + 1 + n, i + n], axis=1)), BLADE)

    def add_body_of_blade(self, sheet):
        """The blade's surface; in 2D its outline."""
        if sheet.polygons.shape[1] == 2:
            return self.add_lines(sheet.points, sheet.polygons, BLADE, 2)
        actor = self.add(polydata(sheet.points, sheet.polygons), BLADE)
        actor.GetProperty().SetOpacity(0.35)
        return actor

    def picture(self):
        self.window.Render()
        grab = vtkWindowToImageFilter()
        grab.SetInput(self.window)
        grab.ReadFrontBufferOff()
        grab.ShouldRerenderOff()
        grab.Update()
        image = grab.GetOutput()
        width, height, _ = image.GetDimensions()
        found = vtk_to_numpy(image.GetPointData().GetScalars())
        found = found.reshape(height, width, -1)[::-1, :, :3]
        return Image.fromarray(np.ascontiguousarray(found))


def polydata(places, polygons):
    data = vtkPolyData()
    points = vtkPoints()
    points.SetData(numpy_to_vtk(np.ascontiguousarray(places), deep=True))
    data.SetPoints(points)
    data.SetPolys(cell_array(polygons))
    return data


def cell_array(cells):
    found = vtkCellArray()
    found.SetData(cells.shape[1], numpy_to_vtkIdTypeArray(
        np.ascontiguousarray(cells.ravel(), np.int64), deep=True))
    return found


def outline_of(frame):
    """The edges of the body at rest: points and lines."""
    clean, edges = vtkCleanPolyData(), vtkFeatureEdges()
    clean.SetInputData(polydata(frame.lattice.values(frame.rest),
                                frame.lattice.quadrilaterals()))
    clean.SetTolerance(1e-6)
    edges.SetInputConnection(clean.GetOutputPort())
    edges.NonManifoldEdgesOff()
    edges.ColoringOff()
    edges.Update()
    found = edges.GetOutput()
    if not found.GetNumberOfLines():
        return np.zeros((1, 3)), np.zeros((0, 2), int)
    return (vtk_to_numpy(found.GetPoints().GetData()).astype(float),
            vtk_to_numpy(found.GetLines().GetConnectivityArray()).reshape(-1, 2))
