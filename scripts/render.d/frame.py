"""A solved state as ParaView shall draw it."""

import sys

import numpy as np
from blade import Blade
from paraview.vtk.util.numpy_support import vtk_to_numpy
from vtkmodules.vtkCommonDataModel import vtkUnstructuredGrid
from vtkmodules.vtkIOXML import (vtkXMLPUnstructuredGridReader,
                                 vtkXMLUnstructuredGridReader)

APART = 0.2  # how far pieces are drawn apart, of their centres' distance


class Frame:
    """One state: the grid at its deformed place and the blade's forces."""

    def __init__(self, run, number):
        self.number = number
        self.grid = read_grid(run.frames[number])
        self.places = vtk_to_numpy(self.grid.GetPoints().GetData())
        rest = self.places.copy()
        self.places += array(self.grid, "displacement")
        self.arrows = self.find_arrows(run, rest)
        pieces = array(self.grid, "piece")
        self.is_apart = len(np.unique(pieces)) > 1 and not self.arrows
        if self.is_apart:
            self.places += self.apart(pieces)
        self.grid.GetPoints().Modified()

    def apart(self, pieces):
        """The gap closes as pieces unload: where they go so that it shows."""
        offsets = np.zeros_like(self.places)
        for piece in np.unique(pieces):
            chosen = pieces == piece  # a point belongs to one element only
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

    def extent(self):
        """What the camera must see."""
        return np.vstack([self.places, *(tail for _, tail, _ in self.arrows)])

    def values(self, field):
        """Magnitudes of a vector, numbers of a scalar."""
        found = array(self.grid, field)
        return np.linalg.norm(found, axis=1) if found.ndim > 1 else found


def read_grid(file_name):
    reader = vtkXMLPUnstructuredGridReader() \
        if file_name.endswith(".pvtu") else vtkXMLUnstructuredGridReader()
    reader.SetFileName(file_name)
    reader.Update()
    grid = vtkUnstructuredGrid()
    grid.DeepCopy(reader.GetOutput())
    return grid


def array(grid, name):
    data = grid.GetPointData()
    if not data.HasArray(name):
        names = [data.GetArrayName(i) for i in range(data.GetNumberOfArrays())]
        sys.exit(f"The frames have no field {name}; they have "
                 f"{', '.join(names)}.")
    return vtk_to_numpy(data.GetArray(name))
