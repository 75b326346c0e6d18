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
        self.direction = unit(numbers(parameters["Blade/Direction"],
                                      self.dimension))
        self.loads = [tuple(map(float, load.split(":"))) for load in
                      parameters["Blade/Edge loads"].split(",") if load.strip()]
        surfaces = [s for s in parameters["Cut/Surfaces"].split(";")
                    if s.strip()]
        axis, boundary = surfaces[cut].split(":") if surfaces else ("y", "0")
        self.has_cut = bool(surfaces)
        self.axis = "xyz".index(axis.strip())
        self.boundary = int(boundary)
        self.normal = np.eye(3)[self.axis]
        self.edge = np.cross(self.normal, self.direction)

    def forces(self, depth, load_factor):
        """(point, force) of each load while the front is at this depth."""
        if self.body != "box" or not self.has_cut:
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


def numbers(text, dimension):
    values = [float(value) for value in text.split(",")[:dimension]]
    return np.array(values + [0.0] * (3 - dimension))


def unit(vector):
    return vector / np.linalg.norm(vector)
