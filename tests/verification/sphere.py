# SPDX-License-Identifier: LGPL-2.1-or-later
"""A thick sphere under inner pressure, on curved elements, elastic and plastic."""

import math

from bodies import Body, near
from problems import Case, Row, material, solve

INNER, OUTER = 1, 2
YOUNGS_MODULUS, POISSONS_RATIO = 5, .3


def closed_form(r):
    """Lamé's, for a pressure of 1."""
    a, b, nu = INNER, OUTER, POISSONS_RATIO
    return (a ** 3 / (YOUNGS_MODULUS * (b ** 3 - a ** 3)) *
            ((1 - 2 * nu) * r + (1 + nu) * b ** 3 / (2 * r * r)))


def make_body(n):
    """An octant: the parts that belong to three faces of a cube."""
    body = Body(3)
    for axis in range(3):
        def place(across, s, t):
            direction = (1, s, t)
            r = (INNER + (OUTER - INNER) * across) / math.hypot(*direction)
            point = [r * d for d in direction]
            # Turned about the diagonal, which keeps right hands right.
            return tuple(point[-axis:] + point[:-axis])
        body.add_block((n, n, n), place)
    for axis, name in enumerate("xyz"):
        body.add_group(name, lambda *p, a=axis: near(p[a], 0))
    body.add_group("inner", lambda *p: near(math.hypot(*p), INNER))
    return body


def solution(options, n):
    """The displacement at the inside, on the x axis, and the error of all nodes' (root
    mean square over that of the closed form)."""
    state = solve(options, {
        **material(YOUNGS_MODULUS, POISSONS_RATIO), "Load/Pressures": "inner : 1",
        "Support/Fixed components": "x : x; y : y; z : z"}, make_body(n))
    difference, norm = 0, 0
    for node in state.nodes:
        r = math.hypot(*node["p"])
        for x, column in zip(node["p"], ("ux", "uy", "uz")):
            exact = closed_form(r) * x / r
            difference += (float(node[column]) - exact) ** 2
            norm += exact ** 2
    return state.at((INNER, 0, 0), "ux"), math.sqrt(difference / norm)


def plastic_rows(options):
    """Plastic flow up to a radius c without hardening, of an incompressible body; one
    step is exact, as in the cylinder."""
    stress, modulus = 1, 1000
    for c, n, bound in ((1.5, 2, .03), (1.5, 4, .005)):
        pressure = (2 * stress * math.log(c / INNER) +
                    2 / 3 * stress * (1 - (c / OUTER) ** 3))
        state = solve(options, {
            **material(modulus, .4999), "Load/Pressures": f"inner : {pressure!r}",
            "Material/Yield stress": stress,
            "Support/Fixed components": "x : x; y : y; z : z"}, make_body(n))
        # Where it begins to flow u is σ_y c / (2 E), and volume does not change.
        yield Row(f"u at the inside, plastic flow up to the radius {c}", f"3 × {n}³",
                  stress * c ** 3 / (2 * modulus * INNER ** 2),
                  state.at((INNER, 0, 0), "ux"), bound)


def rows(options, long):
    last = None
    for n in (2, 4, 8) if long else (2, 4):
        u, e = solution(options, n)
        mesh = f"3 × {n}³"
        yield Row("u at the inside", mesh, closed_form(INNER), u, .1 * n ** -3)
        if last:
            # Quadratic elements promise the third order.
            yield Row("order of the displacement's error at nodes", mesh, 3,
                      math.log2(last / e))
        last = e
    yield from plastic_rows(options)


CASE = Case(
    "sphere", "Sphere under inner pressure, an octant of curved elements",
    "Lamé's closed form; Timoshenko & Goodier, Theory of Elasticity; plastic flow without "
    "hardening: p = 2 σ_y ln(c/a) + 2 σ_y (1 - c³/b³)/3 and σ_y c³/(2 E a²) for an "
    "incompressible body (Hill, The Mathematical Theory of Plasticity, 1950)", rows)
