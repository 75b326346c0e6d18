"""Bodies as pictures, by VTK."""

import matplotlib
import numpy as np
from vtkmodules.util.numpy_support import (numpy_to_vtk, numpy_to_vtkIdTypeArray,
                                           vtk_to_numpy)
from vtkmodules.vtkCommonCore import vtkPoints
from vtkmodules.vtkCommonDataModel import vtkCellArray, vtkPolyData
from vtkmodules.vtkFiltersCore import vtkCleanPolyData, vtkFeatureEdges
from vtkmodules.vtkRenderingCore import (vtkActor, vtkMapper, vtkPolyDataMapper,
                                         vtkRenderer, vtkRenderWindow,
                                         vtkWindowToImageFilter)
import vtkmodules.vtkRenderingOpenGL2  # noqa: F401: what draws

SAMPLES = 8      # of a pixel, against jagged lines
BLADE = (0.12, 0.31, 0.55)


class Painter:
    """A window that nobody sees, with a camera."""

    def __init__(self, camera, size, colours):
        self.colours = colours
        self.renderer = vtkRenderer()
        self.renderer.SetBackground(1, 1, 1)
        self.window = vtkRenderWindow()
        self.window.OffScreenRenderingOn()
        self.window.SetMultiSamples(SAMPLES)
        self.window.SetSize(*size)
        self.window.AddRenderer(self.renderer)
        vtkMapper.SetResolveCoincidentTopologyToPolygonOffset()
        camera.aim(self.renderer.GetActiveCamera())
        self.line_width = max(1.0, min(size) / 500)

    def paint(self, frame, outline, blade):
        """The picture of a frame: height x width x 3 bytes."""
        self.renderer.RemoveAllViewProps()
        places = frame.surface
        body = polydata(places, polygons=frame.lattice.quadrilaterals())
        body.GetPointData().SetNormals(numpy_to_vtk(
            frame.lattice.normals(frame.places), deep=True))
        body.GetPointData().SetScalars(numpy_to_vtk(
            colour(frame.values(self.colours["field"]), self.colours), deep=True))
        actor = self.add(body)
        actor.GetProperty().SetAmbient(0.74)
        actor.GetProperty().SetDiffuse(0.3)
        self.add(polydata(places, lines=frame.lattice.borders()),
                 (0.15, 0.15, 0.15), 1.2)
        self.add(outline, (0.6, 0.6, 0.6), 1)
        for strip in blade:
            self.add(strip, BLADE, 3).GetProperty().SetOpacity(0.25)
        self.renderer.ResetCameraClippingRange()
        return self.picture()

    def add(self, data, colour=None, line_width=0):
        mapper = vtkPolyDataMapper()
        mapper.SetInputData(data)
        actor = vtkActor()
        actor.SetMapper(mapper)
        if colour:
            mapper.ScalarVisibilityOff()
            actor.GetProperty().SetColor(colour)
        if line_width:
            actor.GetProperty().SetLineWidth(line_width * self.line_width)
            actor.GetProperty().LightingOff()
        self.renderer.AddActor(actor)
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
        return found.reshape(height, width, -1)[::-1, :, :3]


def polydata(places, polygons=None, lines=None):
    data = vtkPolyData()
    points = vtkPoints()
    points.SetData(numpy_to_vtk(np.ascontiguousarray(places), deep=True))
    data.SetPoints(points)
    if polygons is not None:
        data.SetPolys(cell_array(polygons))
    if lines is not None:
        data.SetLines(cell_array(lines))
    return data


def cell_array(cells):
    found = vtkCellArray()
    found.SetData(cells.shape[1], numpy_to_vtkIdTypeArray(
        np.ascontiguousarray(cells.ravel(), np.int64), deep=True))
    return found


def colour(values, colours):
    low, high = colours["range"]
    share = np.clip((values - low) / (high - low), 0, 1)
    return matplotlib.colormaps[colours["map"]](share, bytes=True)[:, :3].copy()


def outline_of(frame):
    """The edges of the body at rest."""
    clean, edges = vtkCleanPolyData(), vtkFeatureEdges()
    clean.SetInputData(polydata(frame.lattice.values(frame.rest),
                                polygons=frame.lattice.quadrilaterals()))
    clean.SetTolerance(1e-6)
    edges.SetInputConnection(clean.GetOutputPort())
    edges.NonManifoldEdgesOff()
    edges.ColoringOff()
    edges.Update()
    return edges.GetOutput()


def blade_strip(edge, back):
    """The blade's sheet between its edge and its back; in 2D it is a line."""
    n = len(edge)
    i = np.arange(n - 1)
    if n == 1:
        return polydata(np.vstack([edge, back]), lines=np.array([[0, 1]]))
    return polydata(np.vstack([edge, back]),
                    polygons=np.stack([i, i + 1, i + 1 + n, i + n], axis=1))
