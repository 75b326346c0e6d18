# SPDX-License-Identifier: LGPL-2.1-or-later
"""layering.py finds what is wrong: in a small house that is in order, one thing
after another is spoilt."""

import pathlib
import sys
import tempfile

from layering import DOCUMENT, ROOMS, find_problems, write_table

HOUSE = {f"include/setsudan/{room}/x.h": "#pragma once\n" for room in ROOMS}
HOUSE.update(
    {f"source/{room}/x.cc": f"#include <setsudan/{room}/x.h>\n" for room in ROOMS}
)
HOUSE["source/main.cc"] = "#include <setsudan/simulation/x.h>\n"
HOUSE["include/setsudan/cut/seam/x.h"] = "#include <setsudan/body/x.h>\n"
HOUSE["include/setsudan/cut/seam/row.h"] = "#include <setsudan/cut/seam/x.h>\n"
HOUSE["source/body/gmsh/x.cc"] = "#include <setsudan/body/x.h>\n"
HOUSE["source/body/x.cc"] = "#include <setsudan/body/gmsh/x.h>\n"


def write_house(root, files):
    for file, text in files.items():
        path = root / file
        path.parent.mkdir(parents=True, exist_ok=True)
        path.write_text(text)


def document():
    """What DOCUMENT says of the house."""
    lines = "".join(f"| `{room}` | it | |\n" for room in ROOMS)
    with tempfile.TemporaryDirectory() as name:
        root = pathlib.Path(name)
        text = f"# The house\n\n<!-- rooms -->\n\n{lines}\n<!-- end -->\n"
        write_house(root, {**HOUSE, DOCUMENT: text})
        write_table(root)
        return (root / DOCUMENT).read_text()


HOUSE[DOCUMENT] = document()
FIRST, SECOND = (f"| `{room}` | it | - |\n" for room in ROOMS[:2])

# A file, its new text, and what the message about it must contain.
SPOILT = [
    ("include/setsudan/body/x.h", "#include <setsudan/cut/seam/x.h>", "must not know"),
    ("source/solver/x.cc", "#include <setsudan/cut/seam/x.h>", "must not know"),
    ("source/solver/x.cc", "  #  include <setsudan/output/x.h>", "must not"),
    ("source/cut/surface/x.cc", "#include <setsudan/cut/seam/x.h>", "must not know"),
    ("source/body/gmsh/x.cc", "#include <setsudan/space/x.h>", "must not know"),
    ("source/main.cc", "#include <setsudan/cut/seam/x.h>", "must not know"),
    ("source/cut/seam/x.cc", '#include "../output/x.h"', "write <setsudan/"),
    ("source/cut/seam/x.cc", "#include <setsudan/cut/gone.h>", "does not exist"),
    ("source/cut/seam/x.cc", "#include <setsudan/cut.h>", "does not exist"),
    ("include/setsudan/cut/seam/x.h", "#include <setsudan/cut/seam/row.h>", "each other"),
    ("include/setsudan/cut/seam/x.h", "#include <setsudan/cut/seam/x.h>", "each other"),
    ("include/setsudan/kitchen/pan.h", "", "is in no room"),
    ("source/helpers.cc", "", "is in no room"),
    ("include/setsudan/cut/pan.h", "", "is in no room"),
    ("include/setsudan/cut/seam/deeper/pan.h", "", "is in no room"),
    (DOCUMENT, "# The house\n", "not those of ROOMS"),
    (DOCUMENT, HOUSE[DOCUMENT].replace(FIRST, ""), "what room parameters holds"),
    (DOCUMENT, HOUSE[DOCUMENT].replace(FIRST + SECOND, SECOND + FIRST), "not those of"),
    (DOCUMENT, HOUSE[DOCUMENT].replace("| `body/gmsh` |\n", "| - |\n"), "not those of"),
    (DOCUMENT, HOUSE[DOCUMENT].replace("`mesh` | it", "`mesh` | "), "what room mesh holds"),
]


def problems_of(files):
    with tempfile.TemporaryDirectory() as name:
        write_house(pathlib.Path(name), files)
        return find_problems(pathlib.Path(name))


def failures():
    if problems_of(HOUSE):
        yield f"the house in order: {problems_of(HOUSE)}"
    for file, text, message in SPOILT:
        problems = problems_of({**HOUSE, file: text})
        if not any(file in p and message in p for p in problems):
            yield f"'{text}' in {file} was not found: {problems}"


if __name__ == "__main__":
    FAILURES = list(failures())
    print("\n".join(FAILURES) or "all that was spoilt was found")
    sys.exit(1 if FAILURES else 0)
