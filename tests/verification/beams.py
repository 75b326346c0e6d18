# SPDX-License-Identifier: LGPL-2.1-or-later
"""Slender beams of few elements under a unit load at their tip."""

import math

from bodies import Body, near
from problems import Case, Row, material, solve

LENGTH, HEIGHT, DEPTH = 6, .2, .1


def straight(slant=None):
    """Six elements; `slant` tells how far their common sides lean: alternately
    (trapezoids), alike (parallelograms), or not."""
    body = Body(3)
    n = 6

    def place(along, across, up):
        i = round(along * n)
        lean = {None: 0, "trapezoids": (-1) ** i}[slant] if 0 < i < n else 0
        return (LENGTH * along + lean * HEIGHT * (across - .5),
                HEIGHT * across, DEPTH * up)

    body.add_block((n, 1, 1), place, straight=True)
    return body, (1, 0, 0), HEIGHT * DEPTH, lambda x, y, z: near(x, 0), \
        lambda x, y, z: near(x, LENGTH)


def curved(n):
    """A quarter of a ring, clamped on the x axis."""
    body = Body(3)

    def place(across, along, up):
        radius, angle = 4.12 + .2 * across, along * math.pi / 2
        return radius * math.cos(angle), radius * math.sin(angle), .1 * up

    body.add_block((1, n, 1), place)
    return body, None, .2 * .1, lambda x, y, z: near(y, 0), lambda x, y, z: near(x, 0)


def twisted():
    """By a right angle from the clamp to the tip."""
    body = Body(3)

    def place(along, across, up):
        c, s = math.cos(along * math.pi / 2), math.sin(along * math.pi / 2)
        y, z = .32 * (across - .5), 1.1 * (up - .5)
        return 12 * along, c * y - s * z, s * y + c * z

    body.add_block((12, 1, 2), place)
    return body, None, 1.1 * .32, lambda x, y, z: near(x, 0), \
        lambda x, y, z: near(x, 12)


def tip_displacement(options, beam, properties, axis):
    """Of the tip's middle, under a unit force along an axis that is shared out
    evenly over the tip."""
    body, _, area, clamp, tip = beam
    body.add_group("clamp", clamp)
    body.add_group("tip", tip)
    traction = ", ".join(repr(1 / area) if c == axis else "0" for c in "xyz")
    state = solve(options, {**material(*properties), "Support/Fixed faces": "clamp",
                            "Load/Tractions": f"tip : {traction}"}, body)
    return state.mean(tip, "u" + axis)


STRAIGHT, CURVED, TWISTED = (1e7, .3), (1e7, .25), (29e6, .22)
# The beam, its material, the force's axis, what the tip does by the source, and the
# part of it that an independent code finds with full integration.
BEAMS = [
    ("straight, extension", "6 × 1 × 1", straight, STRAIGHT, "x", 3.0e-5, .994),
    ("straight, in-plane", "6 × 1 × 1", straight, STRAIGHT, "y", .1081, .970),
    ("straight, out-of-plane", "6 × 1 × 1", straight, STRAIGHT, "z", .4321, .961),
    ("trapezoids, in-plane", "6 × 1 × 1", lambda: straight("trapezoids"), STRAIGHT, "y",
     .1081, .886),
    ("trapezoids, out-of-plane", "6 × 1 × 1", lambda: straight("trapezoids"), STRAIGHT,
     "z", .4321, .920),
    ("curved, in-plane", "6 × 1 × 1", lambda: curved(6), CURVED, "y", .08734, .875),
    ("curved, out-of-plane", "6 × 1 × 1", lambda: curved(6), CURVED, "z", .5022, .930),
    ("curved, in-plane", "24 × 1 × 1", lambda: curved(24), CURVED, "y", .08734, 1.010),
    ("curved, out-of-plane", "24 × 1 × 1", lambda: curved(24), CURVED, "z", .5022, .948),
    ("twisted, in-plane", "12 × 2 × 1", twisted, TWISTED, "y", 5.424535e-3, .990),
    ("twisted, out-of-plane", "12 × 2 × 1", twisted, TWISTED, "z", 1.753248e-3, .996),
]


def rows(options, _):
    for name, mesh, make, properties, axis, reference, independent in BEAMS:
        computed = abs(tip_displacement(options, make(), properties, axis))
        yield Row(name, mesh, reference, computed, .0006, expected=independent)


CASE = Case(
    "beams", "Beams under a unit load at the tip",
    "MacNeal & Harder 1985; the ratios that are expected on these meshes are an "
    "independent 20-node code's, with 3 × 3 × 3 points", rows)
