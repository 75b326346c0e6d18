#!/usr/bin/env python3
# SPDX-License-Identifier: LGPL-2.1-or-later
"""Run a cube of the reference tables through its whole cut, and compare every
stage: displacements to 1e-6 of the largest, maximum shear, cutting stress and
strain energy to 1e-6 relative."""

import pathlib
import sys
import tempfile

import program
import tables

TOLERANCE = 1e-6
REFERENCE = pathlib.Path(__file__).parent / "reference"


def compare_nodes(nodes, expected):
    """The largest error of displacement and of shear, relative to the largest."""
    key = lambda row: (int(row["number"]), row["side"])
    nodes = {key(row): row for row in nodes}
    expected = {key(row): row for row in expected}
    if set(nodes) != set(expected):
        sys.exit(f"the nodes differ: {sorted(set(nodes) ^ set(expected))[:5]}")
    errors = []
    for columns in (("ux", "uy", "uz"), ("max_shear",), ("x", "y", "z")):
        largest = max(abs(float(row[c])) for row in expected.values() for c in columns)
        errors.append(max(tables.relative_error(float(nodes[k][c]),
                                                float(expected[k][c]), largest)
                          for k in expected for c in columns))
    return errors


def compare_stage(directory, line, reference, stage, summary):
    nodes = tables.read(directory / f"nodes_{int(line['frame']):04d}.csv")
    errors = compare_nodes(nodes, tables.read(
        REFERENCE / f"{reference}_nodes_{stage}.csv"))
    for column in ("cutting_stress", "strain_energy"):
        errors.append(tables.relative_error(float(line[column]), float(summary[column])))
    if int(line["released_rows"]) != int(summary["released_rows"]):
        sys.exit(f"stage {stage}: {line['released_rows']} rows are released")
    print(f"stage {stage}: errors of displacement, shear, position, stress and "
          f"energy", *(f"{error:.1e}" for error in errors))
    return max(errors)


def main():
    parser = program.parser(__doc__)
    parser.add_argument("--reference", required=True)
    options = parser.parse_args()

    scene = pathlib.Path(__file__).parent / f"{options.reference}.prm"
    with tempfile.TemporaryDirectory() as directory:
        program.run(options, scene, directory)
        directory = pathlib.Path(directory)
        states = [line for line in tables.read(directory / "statistics.csv")
                  if line["event"] in ("deform", "divide")]
        stages = tables.read(REFERENCE / f"{options.reference}_summary.csv")
        if len(states) != len(stages):
            sys.exit(f"{len(states)} states instead of {len(stages)}")
        largest = max(compare_stage(directory, line, options.reference, stage, summary)
                      for stage, (line, summary) in enumerate(zip(states, stages)))
    if not largest <= TOLERANCE:
        sys.exit(f"the largest error {largest:.1e} exceeds {TOLERANCE}")


main()
