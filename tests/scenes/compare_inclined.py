#!/usr/bin/env python3
# SPDX-License-Identifier: LGPL-2.1-or-later
"""An edge through points (Blade/Edge points) against what it must be the same as: a
straight edge where all points are as far back, and its own mirror image; and a thin
one against its energy, which is the toughness of the whole cut whatever way it goes.
"""

import pathlib
import sys
import tempfile

import program
import tables

NUMBERS = ("depth", "travel", "blade_force", "mean_force", "work", "strain_energy",
           "surface_energy", "friction_energy", "excess_energy", "max_strain")
SAME = 1e-8
STRAIGHT, EVEN = "Blade/Edge points=", "Blade/Edge points=0 : 2, 3 : 2, 8 : 2"
MIRRORED = "Blade/Edge points=0 : 0, 4 : 0.5, 8 : 3"
THIN = ("Blade/Shape=line", "Blade/Thickness=0", "Blade/Friction=0",
        "Blade/Shoulder radius=0")


def run(options, *settings):
    """The numbers of all states."""
    with tempfile.TemporaryDirectory() as directory:
        program.run(options, options.scene, pathlib.Path(directory),
                    (*program.QUIET, *settings))
        return [{column: float(line[column]) for column in NUMBERS}
                for line in tables.read(pathlib.Path(directory) / "statistics.csv")]


def difference(one, other):
    """The largest of two runs, relative to the largest value of each column."""
    if len(one) != len(other):
        return float("inf")
    return max(
        tables.relative_error(a[column], b[column],
                              max(abs(line[column]) for line in other) or 1)
        for a, b in zip(one, other) for column in NUMBERS)


def main():
    parser = program.parser(__doc__)
    parser.add_argument("--scene", required=True)
    options = parser.parse_args()
    inclined = run(options)
    found = {
        "points that are all as far back, and a straight edge":
            difference(run(options, EVEN), run(options, STRAIGHT)),
        "an edge and its mirror image": difference(inclined, run(options, MIRRORED)),
        "work of a thin one, and the toughness of the cut": tables.relative_error(
            run(options, *THIN)[-1]["work"], 64, 64),
    }
    # Points that change nothing would pass.
    changed = difference(inclined, run(options, STRAIGHT))
    for what, error in found.items():
        print(f"{what}: {error:.1e}")
    print(f"an inclined and a straight edge: {changed:.1e}")
    if max(found.values()) > SAME or not changed > 1e-3:
        sys.exit("FAILED")


if __name__ == "__main__":
    main()
