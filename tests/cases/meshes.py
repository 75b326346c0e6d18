# SPDX-License-Identifier: LGPL-2.1-or-later
"""Small meshes of boxes as gmsh files of version 2.2, without gmsh, joined as a test
wants them."""

import itertools

# Corners of a box of 0 and 1 in gmsh's order,.
CORNERS = {2: [(0, 0), (1, 0), (1, 1), (0, 1)]}
CORNERS[3] = [(*c, 0) for c in CORNERS[2]] + [(*c, 1) for c in CORNERS[2]]
KINDS = {1: 1, 2: 3, 3: 5}


class Mesh:
    """Boxes of elements, each an entity of its own, that are joined where nodes are
    at the same place but for those that are kept apart."""

    def __init__(self, dimension=3):
        self.dimension = dimension
        self.nodes = {}
        self.numbers = {}
        self.elements = []
        self.names = {}

    def node(self, place, joined):
        if joined and place in self.numbers:
            return self.numbers[place]
        number = len(self.nodes) + 1
        self.nodes[number] = place
        self.numbers.setdefault(place, number)
        return number

    def box(self, name, begin, end, elements, joined=lambda place: True):
        """A box with a group of elements; `joined` tells which of its nodes may be
        those of earlier boxes."""
        own = {}

        def number(index):
            place = tuple(a + (b - a) * i / n
                          for a, b, i, n in zip(begin, end, index, elements))
            if place not in own:
                own[place] = self.node(place, joined(place))
            return own[place]

        group = self.group(self.dimension, name)
        for index in itertools.product(*(range(n) for n in elements)):
            nodes = [number([i + c for i, c in zip(index, corner)])
                     for corner in CORNERS[self.dimension]]
            self.elements.append((KINDS[self.dimension], group, nodes))

    def face(self, name, axis, value):
        """A group of the elements' faces on a plane."""
        group = self.group(self.dimension - 1, name)
        kind = KINDS[self.dimension]
        for _, _, nodes in [e for e in self.elements if e[0] == kind]:
            on_plane = [n for n in nodes if self.nodes[n][axis] == value]
            if len(on_plane) == len(nodes) // 2:
                self.elements.append((KINDS[self.dimension - 1], group, on_plane))

    def group(self, dimension, name):
        return self.names.setdefault((dimension, name), len(self.names) + 1)

    def text(self):
        lines = ["$MeshFormat", "2.2 0 8", "$EndMeshFormat", "$PhysicalNames",
                 str(len(self.names))]
        lines += [f'{dimension} {number} "{name}"'
                  for (dimension, name), number in self.names.items()]
        lines += ["$EndPhysicalNames", "$Nodes", str(len(self.nodes))]
        lines += [f"{number} {' '.join(map(repr, (*map(float, place), 0.0)[:3]))}"
                  for number, place in self.nodes.items()]
        lines += ["$EndNodes", "$Elements", str(len(self.elements))]
        lines += [f"{i} {kind} 2 {group} {group} {' '.join(map(str, nodes))}"
                  for i, (kind, group, nodes) in enumerate(self.elements, 1)]
        return "\n".join(lines + ["$EndElements", ""])
