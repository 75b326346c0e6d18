# SPDX-License-Identifier: LGPL-2.1-or-later
"""D. A number that is no node of the model is refused by its name, as a load and as a
support: middle nodes of linear elements, nodes of a file that belong to no element,
and those that elements leave out.

usage: nodes.py PROGRAM
"""

import re

from cases import block, box, changed, folder, main, refused, right
from checks import event

CUBE = {
    "Body/Size": "1, 1, 1",
    "Body/Elements": "1, 1, 1",
    "Body/Element type": "linear",
    "Material/Young's modulus": "1",
    "Material/Poisson's ratio": "0",
    "Support/Fixed faces": "bottom",
}
SQUARE = {**CUBE, "Dimension": "2", "Body/Size": "1, 1", "Body/Elements": "1, 1"}
# Pulled at all corners of the top by 0.1 altogether.
PULLED = "12 : 0, 0, 0.025; 14 : 0, 0, 0.025; 17 : 0, 0, 0.025; 19 : 0, 0, 0.025"
LIFTED = event("deform", max_displacement=0.1, reaction_z=-0.1)
FOLDER = folder("force_on_no_node")
# The geometry that the block's file is made of, as elements of 27 nodes.
WHOLE = block()["body.geo"] + "Mesh.ElementOrder = 2;\n"
# The file has such a node; a message must not say that it has none.
OF_NO_ELEMENT = re.compile("element|model|middle")
SPARSE = folder("sparse_numbers")


def on_cube(path, value, number, scene=None):
    """A node of a box that is none."""
    return refused(f"{path} = {value}", box({**(scene or CUBE), path: value}),
                   path.rpartition("/")[2], f"node {number}")


def node_numbers(first, last):
    return ", ".join(str(n) for n in range(first, last + 1))


CASES = [
    refused("a force on a node of no element", FOLDER, "'Nodal forces'", "node 9"),
    refused("a fixed node of no element", FOLDER, "'Fixed nodes'", "node 9",
            scene="scene_fixed.prm"),
    # The file itself is fine, whatever other nodes it has.
    right("a node of no element that is not used",
          changed(FOLDER, "scene.prm", ("9 :", "5 :")),
          event("deform", reaction_z=1)),
    right("a far node of no element", changed(
        changed(FOLDER, "scene.prm", ("9 :", "5 :")), "body.msh",
        ("9 0.5 0.5 5.0", "900 0.5 0.5 1e30")), event("deform", reaction_z=1)),
    refused("a number of no node at all", changed(FOLDER, "scene.prm", ("9 :", "99 :")),
            "'Nodal forces'", "99"),
    refused("one of many numbers", changed(
        FOLDER, "scene.prm", ("9 :", "5 : 0, 0, -1; 9 :")), "node 9"),
    # Linear elements have the nodes at their corners.
    on_cube("Load/Nodal forces", "13 : 0, 0, -1", 13),
    on_cube("Support/Fixed nodes", "13", 13),
    on_cube("Support/Fixed nodes", "0, 2, 5, 8", 8),
    on_cube("Load/Nodal forces", "3 : 0, -1", 3, SQUARE),
    on_cube("Support/Fixed nodes", "0, 1", 1, SQUARE),
    refused("a middle node of a file as linear elements", changed(
        folder("quarter_points"), "scene_near.prm",
        ("= file", "= file\n  set Element type = linear"),
        ("Pressures = top: -0.1", "Nodal forces = 17 : 0, 0, 1")), "node 17",
            scene="scene_near.prm"),
    right("all corners of a linear cube", box({**CUBE, "Load/Nodal forces": PULLED}),
          LIFTED),
    right("corners that hold a linear cube", box(
        {**CUBE, "Support/Fixed faces": "", "Support/Fixed nodes": "0, 2, 5, 7",
         "Load/Nodal forces": PULLED}), LIFTED),
    right("middle nodes of a serendipity cube", box(
        {**CUBE, "Body/Element type": "serendipity", "Support/Fixed nodes": "1, 3, 4",
         "Load/Nodal forces": "13 : 0, 0, 0.1"}), event("deform", reaction_z=-0.1)),
    # Nodes in the middle of faces and of elements are left out.
    *(refused(f"node {number} of 27-node elements", block(
        {"Load/Nodal forces": f"{number} : 0, 0, 1", "Load/Pressures": ""}, WHOLE),
              OF_NO_ELEMENT) for number in (66, 125)),
    refused("a fixed one of them", block({"Support/Fixed nodes": "125"}, WHOLE),
            "'Fixed nodes'", "125", OF_NO_ELEMENT),
    right("numbers with gaps", SPARSE, event("deform", max_displacement=0.2,
                                             reaction_z=-0.1)),
    refused("a number in a gap", changed(SPARSE, "scene.prm", ("= 460175074", "= 8")),
            "'Fixed nodes'", "8"),
]

if __name__ == "__main__":
    main(CASES)
