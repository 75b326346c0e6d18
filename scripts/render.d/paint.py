"""Paint the frames of runs with ParaView, without labels.

pvbatch paint.py '{"directories": [...], "field": ..., "size": [w, h],
"view": [across, along], "range": null}'

All runs share the camera and the colour range, so that their pictures can be
compared. Writes DIR/render/plain/NNNN.png and view.json (colours, and where in
the picture the blade's forces act) for each DIR.
"""

import json
import os
import sys

import matplotlib
import numpy as np
from paraview import simple as pv
from paraview.vtk.util.numpy_support import vtk_to_numpy
from vtkmodules.vtkCommonDataModel import vtkUnstructuredGrid
from vtkmodules.vtkIOXML import (vtkXMLPUnstructuredGridReader,
                                 vtkXMLUnstructuredGridReader)

sys.path.insert(0, os.path.dirname(os.path.abspath(sys.argv[0])))
from blade import Blade, unit  # noqa: E402
from run_directory import RunDirectory  # noqa: E402

APART = 0.2      # how far pieces are drawn apart, of their centres' distance
ARROW = 0.4      # length of the largest force's arrow, of the body's size


class Frame:
    """One state: the grid at its deformed place and the blade's forces."""

    def __init__(self, run, number):
        self.number = number
        self.grid = read_grid(run.frames[number])
        self.places = vtk_to_numpy(self.grid.GetPoints().GetData())
        rest = self.places.copy()
        self.places += array(self.grid.GetPointData(), "displacement")
        self.places += self.apart()
        self.grid.GetPoints().Modified()
        self.arrows = self.find_arrows(run, rest)

    def apart(self):
        """The pieces' gap closes when they unload: move them apart to see it."""
        pieces = array(self.grid.GetCellData(), "piece")
        offsets = np.zeros_like(self.places)
        self.is_apart = len(np.unique(pieces)) > 1
        if self.is_apart:
            n_points = len(self.places) // len(pieces)  # no point is shared
            of_point = np.repeat(pieces, n_points)
            for piece in np.unique(pieces):
                chosen = of_point == piece
                offsets[chosen] = APART * (self.places[chosen].mean(axis=0) -
                                           self.places.mean(axis=0))
        return offsets

    def find_arrows(self, run, rest):
        """(tip, force along the blade) of the loads on the front row."""
        loaded = [line for line in run.events(self.number)
                  if line["event"] in ("deform", "arrest")]
        if not loaded:
            return []
        blade = Blade(run.parameters, loaded[-1]["cut"])
        return [(self.place_of(point, rest), force * blade.direction)
                for point, force in blade.forces(loaded[-1]["depth"],
                                                 loaded[-1]["load_factor"])
                if force]

    def place_of(self, point, rest):
        distance = np.linalg.norm(rest - point, axis=1)
        nearest = distance < distance.min() + 1e-6 * np.ptp(rest)
        return self.places[nearest].mean(axis=0)


def read_grid(file_name):
    reader = vtkXMLPUnstructuredGridReader() \
        if file_name.endswith(".pvtu") else vtkXMLUnstructuredGridReader()
    reader.SetFileName(file_name)
    reader.Update()
    grid = vtkUnstructuredGrid()
    grid.DeepCopy(reader.GetOutput())
    return grid


def array(data, name):
    if not data.HasArray(name):
        names = [data.GetArrayName(i) for i in range(data.GetNumberOfArrays())]
        sys.exit(f"The frames have no field {name}; they have "
                 f"{', '.join(names)}.")
    return vtk_to_numpy(data.GetArray(name))


class Camera:
    """A parallel projection along the blade's edge, obliquely."""

    def __init__(self, blade, angles):
        across, along = np.tan(np.radians(angles))
        up = np.array([0, 1, 0])
        self.towards = np.array([0, 0, 1])
        if blade.dimension == 3:
            edge = blade.edge if blade.edge.sum() > 0 else -blade.edge
            self.towards = unit(edge - across * blade.normal -
                                along * blade.direction)
            up = -blade.direction if abs(edge[2]) > 0.9 else np.eye(3)[2]
        self.right = unit(np.cross(up, self.towards))
        self.up = np.cross(self.towards, self.right)

    def project(self, points):
        points = np.atleast_2d(points)
        return np.stack([points @ self.right, points @ self.up], axis=1)

    def fit(self, points, size):
        low, high = self.project(points).min(axis=0), \
            self.project(points).max(axis=0)
        self.centre = (low + high) / 2
        self.half_height = 0.53 * max(high[1] - low[1],
                                      (high[0] - low[0]) * size[1] / size[0])
        self.focus = self.centre @ np.array([self.right, self.up])
        self.distance = 10 * self.half_height + np.abs(points).max() * 4

    def pixels(self, points, size):
        """In units of the picture's height from its centre, y upwards."""
        offset = (self.project(points) - self.centre) / (2 * self.half_height)
        return offset.tolist()

    def aim(self, view):
        view.CameraParallelProjection = 1
        view.CameraParallelScale = self.half_height
        view.CameraFocalPoint = list(self.focus)
        view.CameraPosition = list(self.focus + self.distance * self.towards)
        view.CameraViewUp = list(self.up)
