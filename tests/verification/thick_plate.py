# SPDX-License-Identifier: LGPL-2.1-or-later
"""The thick elliptic plate of NAFEMS."""

import math

from bodies import Body, near
from problems import Case, Row, material, solve

INNER, OUTER = (2.0, 1.0), (3.25, 2.75)
THICKNESS = 0.6
# Stress at the node D on these elements, along the ellipse, across, and through.
MESHES = {(6, 4, 2): -5.565, (12, 8, 4): -5.523, (24, 16, 8): -5.435}


def place(across, along, up):
    angle = along * math.pi / 2
    a, b = ((1 - across) * i + across * o for i, o in zip(INNER, OUTER))
    return (a * math.cos(angle), b * math.sin(angle), THICKNESS * (up - .5))


def on_outer(x, y, _):
    return near((x / OUTER[0]) ** 2 + (y / OUTER[1]) ** 2, 1)


def make_body(n):
    body = Body(3)
    body.add_block((n[1], n[0], n[2]), place)
    body.add_group("x axis", lambda x, y, z: near(y, 0))
    body.add_group("y axis", lambda x, y, z: near(x, 0))
    body.add_group("top", lambda x, y, z: near(z, THICKNESS / 2))
    body.add_group("outer", on_outer)
    body.add_group("line", lambda x, y, z: on_outer(x, y, z) and near(z, 0), 1)
    return body


def rows(options, long):
    for n, independent in MESHES.items():
        if n[0] > 12 and not long:
            continue
        state = solve(options, {
            **material(210e3, .3), "Load/Pressures": "top : 1",
            "Support/Fixed components":
            "x axis : y; y axis : x; outer : xy; line : z"}, make_body(n))
        yield Row("stress across the section at D [MPa]", "{} × {} × {}".format(*n),
                  -5.38, state.at((2, 0, THICKNESS / 2), "syy"), .0002,
                  expected=independent / -5.38)


CASE = Case(
    "thick_plate", "LE10, thick plate under pressure",
    "NAFEMS, The Standard NAFEMS Benchmarks, 1990: −5.38 MPa; the ratios that are "
    "expected on these meshes are an independent 20-node code's", rows)
