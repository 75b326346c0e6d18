#!/usr/bin/env python3
# SPDX-License-Identifier: LGPL-2.1-or-later
"""Contact from solves of each stage, iterative ones on several processes too, against
contact on the body that is condensed onto the cut: the same events, and numbers.
"""

import pathlib
import sys
import tempfile

import program
import tables

SAME = 1e-7
TEXT = ("event", "row_pieces")
NOT_COMPARED = ("seconds", "force_residual", "moment_residual")
ANEW = ("Division/Solve=every row anew",)
ITERATIVE = (*ANEW, "Solver/Method=iterative")
# Small ones, since processes wait for each other in each iteration.
SCENES = {
    "blade_wedge": ("Body/Elements=4, 4", "Cut/Surfaces=x:2"),
    "blade_inclined": ("Body/Elements=2, 2, 3", "Cut/Surfaces=x:1"),
}


def run(options, scene, processes, settings):
    """All states, and what was said."""
    with tempfile.TemporaryDirectory() as directory:
        said = program.run(options, pathlib.Path(options.scenes) / f"{scene}.prm",
                           directory, (*program.QUIET, *settings), processes)
        return tables.read(pathlib.Path(directory) / "statistics.csv"), said


def difference(lines, expected):
    """The largest, relative to the largest value of each column."""
    if len(lines) != len(expected):
        return float("inf")
    worst = 0.0
    for column in expected[0]:
        if column in NOT_COMPARED:
            continue
        if column in TEXT:
            if any(a[column] != b[column] for a, b in zip(lines, expected)):
                return float("inf")
            continue
        # Parts of a sum, some of which are round-off, by its largest.
        of_sum = ("work" if column.endswith("_energy") else
                  "blade_force" if column.startswith("reaction") else column)
        scale = max(abs(float(line[c])) for line in expected for c in (column, of_sum))
        if scale > 0:
            worst = max([worst] + [
                tables.relative_error(float(a[column]), float(b[column]), scale)
                for a, b in zip(lines, expected)])
    return worst


def main():
    parser = program.parser(__doc__)
    parser.add_argument("--scenes", required=True)
    options = parser.parse_args()
    failed = False
    for scene, small in SCENES.items():
        expected, said = run(options, scene, 1, small)
        failed = failed or "from one factorization" not in said
        for processes, settings in ((1, ANEW), (1, ITERATIVE), (2, ITERATIVE),
                                    (3, ITERATIVE)):
            lines, said = run(options, scene, processes, (*small, *settings))
            error = difference(lines, expected)
            print(f"{scene}, {settings[-1]}, {processes} processes: {error:.1e}")
            failed = failed or not error <= SAME or \
                "with each force of contact" not in said
    if failed:
        sys.exit("FAILED")


if __name__ == "__main__":
    main()
