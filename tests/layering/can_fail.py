"""layering.py finds what is wrong: in a small house that is in order, one thing
after another is spoilt."""

import pathlib
import sys
import tempfile

from layering import ROOMS, find_problems

HOUSE = {f"include/setsudan/{room}/{room}.h": "#pragma once\n" for room in ROOMS}
HOUSE.update(
    {f"source/{room}/{room}.cc": f"#include <setsudan/{room}/{room}.h>\n" for room in ROOMS}
)
HOUSE["source/main.cc"] = "#include <setsudan/simulation/simulation.h>\n"
HOUSE["include/setsudan/cut/cut.h"] = "#include <setsudan/body/body.h>\n"
HOUSE["include/setsudan/cut/row.h"] = "#include <setsudan/cut/cut.h>\n"

# A file, its new text, and what the message about it must contain.
SPOILT = [
    ("include/setsudan/body/body.h", "#include <setsudan/cut/cut.h>", "must not know"),
    ("source/solver/solver.cc", "#include <setsudan/cut/cut.h>", "must not know"),
    ("source/solver/solver.cc", "  #  include <setsudan/output/output.h>", "must not"),
    ("source/main.cc", "#include <setsudan/cut/cut.h>", "must not know"),
    ("source/cut/cut.cc", '#include "../output/output.h"', "write <setsudan/"),
    ("source/cut/cut.cc", "#include <setsudan/cut/gone.h>", "does not exist"),
    ("source/cut/cut.cc", "#include <setsudan/cut.h>", "does not exist"),
    ("include/setsudan/cut/cut.h", "#include <setsudan/cut/row.h>", "each other"),
    ("include/setsudan/cut/cut.h", "#include <setsudan/cut/cut.h>", "each other"),
    ("include/setsudan/kitchen/pan.h", "", "is in no room"),
    ("source/helpers.cc", "", "is in no room"),
    ("include/setsudan/cut/deeper/pan.h", "", "is in no room"),
]


def problems_of(files):
    with tempfile.TemporaryDirectory() as name:
        for file, text in files.items():
            path = pathlib.Path(name) / file
            path.parent.mkdir(parents=True, exist_ok=True)
            path.write_text(text)
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
