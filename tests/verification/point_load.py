# SPDX-License-Identifier: LGPL-2.1-or-later
"""A force on a half space, away from the force."""

import math

from bodies import Body, near
from problems import Case, Row, material, solve

YOUNGS_MODULUS, POISSONS_RATIO, FORCE = 5, .3, 1
# A quarter of the half space up to the last of these, with elements that grow.
STEPS = [0, 1, 2, 3, 4, 5, 6, 8, 12, 20, 36, 68, 132, 260]


def closed_form(r):
    """Boussinesq's displacement of the surface."""
    return FORCE * (1 - POISSONS_RATIO ** 2) / (math.pi * YOUNGS_MODULUS * r)


def make_body():
    n = len(STEPS) - 1

    def at(s):
        i = min(int(s * n + 1e-9), n - 1)
        return STEPS[i] + (s * n - i) * (STEPS[i + 1] - STEPS[i])

    body = Body(3)
    body.add_block((n, n, n), lambda r, s, t: (at(r), at(s), -at(1 - t)))
    body.add_group("x", lambda x, y, z: near(x, 0))
    body.add_group("y", lambda x, y, z: near(y, 0))
    for axis, place in enumerate((STEPS[-1], STEPS[-1], -STEPS[-1])):
        body.add_group(f"far{axis}", lambda *p, a=axis, w=place: near(p[a], w))
    return body


def rows(options, _):
    body = make_body()
    state = solve(options, {
        **material(YOUNGS_MODULUS, POISSONS_RATIO), "Solver/Method": "direct",
        "Support/Fixed faces": "far0, far1, far2",
        "Support/Fixed components": "x : x; y : y",
        "Load/Nodal forces": f"{body.number((0, 0, 0))} : 0, 0, {-FORCE / 4}"}, body)
    # The far sides are held, where the half space moves a little: all of what is near
    # moves with it, and the difference does not.
    for near_by, far_off in ((6, 12), (8, 16), (10, 20)):
        yield Row(f"sinking at r = {near_by} less that at {far_off}", "13³, graded",
                  closed_form(near_by) - closed_form(far_off),
                  state.at((far_off, 0, 0), "uz") - state.at((near_by, 0, 0), "uz"), .01)


CASE = Case(
    "point_load", "Force on a half space, away from it",
    "Boussinesq's closed form; Johnson, Contact Mechanics, 1985", rows)
