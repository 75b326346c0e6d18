# SPDX-License-Identifier: LGPL-2.1-or-later
"""H. Walls of a cut that have moved through each other: how far is a column of the
table, as the nodes say, and a warning.

usage: overlap.py PROGRAM [MPIEXEC]
"""

from cases import box, changed, folder, main, right
from checks import event, read, results_of, warns, warns_not
from program_cases import scene_text
from stories import ends_well, same_columns

# A bar pressed together by 0.1 at each end, and cut across.
FOLDER = folder("faces_that_overlap")
BAR = {
    "Body/Size": "2, 1, 1",
    "Body/Elements": "2, 1, 1",
    "Material/Young's modulus": "1",
    "Material/Poisson's ratio": "0",
    "Support/Displacements": "left: 0.1, 0, 0; right: -0.1, 0, 0",
    "Blade/Sharpness": "1",
    "Blade/Thickness": "0",
    "Cut/Surfaces": "x:1",
    "Division/Split rows": "free",
}
SHEET = {**BAR, "Dimension": "2", "Body/Size": "2, 1", "Body/Elements": "2, 1",
         "Support/Displacements": "left: 0.1, 0; right: -0.1, 0",
         "Blade/Direction": "0, -1"}
WARNED = warns("walls", "overlap", r"in frame \d", r"by \d\S* cm", r"at \(1, ")


def through(name, depth, scene=None, **more):
    """The bar, and how far its halves are through each other in the end."""
    values = {**(scene or BAR), "Output/Node tables": "true", **more}
    return right(name, box(values), event("divide", overlap=depth),
                 warns("walls", "overlap") if depth else warns_not("overlap"))


def as_the_nodes_say(directory, _):
    """In every state it is the largest difference of the two sides of a node, which
    the cut at x = 1 has split; none while the body is whole."""
    output = results_of(directory)
    for line in read(output / "statistics.csv"):
        sides = {}
        for row in read(output / f"nodes_{int(line['frame']):04}.csv"):
            sides.setdefault(row["number"], {})[row["side"]] = float(row["ux"])
        depth = max([0, *(side["-"] - side["+"] for side in sides.values()
                          if len(side) == 2)])
        found = float(line.get("overlap") or "nan")
        if not abs(found - depth) < 1e-8 or (depth > 1e-8) != (line["released_rows"] > "0"):
            yield f"{found} instead of {depth} in row {line['row']} ({line['event']})"


def on_two(place):
    """It is the same on 2 processes."""
    yield from ends_well(place.start("scene.prm", "--output", "one"))
    yield from ends_well(place.start("scene.prm", "--output", "two", processes=2))
    yield from same_columns(place.table("one"), place.table("two"), ("overlap",), 1e-8)


ENDS = "Support/Displacements"
FINE = {"Body/Elements": "4, 2, 3", "Cut/Surfaces": "x:2"}
CASES = [
    right("a bar that is pressed", FOLDER,
          event("deform", overlap=0, strain_energy=0.01, max_shear=0.05),
          event("divide", overlap=0.2), WARNED, as_the_nodes_say),
    # The blade keeps them apart until it is through.
    right("walls that an opening keeps apart", changed(
        FOLDER, "scene.prm", ("Thickness = 0", "Thickness = 0.3"), ("free", "opened")),
          event("yield", overlap=0), event("divide", overlap=0.2), warns("in frame 4")),
    through("one end alone", 0.2, **{ENDS: "left: 0, 0, 0; right: -0.2, 0, 0"}),
    through("by a tenth as much", 0.02, **{ENDS: "left: 0.01, 0, 0; right: -0.01, 0, 0"}),
    through("a bar that is pulled", 0, **{ENDS: "left: -0.1, 0, 0; right: 0.1, 0, 0"}),
    through("a bar that is moved as a whole", 0,
           **{ENDS: "left: 0.1, 0, 0; right: 0.1, 0, 0"}),
    through("a bar that is sheared along the cut", 0,
           **{ENDS: "left: 0, 0.1, 0; right: 0, -0.1, 0"}),
    through("pressed, and sheared", 0.2,
           **{ENDS: "left: 0.1, 0.05, 0; right: -0.1, -0.05, 0"}),
    through("smaller elements", 0.2, **FINE),
    through("a bar that is refined", 0.2, **{"Body/Refinement": "1"}),
    through("refined near the cut", 0.2, **{**FINE, "Cut/Refinement near cut": "1"}),
    *(through(f"elements that are {kind}", 0.2, **{**FINE, "Body/Element type": kind})
      for kind in ("linear", "quadratic")),
    through("a sheet", 0.2, SHEET),
    through("a sheet that is pulled", 0, SHEET,
           **{ENDS: "left: -0.1, 0; right: 0.1, 0"}),
    through("two cuts", 0.1, **{"Body/Elements": "3, 1, 1", "Cut/Surfaces": "x:1; x:2"}),
    through("a bar that is turned", 0.2, **{
        "Body/Rotate": "z: 90", "Blade/Direction": "0, 0, -1",
        ENDS: "left: 0, 0.1, 0; right: 0, -0.1, 0",
        "Cut/Surfaces": "plane : 0, 1, 0; 0, 1, 0"}),
    right("a slit that is pressed", box(
        {**BAR, "Body/Elements": "4, 1, 4", "Cut/Surfaces": "x:2",
         "Cut/Extent": "depth : 0.6", "Output/Node tables": "true"}), as_the_nodes_say,
          WARNED),
]
STORIES = [(on_two, {"scene.prm": scene_text({**BAR, **FINE})[0]})]

if __name__ == "__main__":
    main(CASES, STORIES)
