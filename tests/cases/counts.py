# SPDX-License-Identifier: LGPL-2.1-or-later
"""O. What gmsh skips without a word: sections that are there twice, and counts that do
not fit, are refused by the section, and line, or are joined.

usage: counts.py PROGRAM
"""

import re

from cases import block, changed, folder, main, refused, right
from checks import event
from meshes import Mesh

LIFTED = event("deform", max_displacement=0.2)
SCENE = {"Body/File": "body.msh"}


def stack(begin=0):
    mesh = Mesh()
    mesh.box("block", (0, 0, begin), (1, 1, begin + 2), (1, 1, 2))
    mesh.face("ground", 2, begin)
    mesh.face("lid", 2, begin + 2)
    return mesh.text()


def files(mesh, **values):
    return {"scene.prm": block({**SCENE, **values})["scene.prm"], "body.msh": mesh}


TEXT = stack()
HEAD, NODES, ELEMENTS = (TEXT.partition("$Nodes")[0],
                         "$Nodes" + TEXT.partition("$Nodes")[2].partition("$El")[0],
                         "$Elements" + TEXT.partition("$Elements")[2])
# The file of version 4.1 that gmsh has written, with four counts in each header.
NEW = folder("partitioned_mesh")


def count(name, section, old, new):
    """A count of a section that does not fit."""
    return spoilt(name, f"${section}\n{old}\n", f"${section}\n{new}\n", f"${section}")


def spoilt(name, old, new, *words):
    return refused(name, changed(files(TEXT), "body.msh", (old, new)), "body.msh", *words)


def cut_off(name, mesh, section):
    return refused(name, files(mesh), "body.msh", f"${section}")


def twice(name, mesh, section):
    return refused(name, files(mesh), "body.msh", f"${section}",
                   "more than one section")


def newer(name, section, *changes):
    return refused(name, changed(NEW, "body_41.msh", *changes), "body_41.msh",
                   f"${section}", scene="scene_41.prm")


def halves(text):
    """A section of elements in two."""
    lines = text.splitlines()[2:-1]
    return "".join(f"$Elements\n{len(part)}\n" + "\n".join(part) + "\n$EndElements\n"
                   for part in (lines[:1], lines[1:]))


def header_of(section):
    """The counts of a section in the file of version 4.1, and of its first block."""
    lines = NEW["body_41.msh"].decode().partition(f"${section}\n")[2].splitlines()
    return lines[0], lines[1]


def less(line, place):
    words = line.split()
    words[place] = str(int(words[place]) - 1)
    return " ".join(words)


N_NODES, N_ELEMENTS = 12, 4
NODE_HEADER, NODE_BLOCK = header_of("Nodes")
ELEMENT_HEADER, ELEMENT_BLOCK = header_of("Elements")
CASES = [
    right("a file in order", files(TEXT), LIFTED),
    right("a comment behind the sections", files(
        TEXT + "$Comments\nmade by hand\n$EndComments\n"), LIFTED),
    right("blank lines at the end", files(TEXT + "\n\n  \n"), LIFTED),
    right("an unknown section", files(
        HEAD + "$Colours\n3\n1 2 3\n$EndColours\n" + NODES + ELEMENTS), LIFTED),
    # Counts of version 2.2.
    count("fewer nodes than there are", "Nodes", N_NODES, N_NODES - 1),
    count("more nodes than there are", "Nodes", N_NODES, N_NODES + 1),
    count("fewer elements than there are", "Elements", N_ELEMENTS, N_ELEMENTS - 1),
    count("half of the elements", "Elements", N_ELEMENTS, N_ELEMENTS // 2),
    count("more elements than there are", "Elements", N_ELEMENTS, N_ELEMENTS + 1),
    count("no elements", "Elements", N_ELEMENTS, 0),
    count("fewer names than there are", "PhysicalNames", 3, 2),
    count("more names than there are", "PhysicalNames", 3, 4),
    count("a count that is none", "Elements", N_ELEMENTS, "four"),
    count("a negative count", "Nodes", N_NODES, -12),
    # Lines with too few or too many numbers.
    spoilt("an element that lacks a node", "3 3 9 10 11 12\n", "3 3 9 10 11\n", "$Elements"),
    spoilt("an element with a node too many", "3 3 9 10 11 12\n", "3 3 9 10 11 12 1\n",
           "$Elements"),
    spoilt("a node that lacks a coordinate", "\n11 1.0 1.0 2.0", "\n11 1.0 2.0", "$Nodes"),
    spoilt("a node with a coordinate too many", "\n11 1.0 1.0 2.0", "\n11 1.0 1.0 2.0 0",
           "$Nodes"),
    # Sections that are there twice.
    twice("elements twice", TEXT + ELEMENTS, "Elements"),
    twice("elements in two sections", HEAD + NODES + halves(ELEMENTS), "Elements"),
    twice("nodes twice", HEAD + NODES + NODES + ELEMENTS, "Nodes"),
    twice("names twice", HEAD + HEAD.partition("$EndMeshFormat\n")[2] + NODES + ELEMENTS,
          "PhysicalNames"),
    twice("two files in one", TEXT + stack(2), ""),
    twice("a format twice", "$MeshFormat\n2.2 0 8\n$EndMeshFormat\n" + TEXT,
          "MeshFormat"),
    # Sections that do not end, or are not there.
    cut_off("no end of the elements", TEXT.replace("$EndElements\n", ""), "Elements"),
    cut_off("no end of the nodes", TEXT.replace("$EndNodes\n", ""), "Nodes"),
    spoilt("an end in the midst", "\n6 1.0", "\n$EndNodes\n6 1.0", "$Nodes"),
    cut_off("no nodes", HEAD + ELEMENTS, "Nodes"),
    cut_off("no elements at all", HEAD + NODES, "Elements"),
    cut_off("elements in front of the nodes", HEAD + ELEMENTS + NODES, "Elements"),
    # Numbers that are there twice.
    spoilt("a number of two nodes", "\n2 1.0", "\n1 1.0", "node 1 "),
    spoilt("a number of two elements", "\n2 5 2", "\n1 5 2", "element 1 "),
    # Version 4.1.
    right("a file of version 4.1", NEW, event("deform", max_displacement=0.2),
          scene="scene_41.prm"),
    newer("4.1: fewer nodes", "Nodes", (NODE_HEADER, less(NODE_HEADER, 1))),
    newer("4.1: fewer blocks of nodes", "Nodes", (NODE_HEADER, less(NODE_HEADER, 0))),
    newer("4.1: fewer elements", "Elements", (ELEMENT_HEADER, less(ELEMENT_HEADER, 1))),
    newer("4.1: fewer blocks of elements", "Elements",
          (ELEMENT_HEADER, less(ELEMENT_HEADER, 0))),
    newer("4.1: a block with fewer elements", "Elements",
          (f"{ELEMENT_HEADER}\n{ELEMENT_BLOCK}",
           f"{ELEMENT_HEADER}\n{less(ELEMENT_BLOCK, 3)}")),
    newer("4.1: two sections", "Elements", ("$Elements\n", "$Elements\n1 1 1 1\n3 1 5 1\n"
                                            "1 1 2 3 4 5 6 7 8\n$EndElements\n$Elements\n")),
]

if __name__ == "__main__":
    main(CASES)
