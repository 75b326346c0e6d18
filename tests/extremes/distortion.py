# SPDX-License-Identifier: LGPL-2.1-or-later
"""Bodies whose elements are sheared or tapered, up to where their Jacobian is not
positive any more. A pressure from all sides strains them by a displacement that is
linear in position, which all elements hold."""

import pathlib
import sys

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parents[1] / "verification"))
from bodies import CORNERS, Body, near


class Shape:
    """A unit cube that is mapped by `place`; `back` is the inverse."""

    def __init__(self, place, back):
        self.place, self.back = place, back

    def body(self):
        body = Body(3)
        body.add_block((2, 2, 2), self.place, straight=True)
        for axis in range(3):
            for side in (0, 1):
                body.add_group(f"face{axis}{side}", lambda *p, a=axis, s=side:
                               near(self.back(*p)[a], s))
        for name, point in (("origin", (0, 0, 0)), ("x", (1, 0, 0)), ("y", (0, 1, 0))):
            body.add_point(name, self.place(*point))
        return body


def sheared(shear):
    return Shape(lambda x, y, z: (x + shear * z, y, z),
                 lambda x, y, z: (x - shear * z, y, z))


def tapered(top):
    """A frustum whose top edges are so long; at 0 it is a pyramid."""
    def scale(z):
        return 1 - (1 - top) * z
    return Shape(lambda x, y, z: (0.5 + (x - 0.5) * scale(z), 0.5 + (y - 0.5) * scale(z), z),
                 lambda x, y, z: (0.5 + (x - 0.5) / scale(z), 0.5 + (y - 0.5) / scale(z), z))


def pushed_corner(factor):
    """One element, of which a corner is pushed along the diagonal towards the opposite
    one: at 1/3 it lies in the plane of its neighbours."""
    body = Body(3)
    corners = [tuple(map(float, c)) for c in CORNERS[3]]
    corners[CORNERS[3].index((1, 1, 1))] = (1 - factor,) * 3
    body.add_element(corners)
    for name, axis in (("left", 0), ("front", 1), ("bottom", 2)):
        body.add_group(name, lambda *p, a=axis: near(p[a], 0))
    return body


def cases(table, run, accepted, refusal, make_directory):
    """`run` makes a run of settings in a directory."""
    def settings_of(directory, body, more):
        body.write(pathlib.Path(directory.name) / "body.msh")
        return {"Body/Shape": "file", "Body/File": "body.msh", "Output/Frames": "none",
                "Output/Node tables": "true", "Material/Young's modulus": "5",
                "Material/Poisson's ratio": "0.3", **more}

    def error(shape, must_warn=False):
        directory = make_directory()
        result = accepted(run(settings_of(directory, shape.body(), {
            "Load/Pressures": "; ".join(f"face{a}{s} : 1" for a in range(3) for s in (0, 1)),
            "Support/Displacements": "origin : 0, 0, 0; x : free, 0, 0; "
            "y : free, free, 0"}), directory=directory))
        nodes = result.displacements(1).values()
        origin = shape.place(0, 0, 0)
        strain = -(1 - 2 * 0.3) / 5
        worst = largest = 0
        for *position, ux, uy, uz in nodes:
            exact = [strain * (p - o) for p, o in zip(position, origin)]
            worst = max(worst, *(abs(a - b) for a, b in zip((ux, uy, uz), exact)))
            largest = max(largest, *map(abs, exact))
        if must_warn and "digits are lost" not in result.output:
            raise AssertionError("no word of lost digits")
        return worst / largest

    for shear in (1.0, 10.0):
        table.add("sheared elements", f"by {shear:g} times their height",
                  "uniform stress, closed form", lambda: error(sheared(shear)), 1e-6)
    table.add("sheared elements", "by 100 times their height, 10^4 times as long as thick",
              "uniform stress, closed form, with a warning of lost digits",
              lambda: error(sheared(100.0), must_warn=True), 1e-1)
    for top in (0.1, 1e-3):
        table.add("tapered elements", f"frustum, top edge {top:g}",
                  "uniform stress, closed form", lambda: error(tapered(top)), 1e-6)

    def push(factor):
        directory = make_directory()
        return run(settings_of(directory, pushed_corner(factor), {
            "Support/Fixed components": "bottom : z; left : x; front : y",
            "Load/Body force": "0, 0, -0.1"}), directory=directory)

    table.add("a corner of an element", "pushed by 0.333 of the diagonal", "accepted",
              lambda: float(accepted(push(0.333)).status), 0)
    for factor in (0.334, 1.5):
        table.add("a corner of an element", f"pushed by {factor:g} of the diagonal",
                  "refusal", lambda: refusal(push(factor)))
    table.add("tapered elements", "frustum, top edge 1e-06", "refusal", lambda: refusal(run(
        settings_of(directory := make_directory(), tapered(1e-6).body(), {}),
        directory=directory)))
