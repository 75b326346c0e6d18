# SPDX-License-Identifier: LGPL-2.1-or-later
"""Cook's membrane. It is in plane stress, the program's plane is strain; the fields
in the plane are the same for E (1 + 2 ν) / (1 + ν)² and ν / (1 + ν)."""

from bodies import Body, near
from problems import Case, Row, material, solve

YOUNGS_MODULUS, POISSONS_RATIO = 1, 1 / 3
# How far the ratio may be from 1 on n × n elements.
BOUNDS = {2: .06, 4: .015, 8: .005, 16: .002, 32: .0015}
# What linear elements are known to give.
LINEAR = {2: 11.845, 4: 18.299, 8: 22.079, 16: 23.430, 32: 23.817}


def make_body(n):
    body = Body(2)
    body.add_block((n, n), lambda s, t: (48 * s, 44 * s * (1 - t) + (44 + 16 * s) * t))
    body.add_group("left", lambda x, y: near(x, 0))
    body.add_group("right", lambda x, y: near(x, 48))
    return body


def rows(options, _):
    nu = POISSONS_RATIO
    plane = material(repr(YOUNGS_MODULUS * (1 + 2 * nu) / (1 + nu) ** 2), nu / (1 + nu))

    def tip(n, element_type):
        state = solve(options, {**plane, "Body/Element type": element_type,
                                "Support/Fixed faces": "left",
                                "Load/Tractions": f"right : 0, {1 / 16}"}, make_body(n))
        return state.at((48, 52), "uy")

    for element_type in ("serendipity", "quadratic"):
        for n, bound in BOUNDS.items():
            yield Row("v at (48, 52)", f"{n} × {n} {element_type}", 23.96,
                      tip(n, element_type), bound)
    for n, expected in LINEAR.items():
        yield Row("v at (48, 52)", f"{n} × {n} linear", 23.96, tip(n, "linear"), .0002,
                  expected=expected / 23.96)


CASE = Case(
    "membrane", "Cook's membrane, plane stress by plane strain of other constants",
    "Cook, Improved two-dimensional finite element, Journal of the Structural Division "
    "100, 1974; the value 23.96 on fine meshes is in common use, and an independent "
    "20-node code's", rows)
