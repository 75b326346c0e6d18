"""Where the blade is: its axes and the points its forces act on."""

import itertools

import numpy as np


class Blade:
    """The blade of a scene, in the undeformed body."""

    def __init__(self, parameters, cut=0):
        self.dimension = int(parameters["Dimension"])
        self.body = parameters["Body/Shape"]
        self.size = numbers(parameters["Body/Size"], self.dimension)
        self.elements = numbers(parameters["Body/Elements"], self.dimension)
        self.direction = unit(numbers(
            item(parameters["Blade/Direction"], cut), self.dimension))
        self.loads = [tuple(map(float, load.split(":"))) for load in
                      item(parameters["Blade/Edge loads"], cut).split(",")
                      if load.strip()]
        self.axis = self.boundary = None
        self.normal = np.array([0.0, 1.0, 0.0])
        self.set_surface(surfaces_of(parameters["Cut/Surfaces"]), cut)
        self.edge = np.cross(self.normal, self.direction)

    def set_surface(self, surfaces, cut):
        """The normal of a cut, as far as its item tells it, and the layers of
        elements between which a box is cut."""
        if cut >= len(surfaces):
            return
        kind, text = (part.strip() for part in surfaces[cut].split(":", 1))
        if kind in ("x", "y", "z"):
            self.axis = "xyz".index(kind)
            self.boundary = int(text)
            self.normal = np.eye(3)[self.axis]
        elif kind == "plane":
            self.normal = unit(numbers(text.split(";")[1], self.dimension))

    def forces(self, depth, load_factor):
        """(point, force) of each load while the front is at this depth."""
        if self.body != "box" or self.axis is None:
            return []
        return [(self.point(position, depth), load_factor * force)
                for position, force in self.loads]

    def point(self, position, depth):
        """The point of the cut's plane at a position along the edge."""
        plane = self.size[self.axis] * self.boundary / self.elements[self.axis]
        corners = [[plane if i == self.axis else c[i] * self.size[i]
                    for i in range(3)]
                   for c in itertools.product((0, 1), repeat=3)]
        entry = min(np.dot(self.direction, corner) for corner in corners)
        point = np.zeros(3)
        point[self.axis] = plane
        along = np.argmax(np.abs(self.edge))
        point[along] = position
        free = 3 - self.axis - along
        point[free] = (entry + depth - np.dot(self.direction, point)) / \
            self.direction[free]
        return point


def item(text, cut):
    """The item of a cut in a list that has one for each, or one for all."""
    items = text.split(";")
    return items[cut if len(items) > 1 else 0]


def surfaces_of(text):
    """The items of Cut/Surfaces; a plane has a ';' of its own."""
    surfaces = []
    for part in text.split(";"):
        if surfaces and surfaces[-1].startswith("plane") and \
                ";" not in surfaces[-1]:
            surfaces[-1] += ";" + part
        elif part.strip():
            surfaces.append(part.strip())
    return surfaces


def numbers(text, dimension):
    values = [float(value) for value in text.split(",")[:dimension]]
    return np.array(values + [0.0] * (3 - dimension))


def unit(vector):
    return vector / np.linalg.norm(vector)
