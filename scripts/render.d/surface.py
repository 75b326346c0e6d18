# SPDX-License-Identifier: LGPL-2.1-or-later
"""The faces of elements that can be seen, each as a fine lattice of quadrilaterals.

Elements have the points of VTK's Lagrange cells of order 1 or 2, which the
lattice follows exactly: curved edges and fields within an element as well.
"""

import itertools

import numpy as np

# Where VTK has the points of a hexahedron of 27, from 0 to 2 along each axis.
CORNERS = [(0, 0), (2, 0), (2, 2), (0, 2)]
MIDDLES = [(1, 0), (2, 1), (1, 2), (0, 1)]
HEXAHEDRON = [*((*p, z) for z in (0, 2) for p in CORNERS),
              *((*p, z) for z in (0, 2) for p in MIDDLES),
              *((*p, 1) for p in CORNERS),
              *((x, 1, 1) for x in (0, 2)), *((1, y, 1) for y in (0, 2)),
              *((1, 1, z) for z in (0, 2)), (1, 1, 1)]
QUADRILATERAL = [*CORNERS, *MIDDLES, (1, 1)]


def element_faces(n_points):
    """The points of an element's faces, row by row: faces x side x side."""
    if n_points in (4, 9):
        places = {place: i for i, place in enumerate(QUADRILATERAL[:n_points])}
        steps = range(0, 3, 2 if n_points == 4 else 1)
        return np.array([[[places[x, y] for x in steps] for y in steps]])
    places = {place: i for i, place in enumerate(HEXAHEDRON[:n_points])}
    steps = range(0, 3, 2 if n_points == 8 else 1)

    def face(axis, side):
        return [[places[tuple(np.insert((a, b), axis, side).tolist())]
                 for a in steps] for b in steps]

    return np.array([face(axis, side)
                     for axis, side in itertools.product(range(3), (0, 2))])


def outer_faces(cells, node, piece, places):
    """(points, cell) of the faces that no other element of the piece shares.

    Faces are the same if their corners have the same nodes at one place: the
    walls of a cut that is open are not.
    """
    pattern = element_faces(cells.shape[1])
    faces = cells[:, pattern].reshape(-1, *pattern.shape[1:])
    cell = np.repeat(np.arange(len(cells)), len(pattern))
    if len(pattern) == 1:
        return faces, cell
    corners = faces[:, ::faces.shape[1] - 1, ::faces.shape[2] - 1].reshape(-1, 4)
    grain = 1e-5 * np.ptp(places, axis=0).max()
    keys = np.column_stack([np.sort(node[corners], axis=1), piece[cell],
                            np.round(places[corners].mean(axis=1) / grain)
                            ]).astype(np.int64)
    _, which, count = np.unique(keys, axis=0, return_inverse=True,
                                return_counts=True)
    single = count[which.ravel()] == 1
    return faces[single], cell[single]


class Lattice:
    """Points, normals and fields on faces, divided n times along each side."""

    def __init__(self, faces, n):
        self.n, self.n_faces = n, len(faces)
        values, slopes = basis(faces.shape[1] - 1, np.linspace(0, 1, n + 1))
        self.faces = faces.reshape(self.n_faces, -1)
        self.shape = np.kron(values, values)
        self.along = np.kron(values, slopes), np.kron(slopes, values)

    def values(self, field):
        """A field of the grid's points at the lattice's."""
        return self.combine(self.shape, field)

    def combine(self, matrix, field):
        found = np.einsum("ij,fj...->fi...", matrix, field[self.faces])
        return found.reshape(-1, *field.shape[1:])

    def normals(self, places):
        found = np.cross(*(self.combine(matrix, places)
                           for matrix in self.along))
        length = np.linalg.norm(found, axis=1, keepdims=True)
        return found / np.where(length > 0, length, 1)

    def of_cells(self, field, cell):
        return np.repeat(field[cell], (self.n + 1) ** 2, axis=0)

    def quadrilaterals(self):
        i = np.arange((self.n + 1) ** 2).reshape(self.n + 1, -1)
        one = np.stack([i[:-1, :-1], i[:-1, 1:], i[1:, 1:], i[1:, :-1]], axis=-1)
        return self.on_all_faces(one.reshape(-1, 4))

    def borders(self):
        """The lines around the faces: the edges of elements."""
        i = np.arange((self.n + 1) ** 2).reshape(self.n + 1, -1)
        return self.on_all_faces(np.stack([i[0], i[-1], i[:, 0], i[:, -1]]))

    def on_all_faces(self, one):
        offsets = np.arange(self.n_faces) * (self.n + 1) ** 2
        return (offsets[:, None, None] + one).reshape(-1, one.shape[1])


def basis(order, t):
    """The Lagrange polynomials of an order at t, and their derivatives."""
    if order == 1:
        return (np.stack([1 - t, t], axis=1),
                np.stack([-np.ones_like(t), np.ones_like(t)], axis=1))
    return (np.stack([(1 - t) * (1 - 2 * t), 4 * t * (1 - t), t * (2 * t - 1)],
                     axis=1),
            np.stack([4 * t - 3, 4 - 8 * t, 4 * t - 1], axis=1))


def fineness(n_faces):
    """How often a face's side is divided; many small faces need it less."""
    return next(n for n, most in ((16, 60), (8, 1000), (4, 8000), (2, np.inf))
                if n_faces < most)
