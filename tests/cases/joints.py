# SPDX-License-Identifier: LGPL-2.1-or-later
"""I. Parts of a body that touch and are not joined, or by a line or a point only: a
warning says how many nodes and where; Body/Open joints refuses or allows them, and a
hinge that can turn is refused.

usage: joints.py PROGRAM
"""

import re

from cases import block, changed, folder, main, refused, right
from checks import event, pieces, warns, warns_not
from meshes import Mesh

SCENE = {
    "Body/File": "body.msh",
    "Load/Pressures": "lid: -0.1",
}
PLANE = {**SCENE, "Dimension": "2"}
HELD = {"Support/Fixed faces": "ground, lid", "Load/Pressures": ""}
WARN, REFUSE, ALLOW = ({"Body/Open joints": value}
                       for value in ("warn", "refuse", "allow"))
NAMED = "Open joints"
SILENT = warns_not(NAMED)
GLUE = folder("blocks_not_glued")
SLIT = folder("slit_of_double_nodes")
HINGE = re.compile(r"by the nodes? [\d, ]+ only, and free to move rigidly in \d")


def body(mesh, axis=2, low=0, high=2):
    mesh.face("ground", axis, low)
    mesh.face("lid", axis, high)
    return mesh.text()


def files(mesh, *values, scene=None, **more):
    merged = dict(scene or SCENE)
    for value in values:
        merged.update(value)
    case = block({**merged, **more})
    return {"scene.prm": case["scene.prm"], "body.msh": mesh}


def stack(elements, joined=lambda place: True, shift=0.0, upper=None):
    """Two cubes of 1 x 1 x 1, one on the other."""
    mesh = Mesh()
    mesh.box("lower", (0, 0, 0), (1, 1, 1), elements)
    mesh.box("upper", (0, 0, 1 + shift), (1, 1, 2), upper or elements, joined)
    return mesh


def two(begin, end, dimension=3, low=0, high=2):
    """Two cubes, the second of them anywhere."""
    mesh = Mesh(dimension)
    mesh.box("first", (0,) * dimension, (1,) * dimension, (1,) * dimension)
    mesh.box("second", begin, end, (1,) * dimension)
    return body(mesh, dimension - 1, low, high)


def in_part(name, number, place, mesh, *values, **more):
    """A body whose parts are joined in part: so many nodes are not, and where one
    of them is."""
    return right(name, files(mesh, *values, **more), warns(NAMED, rf"\b{number}\b", place))


JOINED = body(stack((2, 2, 2)))
ONE_OPEN = body(stack((2, 2, 2), lambda place: place != (0.5, 0.5, 1)))
CORNER_OPEN = body(stack((2, 2, 2), lambda place: place != (0, 0, 1)))
FINER = body(stack((2, 2, 2), upper=(4, 4, 4)))
# Nodes that round-off has moved.
NEARLY = body(stack((2, 2, 2), shift=1e-10))
APART = body(stack((2, 2, 2), shift=0.1))
LINE = two((1, 0, 1), (2, 1, 2))
POINT = two((1, 1, 1), (2, 2, 2))
CORNER = two((1, 1), (2, 2), 2)
# Side by side, and 1 x 1 quadrilaterals of which one node is there twice.
SHEET = Mesh(2)
SHEET.box("lower", (0, 0), (2, 1), (2, 1))
SHEET.box("upper", (0, 1), (2, 2), (2, 1), lambda place: place != (1, 1))
SHEET = body(SHEET, 1)
LIFTED = event("deform", max_displacement=0.2)
GLUED = event("deform", strain_energy=0.0025, reaction_z=0.05)
NOT_GLUED = (warns(NAMED, r"\b9\b", r"\b1\b"), event("deform", strain_energy=0))

CASES = [
    right("blocks that are glued", GLUE, GLUED, SILENT, scene="scene_glued.prm"),
    right("blocks that are not", GLUE, *NOT_GLUED),
    refused("their interface as a cut", GLUE, "without being joined", re.compile(r"\b9\b"),
            scene="scene_cut.prm"),
    refused("blocks that are not glued, refuse", changed(
        GLUE, "scene.prm", ("= file", "= file\n  set Open joints = refuse")),
            NAMED, re.compile(r"\b9\b")),
    right("blocks that are not glued, allow", changed(
        GLUE, "scene.prm", ("= file", "= file\n  set Open joints = allow")), SILENT,
          event("deform", strain_energy=0)),
    right("two cubes that are joined", files(JOINED), LIFTED, SILENT),
    in_part("a node that is not", 1, r"0\.5,? 0\.5,? 1\b", ONE_OPEN),
    in_part("a corner that is not", 1, r"0,? 0,? 1\b", CORNER_OPEN),
    in_part("nodes that round-off has moved", 9, "1", NEARLY, HELD),
    in_part("in the plane", 1, r"1,? 1\b", SHEET, scene=PLANE),
    right("a node that is not, warn", files(ONE_OPEN, WARN), warns(NAMED)),
    refused("a node that is not, refuse", files(ONE_OPEN, REFUSE), NAMED, "0.5"),
    right("a node that is not, allow", files(ONE_OPEN, ALLOW), SILENT),
    refused("in the plane, refuse", files(SHEET, REFUSE, scene=PLANE), NAMED),
    # Faces that lie on others with other nodes.
    right("4 x 4 faces on 2 x 2", files(FINER), warns(NAMED, r"\b(4|16|20)\b", "face")),
    refused("4 x 4 faces on 2 x 2, refuse", files(FINER, REFUSE), NAMED, "face"),
    right("4 x 4 faces on 2 x 2, allow", files(FINER, ALLOW), SILENT),
    # Joints by a line or a point.
    refused("two cubes on one line", files(LINE), HINGE),
    refused("two cubes on one line, allow", files(LINE, ALLOW), HINGE),
    refused("two cubes at one point", files(POINT), HINGE),
    refused("two squares at one point", files(CORNER, scene=PLANE), HINGE),
    right("a hinge that is held on both sides", files(LINE, HELD), warns(NAMED, "2 corners only", "hinge")),
    right("a hinge that is held on both sides, allow", files(LINE, HELD, ALLOW), SILENT),
    right("a point that is held on both sides", files(POINT, HELD),
          warns(NAMED, "1 corner only")),
    refused("a hinge that is held on both sides, refuse", files(LINE, HELD, REFUSE),
            NAMED),
    # What is no joint.
    right("parts that do not touch", files(APART, HELD), SILENT),
    refused("a part that nothing holds", files(APART), "free to move rigidly in 6 ways"),
    right("a slit that is meant", changed(
        SLIT, "scene.prm", ("= file", "= file\n  set Open joints = allow")), SILENT,
          pieces(4, 4)),
    right("a slit", SLIT, warns(NAMED, "2 places", r"1,? 1?\.?\d*,? 4|0,? 0,? 4"),
          pieces(4, 4)),
    right("the body without the slit", SLIT, SILENT, pieces(4, 4),
          scene="scene_whole.prm"),
    refused("a value that there is none of", files(JOINED, {"Body/Open joints": "weld"}),
            NAMED, "warn", "refuse", "allow"),
]

if __name__ == "__main__":
    main(CASES)
