# SPDX-License-Identifier: LGPL-2.1-or-later
"""The mesh of a block of gel for a wedge: squares near the cut, wider beyond."""


def spread(points, end):
    """Scaled so that the last one is the end."""
    return [point * end / points[-1] for point in points]


def grow(first, begin, end, largest, rate=1.3):
    """Beyond `begin`, each a little wider than the one before, up to `end`."""
    points, width = [begin], first
    while points[-1] < end - 1e-9:
        width = min(rate * width, largest)
        points.append(points[-1] + width)
    return points[1:]


def coordinates(h, half_width, height, zone):
    """Across, from the cut on, and up, from the bottom."""
    across, width = [0.], h
    while across[-1] < half_width - 1e-9:
        across.append(across[-1] + width)
        if across[-1] > 4:
            width = min(1.3 * width, 2.5)
    across = spread(across, half_width)
    depths = [h * i for i in range(round(zone / h) + 1)]
    below = grow(h, zone, height, 2.5)
    factor = (height - zone) / (below[-1] - zone)
    depths += [zone + factor * (depth - zone) for depth in below]
    return across, [height - depth for depth in reversed(depths)]


def write(path, h, half_width=20., height=20., zone=12.):
    """Quadrilaterals of width h around the plane x = half_width; the group bottom."""
    across, up = coordinates(h, half_width, height, zone)
    xs = [half_width - x for x in reversed(across)]
    xs += [half_width + x for x in across[1:]]
    n, m = len(xs), len(up)
    elements = [f"1 2 1 1 {i + 1} {i + 2}" for i in range(n - 1)]
    for j in range(m - 1):
        for i in range(n - 1):
            a = j * n + i + 1
            elements.append(f"3 2 2 2 {a} {a + 1} {a + n + 1} {a + n}")
    lines = ["$MeshFormat", "2.2 0 8", "$EndMeshFormat", "$PhysicalNames", "2",
             '1 1 "bottom"', '2 2 "gel"', "$EndPhysicalNames", "$Nodes", str(n * m)]
    lines += [f"{j * n + i + 1} {x:.15g} {y:.15g} 0"
              for j, y in enumerate(up) for i, x in enumerate(xs)]
    lines += ["$EndNodes", "$Elements", str(len(elements))]
    lines += [f"{k + 1} {element}" for k, element in enumerate(elements)]
    path.write_text("\n".join([*lines, "$EndElements", ""]))
