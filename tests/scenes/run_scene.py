#!/usr/bin/env python3
# SPDX-License-Identifier: LGPL-2.1-or-later
"""Run a scene and compare its statistics with an expected table.

Columns of numbers must agree to the tolerance, relative to the largest value
in the column (for the reaction and the clamps' force, in their three columns);
texts must be the same; residuals must be small; the time is not compared. With
--update the expected table is written instead.
"""

import math
import pathlib
import sys
import tempfile

import program
import tables

LARGEST_RESIDUAL = 1e-8
RESIDUALS = ("force_residual", "moment_residual")
# Components of a vector, and parts of one sum, some of which may be round-off.
GROUPS = (
    ("reaction_x", "reaction_y", "reaction_z"),
    ("clamp_x", "clamp_y", "clamp_z"),
    ("work", "surface_energy", "friction_energy", "excess_energy"),
    ("opening_force", "opening_pull"),
)
TEXT = ("event", "row_pieces")
NOT_COMPARED = ("seconds",) + RESIDUALS


def column_errors(lines, expected, tolerance):
    """Messages for the columns in which two tables differ."""
    for column in expected[0]:
        if column in NOT_COMPARED:
            continue
        if column in TEXT:
            same = [line[column] for line in lines] == [line[column] for line in expected]
            if not same:
                yield f"{column} differs"
            continue
        group = next((v for v in GROUPS if column in v), (column,))
        scale = max(abs(float(line[c])) for line in expected for c in group)
        error = max(tables.relative_error(float(line[column]), float(other[column]), scale)
                    for line, other in zip(lines, expected))
        if not error <= tolerance:
            yield f"{column} differs by {error:.2e} of its largest value"


def residual_errors(lines):
    for column in RESIDUALS:
        largest = max(float(line[column]) for line in lines)
        if not (math.isfinite(largest) and largest <= LARGEST_RESIDUAL):
            yield f"{column} reaches {largest:.2e}"


def main():
    parser = program.parser(__doc__)
    parser.add_argument("--scene", required=True)
    parser.add_argument("--expected", required=True)
    parser.add_argument("--tolerance", type=float, default=1e-8)
    parser.add_argument("--set", action="append", default=[], dest="settings")
    parser.add_argument("--update", action="store_true")
    options = parser.parse_args()

    with tempfile.TemporaryDirectory() as directory:
        program.run(options, options.scene, directory, options.settings)
        lines = tables.read(pathlib.Path(directory) / "statistics.csv")
        if options.update:
            written = pathlib.Path(directory) / "statistics.csv"
            pathlib.Path(options.expected).write_text(written.read_text())
            return
    expected = tables.read(options.expected)
    if len(lines) != len(expected):
        sys.exit(f"{len(lines)} events instead of {len(expected)}")
    errors = list(column_errors(lines, expected, options.tolerance))
    errors += residual_errors(lines)
    if errors:
        sys.exit("\n".join(errors))
    print(f"{len(lines)} events agree to {options.tolerance}")


if __name__ == "__main__":
    main()
