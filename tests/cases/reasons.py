# SPDX-License-Identifier: LGPL-2.1-or-later
"""N. Meshes that cannot be used are refused with the reason and a way out: surfaces
without a volume, quarter points, prisms, nodes numbered from 0, the order of VTK.

usage: reasons.py PROGRAM
"""

import re

from cases import BLOCK, block, changed, folder, main, refused, right
from checks import event, lacks
from meshes import Mesh

SURFACES = folder("only_surfaces")
QUARTERS = folder("quarter_points")
VTK = folder("order_of_vtk")
PRISMS = folder("prisms_at_the_axis")
LIFTED = event("deform", max_displacement=0.2)
WAY_OUT = re.compile(r"Physical Volume.*Mesh\.SaveAll|Mesh\.SaveAll.*Physical Volume")
SUBDIVIDED = b"\nMesh.SubdivisionAlgorithm = 2;\n"
SCENE = {"Body/File": "body.msh"}


def from_zero(text):
    """The mesh with all numbers of nodes less by 1."""
    lines = text.splitlines()
    nodes, elements = lines.index("$Nodes"), lines.index("$Elements")
    for i, line in enumerate(lines):
        words = line.split()
        if nodes + 1 < i < elements - 1:
            words[0] = str(int(words[0]) - 1)
        elif elements + 1 < i < len(lines) - 1:
            words[5:] = [str(int(word) - 1) for word in words[5:]]
        lines[i] = " ".join(words)
    return "\n".join(lines) + "\n"


def stack():
    mesh = Mesh()
    mesh.box("block", (0, 0, 0), (1, 1, 2), (1, 1, 2))
    mesh.face("ground", 2, 0)
    mesh.face("lid", 2, 2)
    return mesh.text()


def with_scene(mesh, **values):
    return {"scene.prm": block({**SCENE, **values})["scene.prm"], "body.msh": mesh}


ZERO = from_zero(stack())
CASES = [
    refused("surfaces without a volume", SURFACES, "body.msh", WAY_OUT),
    right("the same from the geometry", SURFACES, event(
        "deform", max_displacement=0.2), scene="scene_geo.prm"),
    refused("a geometry without a volume", block(
        {"Support/Fixed faces": "5"}, BLOCK[: BLOCK.index("v[]")]),
            "no elements of dimension 3", "4 of Quadrilateral 4", "body.geo"),
    refused("a mesh of two dimensions in three", {
        **SURFACES, "body.msh": SURFACES["body.msh"].replace(b"2 6 ", b"2 7 ")},
            "2 of Quadrilateral 4", WAY_OUT),
    refused("a file of points only", with_scene(
        stack().partition("$Elements")[0] + "$Elements\n0\n$EndElements\n"),
            "no elements"),
    # Middle nodes of lines.
    refused("quarter points", QUARTERS, "quarter", re.compile(r"node (29|30|31|32)\b"),
            lacks("flat or inverted")),
    right("nearly quarter points", QUARTERS, LIFTED, scene="scene_near.prm"),
    refused("quarter points at the other end", changed(
        QUARTERS, "body.msh", ("1.25", "1.75")), "quarter", "node",
            lacks("flat or inverted")),
    refused("one quarter point", changed(
        QUARTERS, "body.msh", *((f"{n} {x} 1.25", f"{n} {x} 1.5") for n, x in (
            (30, "1.0 0.0"), (31, "1.0 1.0"), (32, "0.0 1.0")))), "quarter", "node 29"),
    refused("the order of VTK", VTK, re.compile(r"node \d+ of element 3"), "VTK"),
    # Elements of other kinds.
    refused("prisms at the axis", PRISMS, re.compile(r"\b2\b.*[Pp]rism"),
            re.compile(r"Mesh\.SubdivisionAlgorithm = 2|block")),
    refused("prisms by triangles", PRISMS, re.compile(r"\d+.*[Pp]rism"),
            "Mesh.SubdivisionAlgorithm = 2", scene="scene_triangles.prm"),
    *(right(f"{scene} subdivided", {
        **PRISMS, f"{body}.geo": PRISMS[f"{body}.geo"] + SUBDIVIDED}, scene=f"{scene}.prm")
      for scene, body in (("scene", "body"), ("scene_triangles", "body_triangles"))),
    refused("tetrahedra", block(geometry=BLOCK.replace("Recombine; ", "")),
            re.compile("[Tt]etrahedr"), "Recombine"),
    refused("triangles in two dimensions", block(
        {"Dimension": "2", "Support/Fixed faces": "l", "Load/Pressures": ""},
        BLOCK[: BLOCK.index("v[]")].replace("Recombine; ", "")
        + 'Physical Surface("s") = {s[1]};\nPhysical Curve("l") = {l[1]};\n'),
            re.compile("[Tt]riangle"), "Recombine"),
    # Numbers from 0.
    right("numbers from 1", with_scene(stack()), LIFTED),
    refused("numbers from 0", with_scene(ZERO), "body.msh", "node 0", "from 1"),
    refused("one number that is 0", with_scene(stack().replace("\n8 ", "\n0 ", 1)),
            "body.msh", "0"),
    refused("a number that is negative", with_scene(stack().replace("\n8 ", "\n-8 ", 1)),
            "body.msh", "-8"),
]

if __name__ == "__main__":
    main(CASES)
