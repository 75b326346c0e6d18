# SPDX-License-Identifier: LGPL-2.1-or-later
"""Seven distorted hexahedra under constant stress.

The vertices are those of MacNeal and Harder but for the fifth, whose y is .186 there:
the Jacobian of an element is negative at that corner, and the program refuses such a
body. The test element/patch_macneal_harder solves the published mesh.
"""

from bodies import CORNERS, Body, near
from problems import Case, Row, material, solve

INNER = [(.249, .342, .192), (.826, .288, .288), (.850, .649, .263), (.273, .750, .230),
         (.320, .286, .643), (.677, .305, .683), (.788, .693, .644), (.165, .745, .702)]
NORMAL, SHEAR = 2000, 400


def make_body():
    """The inner hexahedron, and one between each of its faces and the cube's."""
    body = Body(3)
    body.add_element(INNER)
    for axis in range(3):
        for side in (0, 1):
            points = []
            for corner in CORNERS[3]:
                # Where the cell has its outer side a corner is that of the cube.
                outer = list(corner)
                outer[axis] = side
                is_outer = corner[axis] == side
                points.append(tuple(outer) if is_outer
                              else INNER[CORNERS[3].index(tuple(outer))])
            body.add_element(points)
            body.add_group(f"face{axis}{side}",
                           lambda *p, a=axis, s=side: near(p[a], s))
    body.add_point("origin", (0, 0, 0))
    body.add_point("x", (1, 0, 0))
    body.add_point("y", (0, 1, 0))
    return body


def displacement(p):
    return [1e-3 * (sum(p) + p[c]) / 2 for c in range(3)]


def rows(options, _):
    tractions = []
    for axis in range(3):
        stress = [NORMAL if c == axis else SHEAR for c in range(3)]
        for side, sign in ((0, -1), (1, 1)):
            tractions.append(f"face{axis}{side} : " +
                             ", ".join(str(sign * s) for s in stress))
    for element_type in ("linear", "serendipity", "quadratic"):
        yield from rows_of_type(options, element_type, tractions)


def rows_of_type(options, element_type, tractions):
    ux, uy = displacement((1, 0, 0)), displacement((0, 1, 0))
    state = solve(options, {
        **material(1e6, .25), "Body/Element type": element_type,
        "Support/Displacements": "origin : 0, 0, 0; "
        f"x : free, {ux[1]}, {ux[2]}; y : free, free, {uy[2]}",
        "Load/Tractions": "; ".join(tractions)}, make_body())

    def farthest(column, expected):
        """The value that is farthest from what is expected."""
        return max((float(node[column]) for node in state.nodes),
                   key=lambda value: abs(value - expected))

    mesh = f"7 {element_type}, one vertex moved"
    for column, expected in (("sxx", NORMAL), ("syz", SHEAR)):
        yield Row(f"{column}, the node that is farthest off", mesh, expected,
                  farthest(column, expected), 1e-9)
    node = max(state.nodes, key=lambda n: abs(float(n["uz"]) - displacement(n["p"])[2]))
    corner = displacement((1, 1, 1))[2]
    yield Row("w at (1, 1, 1), off by the largest error of all nodes", mesh, corner,
              corner + float(node["uz"]) - displacement(node["p"])[2], 1e-9)


CASE = Case(
    "patch", "Patch test for solids: constant tractions on the cube's faces",
    "MacNeal & Harder, A proposed standard set of problems to test finite element "
    "accuracy, Finite Elements in Analysis and Design 1, 1985. In the published mesh an "
    "element's Jacobian is negative at a corner, and the program refuses it: here one "
    "vertex is moved, and the published mesh and boundary displacement are the unit test "
    "tests/element/patch_macneal_harder, which passes to 10⁻⁹", rows)
