#!/usr/bin/env python3
# SPDX-License-Identifier: LGPL-2.1-or-later
"""Benchmarks with known answers, solved by the program: each number must be in its
bound, and what doc/verification.md says of it must be what is computed.

  verify.py --program P --case NAME --document D   compute a case and compare with D
  verify.py --program P --write D                  compute all, and write D anew
"""

import pathlib
import re
import sys

import beams
import blade
import cantilever
import cylinder
import fibres
import finite
import indentation
import manufactured
import membrane
import patch
import point_load
import problems
import sphere
import thick_plate
from problems import program

CASES = [module.CASE for module in (patch, thick_plate, beams, cylinder, membrane,
                                    sphere, point_load, cantilever, blade,
                                    indentation, fibres, finite, manufactured)]
HERE = pathlib.Path(__file__).resolve().parent
# How well another machine must repeat a number of the document.
REPEATED = 1e-4


def text_of(row):
    return (f"| {row.quantity} | {row.mesh} | {row.reference:.7g} | {row.computed:.7g} "
            f"| {row.ratio:.4f} | {row.demand} |")


def compute(case, options, long):
    """The rows of a case; leaves with a message where one is out of its bound."""
    rows = []
    for row in case.rows(options, long):
        print(text_of(row), flush=True)
        rows.append(row)
    wrong = [row for row in rows if not row.passes()]
    if wrong and not options.measure:
        sys.exit(f"{case.title}: out of bounds:\n" + "\n".join(map(text_of, wrong)))
    return rows


def section(case, rows):
    return "\n".join([f"## {case.title}", "", f"Source: {case.source}.", "",
                      "| quantity | elements | reference | computed | ratio | must be |",
                      "|---|---|---|---|---|---|", *map(text_of, rows), ""])


def read_document(path):
    """The computed numbers of a document by section, quantity and elements."""
    numbers, title = {}, None
    for line in path.read_text().splitlines():
        cells = [cell.strip() for cell in line.strip("|").split("|")]
        if line.startswith("## "):
            title = line[3:]
        elif line.startswith("| ") and re.match(r"[-+.\de]+$", cells[3]):
            numbers[title, cells[0], cells[1]] = float(cells[3])
    return numbers


def compare(case, rows, document):
    numbers = read_document(document)
    for row in rows:
        key = (case.title, row.quantity, row.mesh)
        if key not in numbers:
            sys.exit(f"{document.name} does not have '{row.quantity}', {row.mesh}: "
                     "scripts/verify writes it")
        error = problems.tables.relative_error(row.computed, numbers[key])
        if not error <= REPEATED:
            sys.exit(f"{row.quantity}, {row.mesh}: {document.name} says {numbers[key]}, "
                     f"which differs by {error:.1e}")


def main():
    parser = program.parser(__doc__)
    parser.add_argument("--case", choices=[case.name for case in CASES])
    parser.add_argument("--document", type=pathlib.Path)
    parser.add_argument("--write", type=pathlib.Path)
    parser.add_argument("--long", action="store_true")
    parser.add_argument("--measure", action="store_true", help="bounds do not matter")
    options = parser.parse_args()
    cases = [case for case in CASES if options.case in (None, case.name)]
    long = options.long or options.write is not None
    results = [(case, compute(case, options, long)) for case in cases]
    if options.document:
        for case, rows in results:
            compare(case, rows, options.document)
    if options.write:
        parts = [(HERE / "introduction.md").read_text()]
        parts += [section(case, rows) for case, rows in results]
        options.write.write_text("\n".join(parts))


main()
