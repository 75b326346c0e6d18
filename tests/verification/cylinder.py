# SPDX-License-Identifier: LGPL-2.1-or-later
"""A thick cylinder under inner pressure, near incompressibility, elastic and plastic."""

import math

from bodies import Body, near
from problems import Case, Row, material, solve

RADII = (3, 3.5, 4.2, 5.2, 6.75, 9)
YOUNGS_MODULUS = 1000
# The part of the closed form that is expected, for each Poisson's ratio: an independent
# code's with 3 × 3 points, which locks; and what a formulation reaches that does not.
EXPECTED = {"displacement": {.49: .9986, .499: .9864, .4999: .8793},
            "mixed": {.49: 1, .499: 1, .4999: 1}}


def closed_form(poissons_ratio, r):
    """Lamé's, for plane strain and a pressure of 1."""
    a, b = RADII[0], RADII[-1]
    return ((1 + poissons_ratio) * a * a / (YOUNGS_MODULUS * (b * b - a * a)) *
            ((1 - 2 * poissons_ratio) * r + b * b / r))


def make_body(n=1):
    """Nine sectors of 10 degrees, with sides that follow the circles; or n times as many
    elements each way."""
    body = Body(2)
    for inner, outer in zip(RADII, RADII[1:]):
        def place(across, along):
            r = inner + across * (outer - inner)
            angle = along * math.pi / 2
            return r * math.cos(angle), r * math.sin(angle)
        body.add_block((n, 9 * n), place)
    body.add_group("inner", lambda x, y: near(math.hypot(x, y), RADII[0]))
    body.add_group("x axis", lambda x, y: near(y, 0))
    body.add_group("y axis", lambda x, y: near(x, 0))
    return body


def rows(options, _):
    for formulation, ratios in EXPECTED.items():
        for poissons_ratio, expected in ratios.items():
            state = solve(options, {
                **material(YOUNGS_MODULUS, poissons_ratio), "Load/Pressures": "inner : 1",
                "Material/Formulation": formulation,
                "Support/Fixed components": "x axis : y; y axis : x"}, make_body())
            yield Row(f"u at the inside, ν = {poissons_ratio}, {formulation} formulation",
                      "5 × 9, plane strain", closed_form(poissons_ratio, RADII[0]),
                      state.at((RADII[0], 0), "ux"), .0001, expected=expected)
    # Linear elements have straight sides, and are of order 2.
    for element_type, n, bound in (("linear", 1, .02), ("linear", 4, .002),
                                   ("quadratic", 1, .0001)):
        state = solve(options, {
            **material(YOUNGS_MODULUS, .4999), "Load/Pressures": "inner : 1",
            "Body/Element type": element_type,
            "Support/Fixed components": "x axis : y; y axis : x"}, make_body(n))
        yield Row("u at the inside, ν = 0.4999, mixed formulation",
                  f"{5 * n} × {9 * n} {element_type}, plane strain",
                  closed_form(.4999, RADII[0]), state.at((RADII[0], 0), "ux"), bound)


    yield from plastic_rows(options)


def plastic_rows(options):
    """Plastic flow up to a radius c without hardening, of an incompressible body: the
    strain grows in proportion everywhere, so that one step is exact."""
    shear_limit = 1
    for c, n, bound in ((4.5, 1, .002), (4.5, 2, .0002), (6.75, 2, .0002)):
        inner, outer = RADII[0], RADII[-1]
        pressure = 2 * shear_limit * (math.log(c / inner) + (1 - (c / outer) ** 2) / 2)
        state = solve(options, {
            **material(YOUNGS_MODULUS, .4999), "Load/Pressures": f"inner : {pressure}",
            "Material/Yield stress": str(shear_limit * math.sqrt(3)),
            "Support/Fixed components": "x axis : y; y axis : x"}, make_body(n))
        yield Row(f"u at the inside, plastic flow up to the radius {c}",
                  f"{5 * n} × {9 * n}, plane strain",
                  shear_limit * c * c / (2 * YOUNGS_MODULUS / 3 * inner),
                  state.at((inner, 0), "ux"), bound)


CASE = Case(
    "cylinder", "Thick cylinder near incompressibility",
    "Lamé's closed form; MacNeal & Harder 1985; the ratios that are expected of the "
    "displacement formulation are an independent 20-node code's with 3 × 3 × 3 points; "
    "plastic flow without hardening: p = 2 k (ln(c/a) + (1 - c²/b²)/2) and k c²/(2 G a) for "
    "von Mises and an incompressible body", rows)
