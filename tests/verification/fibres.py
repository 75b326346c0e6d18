# SPDX-License-Identifier: LGPL-2.1-or-later
"""A bar of spruce that is pulled at an angle to its fibres."""

import math

from problems import Case, Row, solve

# Sitka spruce, L and T [MPa]; with the ultrasonic shear modulus.
ALONG, ACROSS, SHEAR, RATIO = 9050, 403, 1095, .467
PULL, LENGTH, HEIGHT, WIDTH = 40.3, 8, 2, 3


def closed_form(degrees, shear=SHEAR):
    """The modulus at an angle to the fibres [MPa]."""
    c, s = math.cos(math.radians(degrees)), math.sin(math.radians(degrees))
    return 1 / (c ** 4 / ALONG + s ** 4 / ACROSS +
                s * s * c * c * (1 / shear - 2 * RATIO / ALONG))


def modulus(options, degrees):
    """By the energy of a bar under uniform stress."""
    c, s = math.cos(math.radians(degrees)), math.sin(math.radians(degrees))
    state = solve(options, {
        "Material/Young's moduli": f"{ALONG}, {ACROSS}, {ACROSS}",
        "Material/Poisson's ratios": f"{RATIO}, 0.3, {RATIO * ACROSS / ALONG!r}",
        "Material/Shear moduli": f"{SHEAR}, 80, {SHEAR}",
        "Material/Axes": f"{c!r}, {s!r}, 0, {-s!r}, {c!r}, 0",
        "Body/Size": f"{LENGTH}, {HEIGHT}, {WIDTH}", "Body/Elements": "2, 1, 1",
        "Support/Fixed components": "left : x",
        "Support/Fixed boxes": f"0, 0, 0, 0, 0, 0 : yz; 0, {HEIGHT}, 0, 0, {HEIGHT}, 0 : z",
        "Load/Tractions": f"right : {PULL}, 0, 0"})
    volume = LENGTH * HEIGHT * WIDTH
    return PULL ** 2 * volume / (2 * float(state.line["strain_energy"]))


def rows(options, _):
    for degrees in (0, 10, 20, 30, 45, 60, 90):
        yield Row(f"modulus at {degrees}° to the fibres [MPa]", "2 × 1 × 1",
                  closed_form(degrees), modulus(options, degrees), 1e-6)


CASE = Case(
    "fibres", "Spruce, pulled at an angle to its fibres",
    "1/E = c⁴/E₁ + s⁴/E₂ + s²c² (1/G₁₂ − 2 ν₁₂/E₁), Lekhnitskii, Theory of Elasticity of an "
    "Anisotropic Elastic Body, 1963; constants of Sitka spruce: Acta Acustica 2025, "
    "aacus240113, table 5 (its G₁₂ by ultrasound), and ν₁₂ of the Wood Handbook, "
    "FPL-GTR-190", rows)
