# SPDX-License-Identifier: LGPL-2.1-or-later
"""F. Where a surface passes through the centers of elements they go to one side, all
of them, however the body lies in space; a warning says that such a cut is flat, and
that another one is stepped.

usage: ties.py PROGRAM
"""

import math

from cases import box, main, right
from checks import pieces, warns, warns_not

# 3 x 5 elements: the plane x = 1.5 is in the middle of the second column.
PLATE = {
    "Body/Size": "3, 5, 1",
    "Body/Elements": "3, 5, 1",
    "Support/Fixed faces": "front",
    "Blade/Sharpness": "1",
}
PLANE = {**PLATE, "Dimension": "2", "Body/Size": "3, 5", "Body/Elements": "3, 5",
         "Support/Fixed faces": "bottom", "Blade/Direction": "0, -1"}
CENTER, NORMAL = (1.5, 2.5, 0.5), (1, 0, 0)
AXES = {"x": (1, 2), "y": (2, 0), "z": (0, 1)}
FLAT = (warns("flat"), warns_not("stepped"))
STEPPED = (warns("stepped"), warns_not("flat"))
FOLLOWED = (warns_not("flat|stepped"),)


def turned(vector, rotations):
    """A vector turned about axes in turn, by degrees."""
    result = list(vector)
    for axis, angle in rotations:
        i, j = AXES[axis]
        c, s = math.cos(math.radians(angle)), math.sin(math.radians(angle))
        result[i], result[j] = (c * result[i] - s * result[j],
                                s * result[i] + c * result[j])
    return result


def numbers(vector):
    return ", ".join(repr(value) for value in vector)


def plane(point, normal):
    return f"plane : {numbers(point)} ; {numbers(normal)}"


def in_space(*rotations, shift=(0, 0, 0), normal=NORMAL, scale=1):
    """The plate cut at x = 1.5, after it has been moved."""
    point = [scale * value for value in CENTER]
    point = [a + b for a, b in zip(turned(point, rotations), shift)]
    values = {
        **PLATE,
        "Body/Scale": repr(scale),
        "Body/Rotate": "; ".join(f"{axis}: {angle}" for axis, angle in rotations),
        "Body/Translate": numbers(shift),
        "Blade/Direction": numbers(turned((0, 0, -1), rotations)),
        "Cut/Surfaces": plane(point, turned(normal, rotations)),
    }
    return right(f"turned {rotations}, moved {shift}, normal {normal}, x {scale}",
                 box(values), pieces(5, 10), *FLAT)


def by(surface, expected, warnings, scene=None, **more):
    values = {**(scene or PLATE), "Cut/Surfaces": surface, **more}
    return right(surface, box(values), pieces(*expected), *warnings)


CASES = [
    *(in_space(("z", angle)) for angle in (0, 30, 45, 77, 90, -120, 180)),
    in_space(("x", 25), ("y", 50)),
    in_space(("y", 33), ("z", -71), ("x", 10)),
    in_space(("z", 30), shift=(1e4, -3e4, 0.1)),
    in_space(("z", 30), normal=(-1, 0, 0)),
    in_space(("z", 30), scale=0.1),
    in_space(("z", 12), scale=1e5),
    # Not parallel to an axis of the body, but for round-off.
    in_space(normal=(1, 1e-15, -1e-15)),
    by("where : x - 1.5", (5, 10), FLAT),
    by("where : 1.5 - x", (5, 10), FLAT),
    by("where : 0.1*x - 0.15", (5, 10), FLAT),
    by("where : x - 1.5", (5, 10), FLAT, PLANE),
    by("plane : 1.5, 0 ; 3, 0", (5, 10), FLAT, PLANE),
    by("where : y - 2.5", (6, 9), FLAT, **{"Support/Fixed faces": "left"}),
    # Off the centers, and between the elements.
    by("plane : 1.4, 0, 0 ; 1, 0, 0", (5, 10), FLAT),
    by("plane : 1.6, 0, 0 ; 1, 0, 0", (10, 5), FLAT),
    by("plane : 1, 0, 0 ; 1, 0, 0", (5, 10), FOLLOWED),
    by("x:1", (5, 10), FOLLOWED),
    # Slanted, and through centers of some elements.
    by("plane : 1.5, 2.5, 0 ; 2, -1, 0", (6, 9), STEPPED),
    by("plane : 1.5, 2.4, 0 ; 1, 0.3, 0", (7, 8), STEPPED),
    by("plane : 1.5, 2.4 ; 1, 0.3", (7, 8), STEPPED, PLANE),
]

if __name__ == "__main__":
    main(CASES)
