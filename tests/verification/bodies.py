# SPDX-License-Identifier: LGPL-2.1-or-later
"""Bodies of serendipity elements, built block by block and written as gmsh files.

A block is a grid of elements on the unit cube (2D: square) with a function that
gives the place of each of its points, middle nodes among them, so that elements
are curved where the function is.
"""

import itertools

# gmsh's order: corners around the bottom, around the top, and these edges.
CORNERS = {2: [(0, 0), (1, 0), (1, 1), (0, 1)],
           3: [(0, 0, 0), (1, 0, 0), (1, 1, 0), (0, 1, 0),
               (0, 0, 1), (1, 0, 1), (1, 1, 1), (0, 1, 1)]}
EDGES = {2: [(0, 1), (1, 2), (2, 3), (3, 0)],
         3: [(0, 1), (0, 3), (0, 4), (1, 2), (1, 5), (2, 3),
             (2, 6), (3, 7), (4, 5), (4, 7), (5, 6), (6, 7)]}
FACES = {2: [],
         3: [(0, 3, 2, 1), (4, 5, 6, 7), (0, 1, 5, 4),
             (1, 2, 6, 5), (2, 3, 7, 6), (3, 0, 4, 7)]}
# Types of gmsh: a point, 3-node line, 8-node quadrilateral, 20-node hexahedron.
TYPES = {1: 15, 3: 8, 8: 16, 20: 17}
RESOLUTION = 1e-9


class Body:
    def __init__(self, dim):
        self.dim = dim
        self.positions = []
        self.elements = []
        self.groups = {}
        self._numbers = {}

    def _node(self, position):
        key = tuple(round(x / RESOLUTION) for x in position)
        if key not in self._numbers:
            self._numbers[key] = len(self.positions)
            self.positions.append(tuple(position))
        return self._numbers[key]

    def add_element(self, points):
        """An element by its nodes' places in gmsh's order; without the middle
        ones its edges are straight."""
        points = list(points)
        if len(points) == len(CORNERS[self.dim]):
            points += [tuple((a + b) / 2 for a, b in zip(points[i], points[j]))
                       for i, j in EDGES[self.dim]]
        self.elements.append([self._node(point) for point in points])

    def add_block(self, n, place, straight=False):
        """n elements along each direction; `place` maps the unit cube."""
        for cell in itertools.product(*(range(m) for m in n)):
            corners = [[(c + o) / m for c, o, m in zip(cell, corner, n)]
                       for corner in CORNERS[self.dim]]
            middles = [] if straight else [
                [(a + b) / 2 for a, b in zip(corners[i], corners[j])]
                for i, j in EDGES[self.dim]]
            self.add_element(place(*point) for point in corners + middles)

    def _entities(self, element, dimension):
        """The nodes of an element's faces or edges, middle nodes last."""
        edges = EDGES[self.dim]
        middle = {frozenset(edge): element[len(CORNERS[self.dim]) + i]
                  for i, edge in enumerate(edges)}
        for corners in edges if dimension == 1 else FACES[self.dim]:
            ring = zip(corners, corners[1:] + corners[:1])
            sides = [corners] if dimension == 1 else list(ring)
            yield ([element[c] for c in corners] +
                   [middle[frozenset(side)] for side in sides])

    def add_group(self, name, holds, dimension=None):
        """The faces (or edges) all of whose nodes lie where `holds` says."""
        dimension = dimension or self.dim - 1
        inside = [holds(*position) for position in self.positions]
        found = {tuple(sorted(nodes)): nodes for element in self.elements
                 for nodes in self._entities(element, dimension)
                 if all(inside[node] for node in nodes)}
        assert found, f"the group {name} is empty"
        self.groups[name] = (dimension, list(found.values()))

    def add_point(self, name, position):
        self.groups[name] = (0, [[self._node(position)]])

    def number(self, position):
        """The number of a node in the file."""
        return self._node(position) + 1

    def write(self, path):
        groups = {"body": (self.dim, self.elements), **self.groups}
        lines = ["$MeshFormat", "2.2 0 8", "$EndMeshFormat", "$PhysicalNames",
                 str(len(groups))]
        lines += [f'{dimension} {tag} "{name}"' for tag, (name, (dimension, _))
                  in enumerate(groups.items(), 1)]
        lines += ["$EndPhysicalNames", "$Nodes", str(len(self.positions))]
        for i, position in enumerate(self.positions, 1):
            x = list(position) + [0.0] * (3 - self.dim)
            lines.append(f"{i} {x[0]:.16g} {x[1]:.16g} {x[2]:.16g}")
        entities = [(tag, nodes) for tag, (_, members) in
                    enumerate(groups.values(), 1) for nodes in members]
        lines += ["$EndNodes", "$Elements", str(len(entities))]
        for i, (tag, nodes) in enumerate(entities, 1):
            lines.append(f"{i} {TYPES[len(nodes)]} 2 {tag} {tag} " +
                         " ".join(str(node + 1) for node in nodes))
        lines += ["$EndElements", ""]
        path.write_text("\n".join(lines))


def near(value, other):
    return abs(value - other) < 1e-7
