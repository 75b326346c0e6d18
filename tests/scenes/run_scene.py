#!/usr/bin/env python3
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
VECTORS = (
    ("reaction_x", "reaction_y", "reaction_z"),
    ("clamp_x", "clamp_y", "clamp_z"),
)
TEXT = ("event", "row_pieces")
# What is empty where only the front is asked for, and how that is asked for.
OF_BODY = RESIDUALS + VECTORS[0] + VECTORS[1] + (
    "strain_energy", "potential_energy", "max_displacement", "min_jacobian",
    "max_strain", "max_shear")
FRONT_ONLY = ["Output/Statistics=front", "Output/Frames=none",
              "Output/Node tables=false", "Output/CalculiX decks=false",
              "Output/Checkpoint=none"]
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
        known = [(line[column], other[column]) for line, other in zip(lines, expected)
                 if line[column] or column not in OF_BODY]
        group = next((v for v in VECTORS if column in v), (column,))
        scale = max(abs(float(line[c])) for line in expected for c in group)
        error = max(tables.relative_error(float(a), float(b), scale) for a, b in known)
        if not error <= tolerance:
            yield f"{column} differs by {error:.2e} of its largest value"


def residual_errors(lines):
    for column in RESIDUALS:
        largest = max(float(line[column]) for line in lines if line[column])
        if not (math.isfinite(largest) and largest <= LARGEST_RESIDUAL):
            yield f"{column} reaches {largest:.2e}"


def check_empty(lines, some_are_empty):
    """Rows are empty but for their front where only that is asked for."""
    empty = [line for line in lines if not line["strain_energy"]]
    if bool(empty) != some_are_empty:
        yield f"{len(empty)} events are known at the front only"
    for line in lines:
        if len({bool(line[column]) for column in OF_BODY}) > 1:
            yield f"event {line['event']} of row {line['row']} is half empty"


def main():
    parser = program.parser(__doc__)
    parser.add_argument("--scene", required=True)
    parser.add_argument("--expected", required=True)
    parser.add_argument("--tolerance", type=float, default=1e-8)
    parser.add_argument("--set", action="append", default=[], dest="settings")
    parser.add_argument("--front", action="store_true",
                        help="ask for the front only; what is not empty must agree")
    parser.add_argument("--update", action="store_true")
    options = parser.parse_args()
    if options.front:
        options.settings += FRONT_ONLY

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
    errors += check_empty(lines, options.front)
    if errors:
        sys.exit("\n".join(errors))
    print(f"{len(lines)} events agree to {options.tolerance}")


main()
