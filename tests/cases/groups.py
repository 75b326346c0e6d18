# SPDX-License-Identifier: LGPL-2.1-or-later
"""B. A word means the group of the dimension that a parameter is for, whatever other
groups have that number or name; what is ambiguous is refused, and groups are
listed with number and dimension.

usage: groups.py PROGRAM
"""

from cases import BLOCK, block, box, changed, folder, main, refused, right
from checks import event, lacks, pieces

LIFTED = event("deform", max_displacement=0.2, reaction_z=-0.4)
PHYSICAL = BLOCK[: BLOCK.index("Physical")]
VOLUME, GROUND, LID = "{v[1]}", "{s[1]}", "{v[0]}"
# Lines of the ground, side by side.
GROUND_LINE, OTHER_LINE = "{l[1]}", "{3}"


def body(*groups):
    """The block with groups 'kind(name) = entities'."""
    return PHYSICAL + "".join(f"Physical {group};\n" for group in groups)


def numbered(volume, ground, lid, *more):
    return body(f"Volume({volume}) = {VOLUME}", f"Surface({ground}) = {GROUND}",
                f"Surface({lid}) = {LID}", *more)


def by_number(ground, lid, **more):
    return {"Support/Fixed faces": ground, "Load/Pressures": f"{lid}: -0.1",
            **{"/".join(k.split("__")).replace("_", " "): v for k, v in more.items()}}


THREE_ONES = numbered(1, 1, 2, f"Curve(1) = {GROUND_LINE}", f"Curve(2) = {GROUND_LINE}")
LINES = (BLOCK + f'Physical Curve("edge", 7) = {GROUND_LINE};\n'
         + f"Physical Curve(8) = {OTHER_LINE};\n")
SQUARE = """Point(1) = {0, 0, 0};
l[] = Extrude {2, 0, 0} { Point{1}; Layers{2}; };
s[] = Extrude {0, 2, 0} { Curve{l[1]}; Layers{2}; Recombine; };
Physical Surface(1) = {s[1]};
Physical Curve(1) = {l[1]};
Physical Curve(2) = {s[0]};
Physical Point(2) = {1};
"""
PLANE = {"Dimension": "2", "Support/Fixed faces": "1", "Load/Pressures": "2: -0.1"}
# Two halves along y; their interface, and volumes and faces of one number.
HALVES = PHYSICAL.replace("{0, 2, 0}", "{0, 1, 0}").replace("Layers{2}; Recombine; };\nv",
                                                         "Layers{1}; Recombine; };\nv") + """
w[] = Extrude {0, 1, 0} { Surface{v[4]}; Layers{1}; Recombine; };
Physical Volume(1) = {v[1]};
Physical Volume(2) = {w[1]};
Physical Surface(1) = {v[4]};
Physical Surface(2) = {s[1]};
Physical Curve(2) = {l[1]};
"""
CUT = {"Blade/Sharpness": "1", "Load/Pressures": "", "Support/Fixed faces": "2",
       "Blade/Direction": "0, 0, -1"}
PARTITIONED = folder("partitioned_mesh")
# Names of numbers of the other dimension, and of the same.
NAMED = [f'Volume("block", 1) = {VOLUME}', f'Surface("2", 3) = {GROUND}']
TWICE = changed(changed(PARTITIONED, "body_22.msh", ('2 3 "lid"', '2 3 "ground"')),
                "scene_22.prm", ("lid:", "3:"))
LISTED = ['"ground" (2, faces)', '"lid" (3, faces)', '"block" (1, elements)']

CASES = [
    right("a number of faces and elements", folder("number_in_two_dimensions"), LIFTED),
    right("a name of faces and elements", folder("number_in_two_dimensions"), LIFTED,
          scene="scene_b.prm"),
    right("a number of three dimensions", block(by_number("1", "2"), THREE_ONES), LIFTED),
    right("a name of three dimensions", block(geometry=body(
        f'Volume("ground", 1) = {VOLUME}', f'Surface("ground", 2) = {GROUND}',
        f'Curve("ground", 3) = {GROUND_LINE}', f'Surface("lid", 4) = {LID}')), LIFTED),
    right("in two dimensions", block(PLANE, SQUARE),
          event("deform", max_displacement=0.2, reaction_y=-0.2)),
    right("Fixed components", block(
        {**by_number("", "2"), "Support/Fixed components": "1 : xyz"}, THREE_ONES),
          LIFTED),
    right("Displacements", block(
        {**by_number("1", "2"), "Load/Pressures": "",
         "Support/Displacements": "2 : free, free, 0.2"}, THREE_ONES),
          event("deform", max_displacement=0.2, clamp_z=0.4)),
    right("Tractions", block({**by_number("1", "2"), "Load/Pressures": "",
                              "Load/Tractions": "2 : 0, 0, 0.1"}, THREE_ONES), LIFTED),
    right("Material", block({**by_number("1", "2"),
                             "Material/Young's modulus": "1 : 2"}, THREE_ONES),
          event("deform", max_displacement=0.1)),
    right("group: of faces", block({**CUT, "Cut/Surfaces": "group: 1"}, HALVES),
          pieces(4, 4)),
    right("between: groups of elements", block({**CUT, "Cut/Surfaces": "between: 1, 2"},
                                               HALVES), pieces(4, 4)),
    # A group of another dimension, where it is the only one.
    right("elements as Fixed faces", block({"Support/Fixed faces": "block"}),
          event("deform", max_displacement=0)),
    refused("a line as Fixed faces", block({"Support/Fixed faces": "edge"}, LINES),
            "in 1 way."),
    right("two lines as Fixed components", block(
        {"Support/Fixed faces": "", "Support/Fixed components": "edge : xyz; 8 : z"},
        LINES), event("deform", reaction_z=-0.4)),
    # What is ambiguous.
    refused("a name and a number of faces", block(
        by_number("2", "5"), body(*NAMED, f"Surface(2) = {LID}", "Surface(5) = {v[2]}")),
            "Support, 'Fixed faces' is '2'", '"2" (3, faces)', "2 (faces)"),
    refused("a name and a number of elements", block(
        {**CUT, "Support/Fixed faces": "5", "Material/Young's modulus": "3; 2 : 1"},
        HALVES.replace("Volume(1)", 'Volume("2", 1)') + "Physical Surface(5) = {s[1]};\n"),
            "Material, 'Young's modulus'", '"2" (1, elements)', "2 (elements)"),
    refused("one name of two groups of faces", TWICE, "'ground', numbers 2 and 3",
            scene="scene_22.prm"),
    right("a name of faces that is a number of elements", block(
        {"Support/Fixed faces": "1"}, body(
            f'Volume("block", 1) = {VOLUME}', f'Surface("1", 2) = {GROUND}',
            f'Surface("lid", 3) = {LID}')), LIFTED),
    # Lists of groups.
    refused("an unknown group", PARTITIONED, "'floor' is none of them", *LISTED,
            lacks(r"\(1, faces\)"), lacks(r"\b1, 2, 3\b"), scene="scene_unknown.prm"),
    refused("an unknown group of a geometry", block({"Support/Fixed faces": "floor"}),
            "'floor' is none of them", *LISTED),
    refused("a group without a name", block(by_number("7", "2"), THREE_ONES),
            "'7' is none of them", "1 (faces)", "2 (faces)", "1 (elements)"),
    refused("elements where a surface is needed", block(
        {"Load/Pressures": "block: 2"}), "'block'", LISTED[2]),
    refused("faces where elements are needed", block(
        {"Material/Young's modulus": "5; lid : 2"}), "'lid'", LISTED[1]),
    refused("a face of a box", box({"Support/Fixed faces": "floor"}),
            '"left" (1, faces)', '"bottom" (5, faces)'),
    # Partitioned meshes have the groups that their geometry has.
    *(right(f"a partitioned mesh, {version}", PARTITIONED, LIFTED,
            scene=f"scene_{version}.prm") for version in ("22", "41")),
    right("by the numbers of gmsh's own groups", changed(
        PARTITIONED, "scene_41.prm", ("= ground", "= 2"), ("lid:", "3:")), LIFTED,
          scene="scene_41.prm"),
    right("a cut of a partitioned mesh", PARTITIONED, pieces(4, 4),
          scene="scene_cut.prm"),
]

if __name__ == "__main__":
    main(CASES)
