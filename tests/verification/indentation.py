# SPDX-License-Identifier: LGPL-2.1-or-later
"""A rigid wedge without friction that presses on plastic ground: its force is the limit
load, which slip lines give, if the ground has the shape that they give it."""

import math
import pathlib
import tempfile

from plane_cut import PLANE, number
from problems import Case, Row, material, run_table

# The shear limit k is 1; almost rigid beside it, and almost incompressible.
YOUNGS_MODULUS, POISSONS_RATIO = 1000, .49
# Of the wedge's edge, and how much further it is pushed, where the force has levelled off.
DEPTH, PUSH = 1, .03
SIZE = 8


def slip_lines(angle):
    """Of a wedge of half angle `angle` [radians], at a depth of 1: the length of its
    flank's contact, which is that of the lip beside it too, the slope of the lip
    [radians], and the force over 2 k × depth."""
    low, high = 0, angle
    for _ in range(60):
        turn = (low + high) / 2
        if math.cos(2 * angle - turn) < math.cos(turn) / (1 + math.sin(turn)):
            low = turn
        else:
            high = turn
    slope = angle - turn
    length = 1 / (math.cos(angle) - math.sin(slope))
    return length, slope, 2 * length * math.sin(angle) * (1 + turn)


def ground(angle, n):
    """gmsh's description of ground with a groove that the wedge fills, and lips, meshed
    with n elements along a flank."""
    length, slope, _ = slip_lines(angle)
    tip = (length * math.sin(angle), length * math.cos(angle) - DEPTH)
    foot = tip[0] + length * math.cos(slope)
    fine, coarse = 2 * length / n, SIZE / 4
    points = [(0, -DEPTH, fine), (0, -DEPTH - 3 * length, 3 * fine), (0, -SIZE, coarse)]
    for side in (1, -1):
        points += [(side * SIZE, -SIZE, coarse), (side * SIZE, 0, coarse),
                   (side * 1.5 * foot, 0, 2 * fine), (side * foot, 0, fine),
                   (side * tip[0], tip[1], fine)]
    lines = ["Mesh.RecombineAll = 1; Mesh.SubdivisionAlgorithm = 1;",
             "Mesh.ElementOrder = 2; Mesh.SecondOrderIncomplete = 1; Mesh.Algorithm = 6;"]
    lines += [f"Point({i}) = {{{x!r}, {y!r}, 0, {h!r}}};"
              for i, (x, y, h) in enumerate(points, 1)]
    right, left = [1, 2, 3, *range(4, 9), 1], [1, 2, 3, *range(9, 14), 1]
    curves = {}
    for ring in (right, left):
        for pair in zip(ring, ring[1:]):
            if pair not in curves:
                curves[pair] = len(curves) + 1
                lines.append(f"Line({curves[pair]}) = {{{pair[0]}, {pair[1]}}};")
    for number_of_ring, (ring, sign) in enumerate(((right, 1), (left, -1)), 1):
        loop = [sign * curves[pair] for pair in zip(ring, ring[1:])][::sign]
        lines += [f"Curve Loop({number_of_ring}) = {{{', '.join(map(str, loop))}}};",
                  f"Plane Surface({number_of_ring}) = {{{number_of_ring}}};"]
    groups = {"cut": [(1, 2), (2, 3)], "bottom": [(3, 4), (3, 9)],
              "sides": [(4, 5), (9, 10)]}
    lines.append('Physical Surface("ground") = {1, 2};')
    for name, pairs in groups.items():
        members = ", ".join(str(curves[pair]) for pair in pairs)
        lines.append(f'Physical Curve("{name}") = {{{members}}};')
    return "\n".join(lines) + "\n"


def force(options, degrees, n):
    """Over 2 k × depth."""
    angle = math.radians(degrees)
    length, *_ = slip_lines(angle)
    with tempfile.TemporaryDirectory() as directory:
        file = pathlib.Path(directory) / "ground.geo"
        file.write_text(ground(angle, n))
        *_, line = run_table(options, {
            **PLANE, **material(YOUNGS_MODULUS, POISSONS_RATIO),
            "Body/Shape": "file", "Body/File": file, "Support/Fixed faces": "",
            "Support/Fixed components": "bottom : xy; sides : x",
            "Material/Yield stress": repr(math.sqrt(3)), "Material/Toughness": 1e9,
            "Blade/Shape": "wedge", "Blade/Wedge angle": 2 * degrees,
            "Blade/Thickness": repr(4 * length * math.sin(angle)),
            "Blade/Advance": PUSH / 6, "Blade/Travel": PUSH,
            # Open below the groove, so that the edge has nothing to push.
            "Cut/Surfaces": "group : cut", "Cut/Notch": repr(3 * length),
            "Division/Release": "face band"})
    return number(line, "blade_force") / (2 * DEPTH)


def rows(options, long):
    for degrees in (20, 30, 45):
        *_, expected = slip_lines(math.radians(degrees))
        for n, bound in ((6, .06), (16, .03)) if long else ((6, .06),):
            yield Row(f"force over 2 k c, half angle {degrees}°", f"{n} along a flank",
                      expected, force(options, degrees, n), bound)


CASE = Case(
    "indentation", "Wedge in plastic ground, without friction",
    "slip lines of a rigid and perfectly plastic body: Hill, Lee and Tupper, The theory of "
    "wedge indentation of ductile materials, Proceedings of the Royal Society A 188, 1947, "
    "from whose shape of groove and lips the computation begins", rows)
