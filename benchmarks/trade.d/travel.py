# SPDX-License-Identifier: LGPL-2.1-or-later
"""What may be left out where a blade travels, and at what price."""

import pathlib
import tempfile

import measure
import report
import runs

SCENE = pathlib.Path(__file__).resolve().parent / "travel.prm"


def along(n, across=8):
    return {"Body/Elements": f"{across},{n}", "Cut/Surfaces": f"x:{across // 2}"}


SLAB = {"Dimension": 3, "Body/Size": "0.0625, 1, 1", "Body/Elements": "1, 8, 16",
        "Cut/Surfaces": "y:4", "Blade/Direction": "0, 0, -1",
        "Support/Fixed components": "left : x; right : x"}
THIN = {"Blade/Shape": "line"}
FORCE = {**THIN, "Blade/Drive": "force", "Blade/Edge loads": "0 : 0.01",
         "Division/Load control": "ramp", "Division/Maximum load factor": 100,
         "Division/Split rows": "free"}
CHOICES = {
    "8 rows of elements": along(8), "16 rows of elements": {}, "32 rows of elements":
    along(32), "64 rows of elements": along(64),
    "linear elements": {"Body/Element type": "linear"},
    "quadratic elements": {"Body/Element type": "quadratic"},
    "node rows": {"Division/Release": "node row"},
    "one row at once": {"Division/Look-ahead": 1},
    "a slab of hexahedra": SLAB,
    "friction of 0.2": {"Blade/Friction": .2},
    "thin blade: no contact of flanks": THIN,
    "thin blade, its force given": FORCE}


def run(values):
    """Seconds, and force of the first row and mean force in the middle half of the cut,
    for each width."""
    with tempfile.TemporaryDirectory() as directory:
        scene = pathlib.Path(directory) / "scene.prm"
        scene.write_text(runs.scene_text(SCENE.stem, values))
        result = measure.program(scene, {})
    width = .0625 if values.get("Dimension") == 3 else 1
    yields = [{name: float(value) for name, value in line.items()
               if name in ("depth", "travel", "work", "blade_force")}
              for line in result.events if line["event"] == "yield"]
    middle = [line for line in yields if .25 - 1e-9 <= line["depth"] <= .75 + 1e-9]
    if "travel" in middle[0]:
        begin, end = middle[0], middle[-1]
        mean = (end["work"] - begin["work"]) / (end["travel"] - begin["travel"])
    else:
        mean = sum(line["blade_force"] for line in middle) / len(middle)
    return result.seconds, yields[0]["blade_force"] / width, mean / width


def section():
    results = {name: measure.remembered(f"travel, {name}", lambda v=values: run(v),
                                        runs.STORE) for name, values in CHOICES.items()}
    unit = results["16 rows of elements"][0]
    toughness = .01
    comment = " ".join(line[2:] for line in SCENE.read_text().splitlines()
                       if line.startswith("# "))
    rows = [[name, f"{mean / toughness:.3f}", f"{first / toughness:.2f}",
             f"{seconds / unit:.2g}"] for name, (seconds, first, mean) in results.items()]
    return "\n".join([
        "## travel", "", comment + " Toughness/Young's modulus is 0.01 of its height. "
        "Unless a line says otherwise: 16 rows of 8-node quadrilaterals, element rows, no "
        "friction. Forces are over toughness × width: the mean is that while the front is "
        "in the middle half of the cut. Time is relative to *16 rows of elements* "
        f"({unit:.1f} s where this was written).", "",
        measure.table(["", "mean force", "force at the first split", "time"], rows), ""])
