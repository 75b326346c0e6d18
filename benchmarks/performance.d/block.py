# SPDX-License-Identifier: LGPL-2.1-or-later
"""A block of general hexahedra, as gmsh would write it."""

import itertools
import math


def moved(point, n):
    """A point of the grid, which is not where it would be in a regular one if it is
    inside."""
    if any(x in (0, n) for x in point):
        return [x / n for x in point]
    x, y, z = point
    return [(x + 0.2 * math.sin(3.1 * x + 5.3 * y + 1.9 * z)) / n,
            (y + 0.2 * math.sin(5.7 * x + 2.3 * y + 4.1 * z)) / n,
            (z + 0.2 * math.sin(2.9 * x + 4.7 * y + 3.7 * z)) / n]


def write(path, n):
    """n^3 elements in a cube of size 1 with faces `bottom` and `top`."""
    def node(x, y, z):
        return 1 + x + (n + 1) * (y + (n + 1) * z)

    grid = range(n + 1)
    lines = ["$MeshFormat", "2.2 0 8", "$EndMeshFormat", "$PhysicalNames", "3",
             '2 1 "bottom"', '2 2 "top"', '3 3 "block"', "$EndPhysicalNames",
             "$Nodes", str((n + 1) ** 3)]
    for z, y, x in itertools.product(grid, repeat=3):
        lines.append(f"{node(x, y, z)} " + " ".join(
            f"{coordinate:.16g}" for coordinate in moved((x, y, z), n)))
    elements = []
    for tag, z in ((1, 0), (2, n)):
        for y, x in itertools.product(range(n), repeat=2):
            elements.append((3, tag, [node(x, y, z), node(x + 1, y, z),
                                      node(x + 1, y + 1, z), node(x, y + 1, z)]))
    for z, y, x in itertools.product(range(n), repeat=3):
        elements.append((5, 3, [node(x + i, y + j, z + k) for k in (0, 1)
                                for i, j in ((0, 0), (1, 0), (1, 1), (0, 1))]))
    lines += ["$EndNodes", "$Elements", str(len(elements))]
    for number, (kind, tag, nodes) in enumerate(elements):
        lines.append(f"{number + 1} {kind} 2 {tag} {tag} " + " ".join(map(str, nodes)))
    lines.append("$EndElements")
    path.write_text("\n".join(lines) + "\n")
