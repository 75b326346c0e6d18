# SPDX-License-Identifier: LGPL-2.1-or-later
"""Grids as VTK's own readers give them."""

import math
import pathlib
from xml.etree import ElementTree

from vtkmodules.vtkCommonCore import vtkOutputWindow, vtkStringOutputWindow
from vtkmodules.vtkFiltersVerdict import vtkCellSizeFilter
from vtkmodules.vtkIOXML import (vtkXMLPUnstructuredGridReader,
                                 vtkXMLUnstructuredGridReader)

INTEGERS = ("char", "signed char", "unsigned char", "short", "int", "long", "long long",
            "vtkIdType")


class ReadError(Exception):
    """A file that VTK cannot read, in VTK's words."""


class Grid:
    """A grid: its points, its cells and its arrays."""

    def __init__(self, path):
        path = pathlib.Path(path)
        window = vtkStringOutputWindow()
        vtkOutputWindow.SetInstance(window)
        parallel = path.suffix == ".pvtu"
        reader = (vtkXMLPUnstructuredGridReader if parallel
                  else vtkXMLUnstructuredGridReader)()
        reader.SetFileName(str(path))
        reader.Update()
        self.grid = reader.GetOutput()
        words = " ".join((window.GetOutput() or "").split())
        if words or reader.GetErrorCode():
            raise ReadError(f"{path.name}: {words or reader.GetErrorCode()}")
        self.points = [self.grid.GetPoint(i)
                       for i in range(self.grid.GetNumberOfPoints())]
        self.kinds = [self.grid.GetCellType(i)
                      for i in range(self.grid.GetNumberOfCells())]
        self.double = (self.grid.GetNumberOfPoints() > 0
                       and self.grid.GetPoints().GetData().GetDataTypeAsString()
                       == "double")
        self.point_data = arrays(self.grid.GetPointData())
        self.cell_data = arrays(self.grid.GetCellData())
        self.field_data = arrays(self.grid.GetFieldData())

    def cell(self, i):
        """The points of a cell."""
        ids = self.grid.GetCell(i).GetPointIds()
        return [ids.GetId(j) for j in range(ids.GetNumberOfIds())]

    def sizes(self):
        """The volume of each cell, in two dimensions its area."""
        name = "Volume" if self.grid.GetCell(0).GetCellDimension() == 3 else "Area"
        measure = vtkCellSizeFilter()
        measure.SetInputData(self.grid)
        measure.Update()
        values = measure.GetOutput().GetCellData().GetArray(name)
        return [values.GetValue(i) for i in range(values.GetNumberOfTuples())]


class Array:
    """An array: its components, their names, and its values as tuples."""

    def __init__(self, data):
        self.name = data.GetName()
        self.n = data.GetNumberOfComponents()
        self.text = data.GetDataTypeAsString() == "string"
        self.integer = data.GetDataTypeAsString() in INTEGERS
        self.names = [data.GetComponentName(c) for c in range(self.n)]
        length = data.GetNumberOfTuples()
        self.values = [data.GetValue(i) for i in range(length)] if self.text else [
            data.GetTuple(i) for i in range(length)]

    def numbers(self):
        """The values of an array of one component."""
        return [value[0] for value in self.values]

    def problems(self, n, integer=None, names=None, length=None):
        """What is not as it must be."""
        if self.n != n:
            yield f"{self.name} has {self.n} components instead of {n}"
        if integer is not None and self.integer != integer:
            yield f"{self.name} has the wrong kind of numbers"
        if names and self.names != list(names):
            yield f"the components of {self.name} are {self.names}"
        if length is not None and len(self.values) != length:
            yield f"{self.name} has {len(self.values)} values instead of {length}"
        if not self.text and not all(math.isfinite(x) for v in self.values for x in v):
            yield f"{self.name} is not finite"


def arrays(data):
    """All arrays of a kind, by name."""
    found = (Array(data.GetAbstractArray(i)) for i in range(data.GetNumberOfArrays()))
    return {array.name: array for array in found}


def expected_arrays(found, expected, length, where):
    """Problems of arrays that must be there: name: (components, integer, names)."""
    for name, (n, integer, names) in expected.items():
        if name not in found:
            yield f"there is no {name} of {where}"
        else:
            yield from found[name].problems(n, integer, names, length)


def frames_of(collection):
    """The frames that cut.pvd names: times and paths."""
    tree = ElementTree.parse(collection).getroot()
    return [(float(part.get("timestep")), collection.parent / part.get("file"))
            for part in tree.iter("DataSet")]


def bounds_problems(points, box, tolerance):
    """Whether the points reach from the first to the second corner of a box."""
    for axis, (low, high) in enumerate(zip(*box)):
        values = [point[axis] for point in points]
        if abs(min(values) - low) > tolerance or abs(max(values) - high) > tolerance:
            yield f"{'xyz'[axis]} reaches from {min(values)} to {max(values)}"
