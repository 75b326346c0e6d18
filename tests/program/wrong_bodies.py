# SPDX-License-Identifier: LGPL-2.1-or-later
"""Bodies from files that cannot be used, and cuts that cannot be made through
them: wrong_bodies.py PROGRAM

What reading refuses is tested in tests/body/gmsh_refusals; here it is that the
program says it in one sentence and writes nothing.
"""

import sys

from program_cases import SCENE, Case, run_cases, scene_text, wrong_value

# A block of 4 x 4 x 2 hexahedra with its groups.
GEOMETRY = """
Point(1) = {0, 0, 0};
l[] = Extrude {4, 0, 0} { Point{1}; Layers{4}; };
s[] = Extrude {0, 4, 0} { Curve{l[1]}; Layers{4}; Recombine; };
v[] = Extrude {0, 0, 2} { Surface{s[1]}; Layers{2}; Recombine; };
Physical Volume("block", 1) = {v[1]};
Physical Surface("ground", 2) = {s[1]};
Physical Surface("lid", 3) = {v[0]};
"""

# A surface that gmsh cannot mesh, in one of its threads, out of which it must not
# throw, whatever the file asks for.
OPEN_LOOP = """
General.AbortOnError = 2;
Point(1) = {0, 0, 0};
Point(2) = {1, 0, 0};
Point(3) = {1, 1, 0};
Point(4) = {0, 1, 0};
Line(1) = {1, 2};
Line(2) = {2, 3};
Line(3) = {3, 4};
Line(4) = {4, 1};
Transfinite Curve{1:4} = 3;
Curve Loop(1) = {2:4};
Plane Surface(1) = {1};
Transfinite Surface{1};
Recombine Surface{1};
v[] = Extrude {0, 0, 1} { Surface{1}; Layers{1}; Recombine; };
Physical Volume("block", 1) = {v[1]};
"""

# One hexahedron of 8 nodes, of which two are exchanged.
INVERTED = """$MeshFormat
2.2 0 8
$EndMeshFormat
$Nodes
8
1 0 0 0
2 1 0 0
3 1 1 0
4 0 1 0
5 0 0 1
6 1 0 1
7 1 1 1
8 0 1 1
$EndNodes
$Elements
1
1 5 2 1 1 2 1 3 4 5 6 7 8
$EndElements
"""

# A square and no hexahedra, as gmsh saves a cube of which only a surface is in a
# physical group.
SURFACE = INVERTED.replace("1 5 2 1 1 2 1 3 4 5 6 7 8", "1 3 2 1 1 1 2 3 4")

# Two blocks, one on the other, that do not share the face between them.
TOUCHING = """
SetFactory("OpenCASCADE");
Box(1) = {0, 0, 0, 1, 1, 1};
Box(2) = {0, 0, 1, 1, 1, 1};
Transfinite Curve{:} = 3;
Transfinite Surface{:};
Recombine Surface{:};
Transfinite Volume{:};
ground() = Surface In BoundingBox{-1, -1, -0.1, 2, 2, 0.1};
Physical Volume("blocks", 1) = {1, 2};
Physical Surface("ground", 2) = {ground()};
"""

FILE_SCENE = {
    **SCENE,
    "Body/Shape": "file",
    "Body/File": "body.geo",
    "Support/Fixed faces": "ground",
    "Blade/Edge loads": "1:1",
    "Cut/Surfaces": "plane: 2, 0, 0; 1, 0, 0",
}
for box_only in ("Body/Size", "Body/Elements"):
    del FILE_SCENE[box_only]


def wrong_file(name, text, allowed):
    """A file that cannot be used."""
    case = wrong_value("Body/File", name, allowed, FILE_SCENE)
    return case._replace(files={**case.files, name: text})


def crash(name, text):
    """A file on which gmsh crashes, with little memory."""
    scene = scene_text({**FILE_SCENE, "Body/File": name})[0]
    return Case(name, ["scene.prm"], {"scene.prm": scene, name: text}, 1,
                ["gmsh crashes when asked to read the file " + name], 4 << 30)


def endless(name, text):
    """A geometry that gmsh never finishes."""
    case = wrong_value("Body/File", name, "within the 0.5 s of Body/Meshing time",
                       FILE_SCENE, {"Body/Meshing time": "0.5"})
    return case._replace(files={**case.files, name: GEOMETRY + text})


def wrong_on_block(path, value, allowed, geometry=GEOMETRY, **also):
    """A value that does not go with the block."""
    case = wrong_value(path, value, allowed, FILE_SCENE, also)
    return case._replace(files={**case.files, "body.geo": geometry})


def wrong_on_box(path, value, allowed, **also):
    """A value that does not go with a box of 4 x 4 x 2 elements."""
    return wrong_value(path, value, allowed, SCENE,
                       {"Body/Size": "4, 4, 2", "Body/Elements": "4, 4, 2",
                        "Blade/Edge loads": "1:1", **also})


CASES = [
    wrong_file("empty.msh", "", "the file is empty"),
    wrong_file("empty.geo", "", ""),
    wrong_file("truncated.msh", INVERTED[:150], "truncated"),
    wrong_file("inverted.msh", INVERTED, "element 1 is flat or inverted"),
    wrong_file("syntax.geo", "Point(1) = {0, 0, 0};\nLine(1) = 2;\n", "line 2"),
    wrong_file("tetrahedra.geo", GEOMETRY.replace("Recombine;", ""), ""),
    wrong_file("body.txt", GEOMETRY, ""),
    wrong_file("open_loop.geo", OPEN_LOOP, "gmsh cannot mesh the geometry"),
    wrong_file("command.geo", GEOMETRY + 'SystemCall "touch left_behind";\n',
               "may not run commands, make directories or call servers; take out its "
               "'SystemCall'"),
    wrong_file("writes.geo", GEOMETRY + 'Printf("text") > "left_behind";\n',
               "Unable to open file 'left_behind'"),
    wrong_file("saves.geo", GEOMETRY + 'Mesh 3;\nSave "left_behind.msh";\n',
               "it may not write any"),
    wrong_file("exit.geo", GEOMETRY + "Mesh 3;\nExit;\n", "by 'Exit'"),
    endless("endless.geo", "Macro Endless\nCall Endless;\nReturn\nCall Endless;\n"),
    endless("loop.geo", "For i In {1:1}\n  i = 0;\nEndFor\n"),
    wrong_file("surface.msh", SURFACE, "give the geometry a Physical Volume"),
    wrong_file("twice.msh", INVERTED + INVERTED, "more than one section $MeshFormat"),
    wrong_file("left_over.msh", INVERTED.replace("$Nodes\n8", "$Nodes\n7"),
               "section $Nodes has more numbers than it announces (left_over.msh:13:1)"),
    wrong_file("comma.msh", INVERTED.replace("2 1 0 0", "2 1,0 0 0"),
               "(comma.msh:7:3); decimals stand behind a point"),
    # What ends a line elsewhere than in ASCII is not quoted as such.
    wrong_file("control.msh", INVERTED.replace("2 1 0 0", "2 \x851 0 0"),
               "has '?1' where a finite number must be (control.msh:7:3)"),
    wrong_file("minus.geo", GEOMETRY.replace("0, 0, 2", "0, 0, \u22122"),
               "minus.geo:5:22: there is the character U+2212"),
    crash("long_list.geo", GEOMETRY + "Transfinite Curve{9:1e9} = 3;\n"),
    wrong_on_block("Body/Open joints", "refuse",
                   "The 2 parts of the body touch at 9 places without being joined",
                   TOUCHING),
    wrong_on_block("Body/Open joints", "maybe", "warn, refuse, allow"),
    wrong_on_block("Body/Meshing time", "0", "a time greater than 0"),
    wrong_on_block("Support/Fixed faces", "ground",
                   "the part of 8 elements around (0.5, 0.5, 1.5) is not joined to any",
                   TOUCHING, **{"Cut/Surfaces": "plane: 0.5, 0, 0; 1, 0, 0"}),
    wrong_on_block("Support/Fixed faces", "floor",
                   '"ground" (2, faces), "lid" (3, faces), "block" (1, elements)'),
    wrong_on_block("Material/Young's modulus", "5; ground: 2", "'ground' is none"),
    wrong_on_block("Material/Young's modulus", "lid: 2", "is none"),
    wrong_on_block("Load/Pressures", "block: 2", 'it means "block" (1, elements)'),
    wrong_on_block("Cut/Surfaces", "x:1", "it has no numbered layers"),
    wrong_on_block("Cut/Surfaces", "group: ground", "lies on the boundary"),
    wrong_on_block("Cut/Surfaces", "group: block", "'block' is none"),
    wrong_on_block("Cut/Surfaces", "group: wall", "'wall' is none of them"),
    wrong_on_block("Cut/Surfaces", "between: block, lid", "'lid' is none"),
    wrong_on_block("Cut/Surfaces", "plane: 9, 0, 0; 1, 0, 0", "touches no face"),
    wrong_on_block("Support/Fixed components", "ground : w", "'group : components'"),
    wrong_on_block("Support/Displacements", "ground : 0, 0, 1",
                   "displacements that agree with the other supports"),
    wrong_on_box("Cut/Surfaces", "where: (x-2)*(y-2)", "meets itself wrongly"),
    wrong_on_box("Cut/Surfaces", "where: x -", "that muParser understands"),
    wrong_on_box("Cut/Surfaces", "x:2", "every node stays joined",
                 **{"Cut/Extent": "box: 1.9, 1.1, -1, 2.1, 1.9, 0.9",
                    "Body/Size": "4, 4, 4", "Body/Elements": "4, 4, 4"})._replace(
                        name="a slit of one element"),
]

if __name__ == "__main__":
    sys.exit(run_cases(sys.argv[1], CASES))
