# SPDX-License-Identifier: LGPL-2.1-or-later
"""A solved state, read from its file."""

import sys

import numpy as np
from front import ordered_front, refined
from surface import Lattice, fineness, outer_faces
from vtkmodules.util.numpy_support import vtk_to_numpy
from vtkmodules.vtkIOXML import (vtkXMLPUnstructuredGridReader,
                                 vtkXMLUnstructuredGridReader)

NEEDED = ("displacement", "node", "front")
APART = 0.2    # how far pieces are drawn apart, of their centres' distance
NESTED = 0.05  # pieces whose centres are nearer, of their extents, are nested


class Frame:
    """One state: its elements, its fields, and the blade, if there is one."""

    def __init__(self, run, number, field):
        self.number = number
        grid = read_grid(run.frames[number])
        self.blade = Sheet(read_grid(run.blades[number])) \
            if number in run.blades else None
        self.names = component_names(grid.GetPointData())
        self.cells_data, facts = (arrays(data) for data in (grid.GetCellData(),
                                                            grid.GetFieldData()))
        # The others would only take memory.
        self.points = {name: values
                       for name, values in arrays(grid.GetPointData()).items()
                       if name in NEEDED or field.startswith(name)}
        self.rest = vtk_to_numpy(grid.GetPoints().GetData()).astype(float)
        self.displacement = self.points["displacement"].astype(float)
        self.cells = element_points(grid)
        self.facts = facts
        self.has_blade = len(facts.get("blade_points", ())) > 0
        pieces = np.unique(self.piece)
        self.is_apart = len(pieces) > 1 and not self.has_blade

    @property
    def piece(self):
        return self.cells_data["piece"]

    def size(self):
        return np.ptp(self.rest, axis=0).max()

    def warp(self, factor, out):
        """Put the points where they are drawn; `out` is the way along which a
        piece is drawn from another that surrounds it."""
        self.places = self.rest + factor * self.displacement
        if self.is_apart:
            self.places += self.offsets(out)
        faces, self.face_cell = outer_faces(self.cells, self.points["node"],
                                            self.piece, self.places)
        self.lattice = Lattice(faces, fineness(len(faces)))
        self.surface = self.lattice.values(self.places)

    def offsets(self, out):
        """The gap closes as pieces unload: where they go so that it shows."""
        chosen = [self.cells[self.piece == piece].ravel()
                  for piece in np.unique(self.piece)]
        centres = np.array([self.places[points].mean(axis=0) for points in chosen])
        ways = centres - self.places.mean(axis=0)
        extents = np.array([np.ptp(self.places[points], axis=0)
                            for points in chosen])
        if np.linalg.norm(ways, axis=1).max() < NESTED * extents.min():
            ways[np.argmin(extents.max(axis=1))] += 2 * self.size() * out
        offsets = np.zeros_like(self.rest)
        for points, way in zip(chosen, ways):
            offsets[points] = APART * way
        return offsets

    def places_of(self, points):
        """Where points of the body at rest are drawn."""
        rest = np.vstack([self.lattice.values(self.rest), self.rest])
        places = np.vstack([self.surface, self.places])
        found = []
        for point in points:
            distance = np.linalg.norm(rest - point, axis=1)
            nearest = distance < distance.min() + 1e-5 * self.size()
            found.append(places[nearest].mean(axis=0))
        return np.array(found)

    def forces(self):
        """(place, force) of each load of the blade."""
        if not self.has_blade:
            return []
        places = self.places_of(self.facts["blade_points"])
        return [(place, force) for place, force in
                zip(places, self.facts["blade_forces"]) if np.any(force)]

    def front(self):
        """The drawn lines through the nodes of the row under the blade."""
        chosen = self.points["front"] == 1
        if not self.has_blade or not chosen.any():
            return []
        lines = ordered_front(self.rest[chosen], self.facts["blade_direction"][0],
                              self.facts["cut_normal"][0])
        return [self.places_of(refined(line)) for line in lines]

    def values(self, field):
        """A number for each point of the lattice: of vectors the magnitude, of
        'stress_ZZ' a component."""
        if field in self.cells_data:
            return self.lattice.of_cells(self.cells_data[field], self.face_cell)
        return magnitude(self.lattice.values(self.point_field(field)))

    def nodal_values(self, field):
        """As they were computed: between nodes they may overshoot."""
        if field in self.cells_data:
            return self.cells_data[field]
        return magnitude(self.point_field(field))

    def point_field(self, field):
        if field in self.points:
            return self.points[field]
        name, _, component = field.rpartition("_")
        if component in self.names.get(name, ()):
            return self.points[name][:, self.names[name].index(component)]
        sys.exit(f"The frames have no field {field}; they have "
                 f"{', '.join([*self.names, *self.cells_data])}, and components "
                 "as stress_ZZ.")


class Sheet:
    """The surface of a blade that travels: its points and polygons."""

    def __init__(self, grid):
        self.points = vtk_to_numpy(grid.GetPoints().GetData()).astype(float)
        self.polygons = element_points(grid)


def magnitude(values):
    return np.linalg.norm(values, axis=1) if values.ndim > 1 else values


def read_grid(file_name):
    reader = vtkXMLPUnstructuredGridReader() \
        if file_name.endswith(".pvtu") else vtkXMLUnstructuredGridReader()
    reader.SetFileName(file_name)
    reader.Update()
    return reader.GetOutput()


def arrays(data):
    return {data.GetArrayName(i): vtk_to_numpy(data.GetArray(i))
            for i in range(data.GetNumberOfArrays())}


def component_names(data):
    found = (data.GetArray(i) for i in range(data.GetNumberOfArrays()))
    return {array.GetName(): [array.GetComponentName(j) for j in
                              range(array.GetNumberOfComponents())]
            for array in found}


def element_points(grid):
    """Elements x points; all elements of a body have the same number."""
    connectivity = vtk_to_numpy(grid.GetCells().GetConnectivityArray())
    return connectivity.reshape(grid.GetNumberOfCells(), -1)
