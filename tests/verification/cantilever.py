# SPDX-License-Identifier: LGPL-2.1-or-later
"""A double cantilever beam: a strip that is cut along its middle from one end, and
pulled open there."""

import dataclasses

from bodies import Body, near
from problems import Case, Row, material, solve, solve_all

ARM, LENGTH, CRACK = 1, 24, 10
YOUNGS_MODULUS, POISSONS_RATIO, FORCE = 1000, .3, 1
# Elements through an arm: how far the ratio to beam theory may be from 1, and what an
# independent code's crack closure is of its own dC/da.
MESHES = {1: (.025, .9955), 2: (.012, .9989), 4: (.007, .9997)}


def theory(crack):
    """Compliance by beam theory, the arms longer by what the uncut strip gives way."""
    plane = YOUNGS_MODULUS / (1 - POISSONS_RATIO ** 2)
    return 8 * (crack + .673 * ARM) ** 3 / (plane * ARM ** 3)


@dataclasses.dataclass
class Opened:
    """The strip with a cut of some length."""

    compliance: float
    potential_energy: float
    # What the program's criterion says that the next row of elements would release.
    released_next: float


def cut_strip(options, n):
    """The strip at each length of its cut, a row of elements after the other."""
    nx, ny = LENGTH * n, 2 * ARM * n
    top = ny * (2 * nx + 1) + ny * (nx + 1)
    states = solve_all(options, {
        "Dimension": 2, "Body/Size": f"{LENGTH}, {2 * ARM}",
        "Body/Elements": f"{nx}, {ny}", **material(YOUNGS_MODULUS, POISSONS_RATIO),
        "Material/Toughness": 1e-9, "Support/Fixed faces": "right",
        "Load/Nodal forces": f"0 : 0, {-FORCE}; {top} : 0, {FORCE}",
        "Cut/Surfaces": f"y:{n}", "Cut/Extent": f"depth : {CRACK + 2}",
        "Blade/Direction": "1, 0", "Blade/Edge loads": "0:0",
        "Yield/Criterion": "energy release", "Division/Split rows": "free",
        "Division/Release": "element row"})
    return {float(state.line["depth"]): Opened(
        (state.at((0, 2 * ARM), "uy") - state.at((0, 0), "uy")) / FORCE,
        float(state.line["potential_energy"]), float(state.line["cutting_stress"]))
        for state in states}


def clamp_force(options, n, group, free):
    """The force of the symmetry on a group of nodes of the upper arm, and the state;
    `free` are the intervals of the middle line ahead that other supports hold.

    A clamp that moves has a column of its own, so this one moves, by next to nothing.
    """
    body = Body(2)
    body.add_block((LENGTH * n, ARM * n), lambda s, t: (LENGTH * s, ARM * t))
    body.add_group("right", lambda x, y: near(x, LENGTH))
    front, ahead = CRACK, CRACK + 1 / n
    body.add_group("first", lambda x, y: near(y, 0) and front - 1e-7 < x < ahead + 1e-7)
    body.add_point("front", (front, 0))
    body.add_point("next", (ahead, 0))
    boxes = "; ".join(f"{x}, 0, {end}, 0 : y" for x, end in free)
    state = solve(options, {
        **material(YOUNGS_MODULUS, POISSONS_RATIO), "Support/Fixed faces": "right",
        "Support/Fixed boxes": boxes, "Support/Displacements": f"{group} : free, 1e-30",
        "Load/Nodal forces": f"{body.number((0, ARM))} : 0, {FORCE}"}, body)
    return float(state.line["clamp_y"]), state


def crack_closure(options, n):
    """The energy release rate from the forces on the first nodes ahead of the front
    and the opening of the first ones behind it: corner by corner, middle by middle."""
    step = 1 / n
    small = step / 8
    end, front, ahead = LENGTH - small, CRACK, CRACK + step
    first, state = clamp_force(options, n, "first", [(ahead + small, end)])
    corner, _ = clamp_force(options, n, "front", [(front + small, end)])
    last, _ = clamp_force(options, n, "next", [(front, ahead - small),
                                               (ahead + small, end)])
    middle = first - corner - last
    # Each arm opens by half: both together, over twice the length.
    return -(corner * state.at((front - step, 0), "uy") +
             middle * state.at((front - step / 2, 0), "uy")) / step


def rows(options, long):
    for n, (bound, closure) in MESHES.items():
        if n > 2 and not long:
            continue
        step = 1 / n
        strip = cut_strip(options, n)
        shorter, present, longer = (strip[CRACK + i * step] for i in (-1, 0, 1))
        mesh = f"{n} through an arm, plane strain"
        rate = (longer.compliance - shorter.compliance) / (2 * step)
        beam = (theory(CRACK + step) - theory(CRACK - step)) / (2 * step)
        yield Row("dC/da", mesh, beam, rate, bound)
        # G = P² / 2 dC/da from the opening, and - dΠ/da from the energy.
        released = FORCE ** 2 / 2 * rate
        yield Row("energy released, by energies over by opening", mesh, released,
                  (shorter.potential_energy - longer.potential_energy) / (2 * step), 1e-7)
        yield Row("energy released, by the criterion over by opening", mesh,
                  FORCE ** 2 / 2 * (longer.compliance - present.compliance) / step,
                  present.released_next, 1e-7)
        yield Row("energy released, by crack closure over by opening", mesh, released,
                  crack_closure(options, n), .0001, expected=closure)


CASE = Case(
    "cantilever", "Double cantilever beam, the cut made row by row",
    "beam theory, C = 8 (a + 0.673 h)³ / (E' h³), where 0.673 h is what the uncut strip "
    "gives way, of which an independent 20-node code with 2 × 2 points finds 0.984, 0.992 "
    "and 0.996; crack closure as in Krueger, NASA/CR-2002-211628, whose ratios are that "
    "code's", rows)
