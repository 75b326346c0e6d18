"""H. Walls of a cut that have moved into each other: the volume that they share is a
column of the table, and a warning.

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
WARNED = warns("overlap", r"0\.2|0\.19[89]|0\.20")
# A volume to 1 %.
NEAR = 0.002


def shared(name, volume, scene=None, **more):
    """The bar, and how much its halves share in the end."""
    word = WARNED if volume == 0.2 else warns("overlap") if volume else warns_not(
        "overlap")
    return right(name, box({**(scene or BAR), **more}),
                 event("divide", overlap=volume, tolerance=NEAR), word)


def shared_in_part(directory, result):
    """Something is shared in each state in which rows are split."""
    for line in read(results_of(directory) / "statistics.csv"):
        volume = float(line.get("overlap") or "nan")
        if not (0 < volume < 0.2 if float(line["released_rows"]) > 0 else volume == 0):
            yield f"{volume} is shared in row {line['row']} ({line['event']})"


def on_two(place):
    """The volume is the same on 2 processes."""
    yield from ends_well(place.start("scene.prm", "--output", "one"))
    yield from ends_well(place.start("scene.prm", "--output", "two", processes=2))
    yield from same_columns(place.table("one"), place.table("two"), ("overlap",), 1e-8)


ENDS = "Support/Displacements"
FINE = {"Body/Elements": "4, 2, 3", "Cut/Surfaces": "x:2"}
CASES = [
    right("a bar that is pressed", FOLDER,
          event("deform", overlap=0, strain_energy=0.01, max_shear=0.05),
          event("divide", overlap=0.2, tolerance=NEAR), WARNED),
    right("walls that an opening keeps apart", changed(
        FOLDER, "scene.prm", ("Thickness = 0", "Thickness = 0.3"), ("free", "opened")),
          event("divide", overlap=0, tolerance=NEAR)),
    shared("one end alone", 0.2, **{ENDS: "left: 0, 0, 0; right: -0.2, 0, 0"}),
    shared("by a tenth as much", 0.02, **{ENDS: "left: 0.01, 0, 0; right: -0.01, 0, 0"}),
    shared("a bar that is pulled", 0, **{ENDS: "left: -0.1, 0, 0; right: 0.1, 0, 0"}),
    shared("a bar that is moved as a whole", 0,
           **{ENDS: "left: 0.1, 0, 0; right: 0.1, 0, 0"}),
    shared("a bar that is sheared along the cut", 0,
           **{ENDS: "left: 0, 0.1, 0; right: 0, -0.1, 0"}),
    shared("pressed, and sheared", 0.18,
           **{ENDS: "left: 0.1, 0.05, 0; right: -0.1, -0.05, 0"}),
    shared("smaller elements", 0.2, **FINE),
    shared("a bar that is refined", 0.2, **{"Body/Refinement": "1"}),
    shared("refined near the cut", 0.2, **{**FINE, "Cut/Refinement near cut": "1"}),
    *(shared(f"elements that are {kind}", 0.2, **{**FINE, "Body/Element type": kind})
      for kind in ("linear", "quadratic")),
    shared("a sheet", 0.2, SHEET),
    shared("a sheet that is pulled", 0, SHEET,
           **{ENDS: "left: -0.1, 0; right: 0.1, 0"}),
    shared("two cuts", 0.2, **{"Body/Elements": "3, 1, 1", "Cut/Surfaces": "x:1; x:2"}),
    shared("a bar that is turned", 0.2, **{
        "Body/Rotate": "z: 90", "Blade/Direction": "0, 0, -1",
        ENDS: "left: 0, 0.1, 0; right: 0, -0.1, 0",
        "Cut/Surfaces": "plane : 0, 1, 0; 0, 1, 0"}),
    right("a slit that is pressed", box(
        {**BAR, "Body/Elements": "4, 1, 4", "Cut/Surfaces": "x:2",
         "Cut/Extent": "depth : 0.6"}), shared_in_part, warns("overlap")),
]
STORIES = [(on_two, {"scene.prm": scene_text({**BAR, **FINE})[0]})]

if __name__ == "__main__":
    main(CASES, STORIES)
