# SPDX-License-Identifier: LGPL-2.1-or-later
"""Values that are not allowed: for each group and dimension, the parameter, its
value, a part of what the message says is allowed, and for some of them what
else the scene has to say."""

from wrong_materials import NU, WRONG_MATERIALS

# Parts of the messages that several cases share; PATTERN stands for what deal.II
# says about its patterns, which may change with its version.
PATTERN = ""
COMPONENTS = "'group : 3 components'"
PRESSURE = "'group : pressure'"
NODES = "node numbers from 0 to 31"
EDGE_LOADS = "a list of 'position : force'"
ONE_FOR_EACH = "one item for all cuts, or one for each"
FROM_1 = "for y a boundary from 1 to 1"
PLANE = "'plane : px, py, pz ; nx, ny, nz'"
EXPRESSION = "'where : expression' in x,y,z"
EXTENT = "'all', 'depth : d' with d greater than 0, or 'box"
NOTHING = "touches no face of an element inside the body"
NO_FACES = {"Support/Fixed faces": ""}
MEAN_SHEAR = {"Yield/Criterion": "mean shear"}
A_FILE = {"Body/Shape": "file"}

WRONG_VALUES = {
    ("body", 3): [
        ("Dimension", "4", "2 (plane strain) or 3"),
        ("Dimension", "three", "2 (plane strain) or 3"),
        ("Body/Shape", "sphere", "box"),
        ("Body/Element type", "cubic", "quadratic"),
        ("Body/File", "body.msh", "nothing with box"),
        ("Body/File", "missing.msh", "a gmsh file that can be used", A_FILE),
        ("Body/File", "scene.prm", "a gmsh file that can be used", A_FILE),
        ("Body/Scale", "0", "factors greater than 0"),
        ("Body/Scale", "1, 2", "one factor, or one for each axis"),
        ("Body/Scale", "1, 2, 3, 4", "3"),
        ("Body/Scale", "big", PATTERN),
        ("Body/Rotate", "90", "'axis : angle' with an axis of xyz"),
        ("Body/Rotate", "w : 90", "'axis : angle' with an axis of xyz"),
        ("Body/Translate", "1, 2", "3"),
        ("Body/Refinement", "-1", PATTERN),
        ("Body/Refinement", "11", PATTERN),
        ("Body/Size", "10, 0, 10", "greater than 0"),
        ("Body/Size", "10, -1, 10", "greater than 0"),
        ("Body/Size", "10, 10", "3"),
        ("Body/Size", "10, 10, 10, 10", "3"),
        ("Body/Size", "10, ten, 10", PATTERN),
        ("Body/Size", "10; 10; 10", PATTERN),
        ("Body/Size", "10, nan, 10", PATTERN),
        ("Body/Size", "10, 1e400, 10", PATTERN),
        ("Body/Elements", "1, 0, 1", PATTERN),
        ("Body/Elements", "1, -2, 1", PATTERN),
        ("Body/Elements", "1, 2.5, 1", PATTERN),
        ("Body/Elements", "1, 2", "3"),
        ("Body/Elements", "1, 3000000000, 1", PATTERN),
        ("Body/Elements", "100000, 100000, 1", "fewer than 500 million"),
    ],
    ("body", 2): [
        ("Body/Size", "10, 10, 10", "2"),
        ("Body/Elements", "1, 2, 1", "2"),
        ("Body/Size", "10, 0", "greater than 0"),
        ("Body/Rotate", "x : 90", "'axis : angle' with an axis of z"),
    ],
    ("material", 3): WRONG_MATERIALS,
    ("material", 2): [
        ("Material/Axes", "1, 0, 0, 0, 1, 1", "of which one is z"),
        ("Material/Axes", "1, 0, 1, 0, 1, 0", "of which one is z"),
    ],
    ("support", 3): [
        ("Support/Fixed faces", "floor", '"left" (1, faces), "right" (2, faces)'),
        ("Support/Fixed faces", "bottom top", '"left" (1, faces), "right" (2, faces)'),
        ("Support/Fixed faces", "bottom; top", '"left" (1, faces), "right" (2, faces)'),
        ("Support/Fixed faces", "Bottom", '"left" (1, faces), "right" (2, faces)'),
        ("Support/Fixed faces", "", "in 6 ways"),
        ("Support/Fixed nodes", "0", "in 3 ways", NO_FACES),
        ("Support/Fixed nodes", "0, 2", "in 1 way.", NO_FACES),
        # The parameter is named that the scene holds the body with.
        ("Support/Fixed components", "bottom : z", "in 3 ways", NO_FACES),
        ("Support/Fixed boxes", "0, 0, 0, 1, 1, 1 : z", "in 5 ways", NO_FACES),
        ("Support/Displacements", "top : free, free, 1", "in 3 ways", NO_FACES),
        ("Support/Fixed components", "bottom", "components of x, y and z"),
        ("Support/Fixed components", "bottom : w", "components of x, y and z"),
        ("Support/Fixed components", "floor : x", '"left" (1, faces), "right" (2, faces)'),
        ("Support/Fixed boxes", "0, 0, 0, 10, 10 : x", "largest coordinates"),
        ("Support/Fixed boxes", "9, 0, 0, 1, 9, 9 : x", "largest coordinates"),
        ("Support/Displacements", "top : 1, 2", "'group : ux, uy, uz'"),
        ("Support/Displacements", "top : free, free, free", "'group : ux, uy, uz'"),
        ("Support/Displacements", "front : 0, 0, 1", "agree with the other supports"),
        ("Support/Displacements", "floor : 0, 0, 1", '"left" (1, faces), "right" (2, faces)'),
        ("Support/Loose pieces", "forget", "drop"),
        ("Support/Fixed nodes", "32", NODES),
        ("Support/Fixed nodes", "-1", PATTERN),
        ("Support/Fixed nodes", "1.5", PATTERN),
        ("Support/Fixed nodes", "first", PATTERN),
        ("Support/Fixed nodes", "0; 1", PATTERN),
    ],
    ("support", 2): [
        ("Support/Fixed faces", "front", '"right" (2, faces), "bottom" (3, faces)'),
        ("Support/Fixed faces", "", "in 3 ways"),
        ("Support/Fixed nodes", "0", "in 1 way.", NO_FACES),
        ("Support/Fixed nodes", "13", "node numbers from 0 to 12"),
    ],
    ("load", 3): [
        ("Load/Body force", "0, 0", "3 numbers"),
        ("Load/Body force", "0, 0, 0, 0", "3 numbers"),
        ("Load/Body force", "0, 0, down", PATTERN),
        ("Load/Body force", "0, 0, nan", PATTERN),
        ("Load/Pressures", "side : 1", '"left" (1, faces), "right" (2, faces)'),
        ("Load/Pressures", "top", PRESSURE),
        ("Load/Pressures", "top : 1, 2", PRESSURE),
        ("Load/Pressures", "top : high", PRESSURE),
        ("Load/Pressures", "top : 1; top : 2", "each once"),
        ("Load/Pressures", "top : nan", PRESSURE),
        ("Load/Pressures", "top : inf", PRESSURE),
        ("Load/Pressures", "top : 1e400", PRESSURE),
    ],
    ("forces", 3): [
        ("Load/Tractions", "side : 0, 0, 1", '"left" (1, faces), "right" (2, faces)'),
        ("Load/Tractions", "top : 0, 0", COMPONENTS),
        ("Load/Tractions", "top : 0, 0, up", COMPONENTS),
        ("Load/Tractions", "top : 0, 0, 1, top", COMPONENTS),
        ("Load/Tractions", "top : 0, 0, inf", COMPONENTS),
        ("Load/Nodal forces", "32 : 0, 0, 1", NODES),
        ("Load/Nodal forces", "-1 : 0, 0, 1", NODES),
        ("Load/Nodal forces", "1.5 : 0, 0, 1", NODES),
        ("Load/Nodal forces", "first : 0, 0, 1", NODES),
        ("Load/Nodal forces", "0 : 0, 1", "3 components"),
        ("Load/Nodal forces", "0 : 0, 0, nan", "3 components"),
        ("Load/Nodal forces", "0 : 0, 0, 1; 0.0 : 0, 0, 1", "each once"),
    ],
    ("load", 2): [
        ("Load/Body force", "0, 0, -1", "2 numbers"),
        ("Load/Pressures", "front : 1", '"right" (2, faces), "bottom" (3, faces)'),
        ("Load/Tractions", "top : 0, 0, -1", "'group : 2 components'"),
    ],
    ("blade", 3): [
        ("Blade/Sharpness", "-0.01", "from 0 to 1"),
        ("Blade/Sharpness", "1.01", "from 0 to 1"),
        ("Blade/Sharpness", "abc", PATTERN),
        ("Blade/Sharpness", "nan", PATTERN),
        ("Blade/Thickness", "-0.2", "not negative"),
        ("Blade/Shape", "wedge", "line where Blade/Drive is force"),
        ("Blade/Friction", "0.1", "0 where Blade/Drive is force"),
        ("Blade/Slice-push ratio", "1", "0 where Blade/Drive is force"),
        ("Blade/Adhesion", "1", "0 where Blade/Drive is force"),
        ("Blade/Speed", "1", "0 where Blade/Drive is force"),
        ("Blade/Travel", "1", "nothing where Blade/Drive is force"),
        ("Blade/Direction", "0, 1, 0", "of 'y:1' is 90 degrees off"),
        ("Blade/Direction", "0, 1.1, -1", "up to 45 degrees off it; that of 'y:1'"),
        ("Blade/Direction", "0, 1.001, -1", "is 45.03 degrees off"),
        ("Blade/Direction", "0, 0, -1; 0, 0, -1", ONE_FOR_EACH),
        ("Blade/Direction", "0, 0, 0", "not zero"),
        ("Blade/Direction", "0, -1", "3"),
        ("Blade/Direction", "0, 0, 1", "a side that is not fixed"),
        ("Blade/Edge loads", "0:10, 10.1:50", "positions from 0 to 10"),
        ("Blade/Edge loads", "-0.1:10", "positions from 0 to 10"),
        ("Blade/Edge loads", "0, 10", EDGE_LOADS),
        ("Blade/Edge loads", "0:10; 5:50", ONE_FOR_EACH),
        ("Blade/Edge loads", "0:10; 5:50", "of one cut are separated by ','"),
        ("Blade/Edge loads", "0:10, 5", EDGE_LOADS),
        ("Blade/Edge loads", "0:", EDGE_LOADS),
        ("Blade/Edge loads", ":10", EDGE_LOADS),
        ("Blade/Edge loads", "0:ten", EDGE_LOADS),
        ("Blade/Edge loads", "0:10:5", EDGE_LOADS),
        ("Blade/Edge loads", "0:nan", EDGE_LOADS),
        ("Blade/Edge loads", "0:inf", EDGE_LOADS),
    ],
    ("blade", 2): [
        ("Blade/Slice-push ratio", "1", "0 in 2D", {"Blade/Drive": "travel"}),
        ("Blade/Edge loads", "5:10", "position 0"),
        ("Blade/Direction", "0, 0, -1", "2"),
        ("Blade/Direction", "1, 0", "of 'x:1' is 90 degrees off"),
    ],
    ("cut", 3): [
        ("Cut/Surfaces", "y:0", FROM_1),
        ("Cut/Surfaces", "y:2", FROM_1),
        ("Cut/Surfaces", "y:-1", FROM_1),
        ("Cut/Surfaces", "y:1.5", FROM_1),
        ("Cut/Surfaces", "y:one", FROM_1),
        ("Cut/Surfaces", "y:nan", FROM_1),
        ("Cut/Surfaces", "y", FROM_1),
        ("Cut/Surfaces", "y:1:1", FROM_1),
        ("Cut/Surfaces", "w:1", "'axis : boundary' with an axis of xyz"),
        ("Cut/Surfaces", ":1", "'axis : boundary' with an axis of xyz"),
        ("Cut/Surfaces", "1:y", "'axis : boundary' with an axis of xyz"),
        ("Cut/Surfaces", "xy:1", "'axis : boundary' with an axis of xyz"),
        ("Cut/Surfaces", "y:1; y:1", "each surface once, and 'y:1' and 'y:1'"),
        ("Cut/Surfaces", "y:1; where : 5 - y", "'y:1' and 'where: 5 - y' have"),
        ("Cut/Surfaces", "x:1", "no cut across x, where the body is one element"),
        ("Cut/Surfaces", "plane : 0, 5, 0", PLANE),
        ("Cut/Surfaces", "plane : 0, 5, 0 ; 0, 0, 0", PLANE),
        ("Cut/Surfaces", "plane : 0, 5 ; 0, 1", PLANE),
        ("Cut/Surfaces", "plane : 0, 50, 0 ; 0, 1, 0", NOTHING),
        ("Cut/Surfaces", "where : y -", EXPRESSION),
        ("Cut/Surfaces", "where : y - depth", EXPRESSION),
        ("Cut/Surfaces", "where : log(y - 5)", "no number somewhere in the body"),
        ("Cut/Surfaces", "where : y + 50", NOTHING),
        ("Cut/Surfaces", "group : seam", "and 'seam' is none of them"),
        ("Cut/Surfaces", "group : top", "it lies on the boundary of the body"),
        ("Cut/Surfaces", "between : top", "'between : A, B' with two groups"),
        ("Cut/Surfaces", "between : top, bottom", "groups of elements"),
        ("Cut/Extent", "some", EXTENT),
        ("Cut/Extent", "depth : 0", EXTENT),
        ("Cut/Extent", "box : 0, 0, 1, 1", EXTENT),
        ("Cut/Extent", "all; all", "one item for all surfaces, or one for each"),
        ("Cut/Refinement near cut", "1.5", "a whole number of levels"),
        ("Cut/Refinement near cut", "11", "a whole number of levels"),
        ("Cut/Refinement near cut", "-1", PATTERN),
        ("Division/Row tolerance", "-1", "from 0 to less than 0.5"),
        ("Division/Row tolerance", "0.5", "from 0 to less than 0.5"),
        ("Yield/Criterion", "courage", "maximum shear"),
        ("Yield/Check", "never", "every row"),
        ("Yield/Process zone", "-1", "0 or a length"),
        ("Yield/Process zone", "0", "greater than 0", MEAN_SHEAR),
        ("Yield/Process zone", "-1", "greater than 0", MEAN_SHEAR),
        ("Division/Split rows", "glued", "opened, wedged, free"),
        ("Accuracy/Target", "1", "from 0 to less than 1"),
        ("Accuracy/Target", "-0.1", "from 0 to less than 1"),
        ("Accuracy/Quantity", "beauty", "strain energy"),
        ("Accuracy/Width", "-1", PATTERN),
        ("Accuracy/Maximum cells", "0", PATTERN),
        ("Division/Release", "row", "node row"),
        ("Division/Load control", "rising", "ramp"),
        ("Division/Maximum load factor", "-1", "not negative"),
    ],
    ("cut", 2): [
        ("Cut/Surfaces", "z:1", "'axis : boundary' with an axis of xy"),
        ("Cut/Surfaces", "x:2", "for x a boundary from 1 to 1"),
        ("Cut/Surfaces", "plane : 5, 5 ; 1, 0, 0", "'plane : px, py ; nx, ny'"),
        ("Cut/Surfaces", "where : z - 5", "'where : expression' in x,y"),
    ],
    ("output", 3): [
        ("Output/CalculiX decks", "true", "false with the mixed formulation", {NU: "0.49"}),
        ("Output/Directory", "", "the name of a directory"),
        ("Output/Frames", "some", "every row"),
        ("Output/Node tables", "perhaps", PATTERN),
        ("Output/CalculiX decks", "perhaps", PATTERN),
        ("Output/Checkpoint", "sometimes", "none"),
        ("Output/Piece shape", "round", "deformed"),
        ("Solver/Method", "guess", "iterative"),
        ("Solver/Tolerance", "0", "greater than 0 and at most 1e-3"),
        ("Solver/Tolerance", "0.1", "greater than 0 and at most 1e-3"),
        ("Solver/Maximum iterations", "0", PATTERN),
    ],
}

# A board below a body that lies on it, here one of 10 x 10 x 10.
ON_BOARD = {"Support/Fixed faces": "", "Cut/Surfaces": "", "Blade/Edge loads": "",
            "Board/Plane": "0, 0, 0; 0, 0, 1"}
SIX_NUMBERS = "a point and a normal that is not 0, as '0,0,0; 0,0,1'"
WRONG_BOARD = [
    *[("Board/Plane", plane, SIX_NUMBERS)
      for plane in ("0, 0, 0", "0, 0, 0; 0, 0", "0, 0, 0; 0, 0, 1, 0", "0, 0; 0, 0, 1",
                    "0, 0, 0; 0, 0, up", "0, 0, 0; 0, 0, 0", "below",
                    "0, 0, 0; 0, 0, 1; 0, 0, 1")],
    ("Board/Plane", "0, 0, 1; 0, 0, 1", "which reaches 1 beyond this one"),
    ("Board/Plane", "0, 0, 0; 0, 0, -1", "which reaches 10 beyond this one"),
    ("Board/Plane", "0, 0, -2; 0, 0, 3", "which is 2 above this one"),
    ("Board/Friction", "-0.1", PATTERN),
    ("Board/Friction", "0", "more than 0 where no support holds the body"),
    ("Board/Plane", "", "a point and a normal where Board/Friction is given",
     {"Board/Friction": "0.4", "Support/Fixed faces": "bottom"}),
    ("Accuracy/Target", "0.1", "0 on a board"),
    ("Division/Solve", "every row anew", "auto or condensed on a board"),
    ("Board/Plane", "0, 0, 0; 0, 0, 1", "nothing where a body is cut with Blade/Drive",
     {"Cut/Surfaces": "y:1", "Blade/Edge loads": "0:10"}),
]

# A blade that travels to the board, in a body that supports hold besides.
BLADE_ON_BOARD = [
    ("Blade/Travel", "5, 10.5", "positions of at most 10, at which the edge meets the "
     "board"),
]
# A cut that leaves out what is above it; by the number of dimensions.
INSIDE = {
    2: ("Cut/Extent", "box : 0, 0, 10, 6", "begins inside it", {"Body/Elements": "2, 4"}),
    3: ("Cut/Extent", "box : 0, 0, 0, 10, 10, 6", "begins inside it",
        {"Body/Elements": "1, 2, 4"}),
}

# A blade that travels, and what it cannot go with.
TRAVEL = {
    "Blade/Drive": "travel", "Blade/Shape": "wedge", "Blade/Edge loads": "",
    "Blade/Thickness": "1", "Yield/Criterion": "energy release",
    "Material/Toughness": "0.01",
}
# A blade that pushes only, under given forces.
WEDGED = {"Division/Split rows": "wedged"}
WRONG_WEDGED = [
    ("Accuracy/Target", "0.1", "0 where Division/Split rows is wedged"),
    ("Blade/Shape", "wedge", "line where Blade/Drive is force"),
    ("Blade/Thickness", "-1", "not negative"),
]

WRONG_TRAVEL = [
    ("Division/Split rows", "wedged", "opened where Blade/Drive is travel"),
    ("Division/Split rows", "free", "opened where Blade/Drive is travel"),
    ("Cut/Notch", "-1", "not negative"),
    ("Cut/Notch", "10", "the depth of"),
    ("Blade/Friction", "-0.1", "not negative"),
    ("Blade/Friction", "nan", PATTERN),
    *[("Blade/Edge points", points, "position : distance behind the foremost one")
      for points in ("0", "0 : x, 1 : 1", "0 : 1 : 2, 3 : 1")],
    ("Blade/Height", "0.1", "0, or more than"),
    ("Blade/Height", "-1", "0, or more than"),
    ("Blade/Height", "2", "0 where Blade/Shape is wire", {"Blade/Shape": "wire"}),
    ("Blade/Edge radius", "-0.1", "not negative", {"Blade/Sharpness": "0"}),
    ("Blade/Sharpness", "0.5", "0 where Blade/Edge radius",
     {"Blade/Edge radius": "0.1"}),
    ("Yield/Criterion", "maximum shear", "energy release where Blade/Edge radius",
     {"Blade/Edge radius": "0.1", "Blade/Sharpness": "0"}),
    ("Blade/Adhesion", "-0.1", "not negative"),
    ("Blade/Adhesion", "1", "0 where Blade/Guide is free", {"Blade/Guide": "free"}),
    *[("Blade/Travel", path, "either positions, or 'time : position' throughout")
      for path in ("deep", "1, deep", "0:0, 1:1:1", "0:0, 1:x", "0:0, 1",
                   "1, 2:2", "0:0, 1:")],
    ("Blade/Travel", "1, nan", "a finite number"),
    *[("Blade/Travel", path, "begins with 0 : 0")
      for path in ("1:0, 2:1", "0:1, 1:2", "-1:0, 1:1")],
    *[("Blade/Travel", path, "times that ascend")
      for path in ("0:0, 1:1, 1:2", "0:0, 2:1, 1:0", "0:0, 0:1")],
    *[("Blade/Travel", path, "does not touch the body")
      for path in ("0", "-1", "-1, -2", "0:0", "0:0, 1:-1")],
    *[("Blade/Travel", path, "begins forward")
      for path in ("-1, 1", "0, 1", "0:0, 1:-1, 2:1")],
    ("Blade/Speed", "1", "0 where Blade/Travel is a table of times",
     {"Blade/Travel": "0:0, 1:1"}),
    ("Blade/Slice-push ratio", "-1", "not negative"),
    ("Blade/Speed", "-1", "not negative"),
    ("Material/Rate exponent", "-1", "not negative"),
    ("Material/Rate exponent", "0.5", "0 where no Blade/Speed is given"),
    ("Material/Rate speed", "0", "greater than 0"),
    ("Blade/Edge grip", "-1", "not negative"),
    ("Blade/Edge grip", "firm", ""),
    ("Blade/Wedge angle", "0", "more than 0 and less than 180"),
    ("Blade/Wedge angle", "180", "more than 0 and less than 180"),
    ("Blade/Thickness", "0", "more than 0, for a wedge"),
    ("Blade/Thickness", "10", "wider than the body is across"),
    ("Blade/Thickness", "10", "wider than the body is across",
     {"Blade/Shape": "wire"}),
    ("Blade/Thickness", "0", "more than 0, for a wire", {"Blade/Shape": "wire"}),
    *[("Blade/Profile", profile, "that begin with 0 : 0", {"Blade/Shape": "profile"})
      for profile in ("", "0:0", "0:0, 0:1", "0:0, 2:1, 1:1", "0:0, 1:-1",
                      "0:0, 1:1, 2:0.5", "0:1, 2:1", "1:0, 2:1", "0:0, 1:0, 2:1",
                      "0:0, 1", "0:0, 1:x", "0:0, 1:nan", "0:0, 1:1:1")],
    ("Blade/Profile", "0:0, 1:5", "wider than the body is across",
     {"Blade/Shape": "profile"}),
    ("Blade/Guide", "free", "fixed where Blade/Shape is line", {"Blade/Shape": "line"}),
    ("Blade/Guide", "loose", PATTERN),
    ("Blade/Shoulder radius", "-1", "from 0 to"),
    ("Blade/Shoulder radius", "1e3", "no length left"),
    ("Blade/Shape", "axe", PATTERN),
    ("Blade/Edge loads", "0:1", "nothing, since the force is the reaction"),
    ("Yield/Check", "once", "every row where Blade/Drive"),
    ("Division/Load control", "ramp", "constant where Blade/Drive"),
    ("Division/Look-ahead", "-1", PATTERN),
    ("Cut/Surfaces", "", "a cut where Blade/Drive"),
    ("Accuracy/Target", "0.1", "0 where Blade/Drive"),
]
# Only where the edge is a line.
WRONG_IN_SPACE = [
    ("Blade/Edge points", "1 : 0, 0 : 1", "positions that ascend"),
    ("Blade/Edge points", "1 : 0", "two points or more"),
    ("Blade/Edge points", "0.1 : 0, 0.2 : 1", "reach over the whole cut"),
    ("Division/Release", "element row", "face band where Blade/Edge points",
     {"Blade/Edge points": "-100 : 0, 100 : 1"}),
]
WRONG_SLICE = [
    ("Blade/Adhesion", "1", "0 where Blade/Slice-push ratio"),
    ("Blade/Travel", "2, 1", "a blade that slices is not withdrawn"),
]
