# SPDX-License-Identifier: LGPL-2.1-or-later
"""G. States in which nothing pulls or presses are in balance: a body that clamps move,
and a bar that has been cut across between its clamps. They run to their end, and are
resumed.

usage: no_forces.py PROGRAM [MPIEXEC]
"""

import signal

from cases import block, box, main, right
from checks import event, pieces
from program_cases import scene_text
from stepped import SteppedRun
from stories import ends_well, same_columns

CUBE = {
    "Body/Size": "2, 2, 2",
    "Body/Elements": "2, 2, 2",
    "Material/Young's modulus": "1",
    "Material/Poisson's ratio": "0.3",
    "Output/Node tables": "true",
}
BAR = {
    "Body/Size": "4, 1, 1",
    "Body/Elements": "4, 1, 1",
    "Material/Young's modulus": "1",
    "Material/Poisson's ratio": "0",
    "Support/Displacements": "left : -0.1, 0, 0; right : 0.1, 0, 0",
    "Blade/Sharpness": "1",
    "Blade/Thickness": "0",
    "Cut/Surfaces": "x:2",
    "Division/Split rows": "free",
}
SHEET = {**BAR, "Dimension": "2", "Body/Size": "4, 1", "Body/Elements": "4, 1",
         "Support/Displacements": "left : -0.1, 0; right : 0.1, 0",
         "Blade/Direction": "0, -1"}
STILL = {"strain_energy": 0, "reaction_x": 0, "reaction_y": 0, "reaction_z": 0}
SIZES = ("1e-6", "1", "1e6")
KINDS = ("linear", "serendipity", "quadratic")
WAYS = ({"Division/Solve": "every row anew"}, {"Division/Solve": "condensed"},
        {"Solver/Method": "iterative"})


def moved(name, displacements, largest, **more):
    """A cube that is moved and not deformed."""
    values = {**CUBE, "Support/Displacements": displacements, **more}
    return right(name, box(values), event("deform", max_displacement=largest, **STILL))


def parted(name, scene, **more):
    """A bar that is pulled, cut across, and free of forces in the end."""
    return right(name, box({**scene, **more}),
                 event("deform", max_displacement=0.1, strain_energy=0.005),
                 event("divide", strain_energy=0, max_displacement=0.1), pieces(2, 2))


def resumed(place):
    """A bar that is pulled and cut across is resumed."""
    options = ["scene.prm", "--set", "Output/Checkpoint=every row", "--output"]
    yield from ends_well(place.start(*options, "whole"))
    run = SteppedRun([], [place.program, *options, "again"], place.directory / "lines",
                     cwd=place.directory)
    for line in iter(run.read, ""):
        if "row 4/" in line:
            break
    status, message, _ = run.kill()
    if status != -signal.SIGKILL:
        yield f"it was not killed: {status} {message}"
    yield from ends_well(place.start(*options, "again", "--resume"))
    yield from same_columns(place.table("whole"), place.table("again"),
                            ("strain_energy", "max_displacement", "depth"), 1e-12)


def ended(place):
    """A run that has ended so has nothing to resume."""
    for _ in range(2):
        yield from ends_well(place.start("scene.prm", "--output", "out", "--resume"))


def on_two(place):
    """A bar that is pulled and cut across on 2 processes."""
    yield from ends_well(place.start("scene.prm", "--output", "one"))
    yield from ends_well(place.start("scene.prm", "--output", "two", processes=2))
    yield from same_columns(place.table("one"), place.table("two"),
                            ("strain_energy", "max_displacement"), 1e-8)


CASES = [
    moved("a cube moved by its bottom", "bottom : 0.1, 0, 0", 0.1),
    moved("a cube moved by its top and bottom", "bottom : 0, 0, 1; top : 0, 0, 1", 1),
    moved("a cube moved by little", "bottom : 1e-9, 0, 0", 1e-9),
    moved("a cube moved far", "bottom : 1e3, 0, 0", 1e3),
    *(moved(f"elements that are {kind}", "bottom : 0.1, 0, 0", 0.1,
            **{"Body/Element type": kind}) for kind in KINDS),
    *(moved(f"a modulus of {size}", "bottom : 0.1, 0, 0", 0.1,
            **{"Material/Young's modulus": size}) for size in SIZES),
    moved("a cube moved iteratively", "bottom : 0.1, 0, 0", 0.1,
          **{"Solver/Method": "iterative"}),
    moved("a mixed formulation", "bottom : 0.1, 0, 0", 0.1,
          **{"Material/Poisson's ratio": "0.49"}),
    moved("a cube that nothing loads", "", 0, **{"Support/Fixed faces": "bottom"}),
    right("a block of a file", block({
        "Support/Fixed faces": "", "Load/Pressures": "",
        "Support/Displacements": "ground : 0.1, 0, 0"}),
          event("deform", max_displacement=0.1, **STILL)),
    right("a cut of a moved cube", box({
        **CUBE, "Support/Displacements": "bottom : 0.1, 0, 0", "Cut/Surfaces": "y:1",
        "Blade/Sharpness": "1", "Blade/Thickness": "0"}),
          event("divide", max_displacement=0.1, strain_energy=0), pieces(4, 4)),
    parted("a bar", BAR),
    parted("a sheet", SHEET),
    *(parted(f"a bar, {', '.join(way.values())}", BAR, **way) for way in WAYS),
    *(parted(f"a bar of elements that are {kind}", BAR, **{"Body/Element type": kind})
      for kind in KINDS),
    parted("a bar that falls", BAR, **{"Support/Loose pieces": "drop"}),
]
FILES = {"scene.prm": scene_text({**BAR, "Body/Elements": "4, 1, 4"})[0]}
STORIES = [(resumed, FILES), (ended, FILES), (on_two, FILES)]

if __name__ == "__main__":
    main(CASES, STORIES)
