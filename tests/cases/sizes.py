# SPDX-License-Identifier: LGPL-2.1-or-later
"""L. What is too large is refused in seconds, with the numbers of unknowns and of the
memory that it would take, with --validate too.

usage: sizes.py PROGRAM
"""

import re

from cases import block, box, folder, main, refused, right
from checks import event

FOLDER = folder("refinement_10")
SUPPORT = {"Support/Fixed faces": "bottom"}
CUT = {**SUPPORT, "Blade/Sharpness": "1", "Cut/Surfaces": "y:1"}
SHEET = {**SUPPORT, "Dimension": "2", "Body/Size": "10, 10", "Body/Elements": "2, 1"}
# Or that so many cannot be numbered.
MEMORY = re.compile(r"\d\S* [GTPE]i?B|2147483647 can be numbered")
# A run that begins to build what is too large is stopped by these.
LIMITS = {"seconds": 10, "memory": 6 << 30}


class Unknowns:
    """The message has a number of unknowns between these."""

    NUMBER = re.compile(r"(\d[\d ,'.e+]*?)( million| billion)? unknowns")

    def __init__(self, at_least, at_most):
        self.at_least, self.at_most = at_least, at_most
        self.pattern = f"{at_least:g} to {at_most:g} unknowns"

    def search(self, text):
        for number, unit in self.NUMBER.findall(text):
            value = float(re.sub("[ ,']", "", number))
            value *= {"": 1, " million": 1e6, " billion": 1e9}[unit]
            if self.at_least <= value <= self.at_most:
                return True
        return False


def too_large(name, values, parameter, *words):
    return refused(name, box(values), f"'{parameter}'", "unknowns", MEMORY, *words,
                   **LIMITS)


CASES = [
    refused("Refinement = 10", FOLDER, "scene.prm:2: subsection Body, 'Refinement'",
            MEMORY, Unknowns(2.5e10, 3e10), **LIMITS),
    refused("Refinement near cut = 10", FOLDER, "'Refinement near cut'", "unknowns",
            MEMORY, scene="scene_near.prm", **LIMITS),
    too_large("Refinement = 9", {**SUPPORT, "Body/Refinement": "9"}, "Refinement",
              Unknowns(3e9, 4e9)),
    too_large("Refinement = 8, quadratic", {
        **SUPPORT, "Body/Refinement": "8", "Body/Element type": "quadratic"},
              "Refinement", Unknowns(7.5e8, 9e8)),
    too_large("Refinement = 10 in the plane", {
        **SHEET, "Body/Refinement": "10", "Body/Elements": "40, 40"}, "Refinement",
              Unknowns(9e9, 1.1e10)),
    too_large("many elements", {**SUPPORT, "Body/Elements": "700, 700, 700"},
              "Elements", Unknowns(4e9, 4.4e9)),
    too_large("a long row of elements", {**SUPPORT, "Body/Elements": "1, 1, 400000000"},
              "Elements"),
    too_large("Refinement = 10 of a cut body", {**CUT, "Body/Refinement": "10"},
              "Refinement"),
    too_large("refined twice over", {**CUT, "Body/Refinement": "5",
                                     "Cut/Refinement near cut": "9, 10"},
              "Refinement near cut"),
    too_large("near a cut, of a width", {**CUT, "Cut/Refinement near cut": "9, 20"},
              "Refinement near cut"),
    refused("Refinement = 9 of a file", block({"Body/Refinement": "9"}),
            "'Refinement'", "unknowns", MEMORY, **LIMITS),
    refused("Refinement = 10 on 2 processes", FOLDER, "'Refinement'", MEMORY,
            launcher=["mpirun", "-np", "2"], seconds=10),
    # What fits.
    right("Refinement = 2", box({**SUPPORT, "Body/Refinement": "2"}),
          event("deform", max_displacement=0)),
    right("Refinement near cut = 2", box({**CUT, "Cut/Refinement near cut": "2"})),
    right("a block of a file", block({"Body/Refinement": "1"}),
          event("deform", max_displacement=0.2)),
]
# Nothing that fits and takes long is run.
for size in ("40, 40, 40", "100, 100, 5"):
    CASES.append([case for case in right(f"{size} elements", box(
        {**SUPPORT, "Body/Elements": size})) if "--validate" in case.arguments])

if __name__ == "__main__":
    main(CASES)
