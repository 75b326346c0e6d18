#!/usr/bin/env python3
# SPDX-License-Identifier: LGPL-2.1-or-later
"""The preset `firm tofu` against the measured curves that it is fitted to, in tension,
compression and shear: root mean square of the difference over the largest stress.
"""

import csv
import math
import pathlib
import sys
import tempfile

import program
import tables

RATE = 0.01  # of strain, 1/s: the relaxation time of the preset goes with it
LARGEST = 0.05
STEPS = {"tension": 30, "compression": 20, "shear": 20}
# A cube of 1 mm, so that the force is the stress; uniform, since the sides of the sheared
# one have no nodes of their own.
CUBE = """\
set Length unit = mm
set Force unit  = mN
subsection Body
  set Size         = 1, 1, 1
  set Elements     = 1, 1, 1
  set Element type = linear
end
subsection Material
  set Preset = firm tofu
end
subsection Deformation
  set Strain = finite
end
"""
HELD = {"bar": ("left : x; front : y; bottom : z", "right : {}, free, free"),
        "shear": ("bottom : xyz", "top : {}, 0, 0")}


def read_points(path):
    """Strain and stress [kPa] of each test."""
    points = {}
    with open(path, newline="") as table:
        for line in csv.DictReader(line for line in table if not line.startswith("#")):
            points.setdefault(line["test"], []).append(
                (float(line["strain"]), float(line["stress"])))
    return points


def stresses(options, test, strains, settings=()):
    """Of one test, where the program has these strains, in kPa."""
    furthest = max(strains, key=abs)
    fixed, moved = HELD.get(test, HELD["bar"])
    duration = abs(furthest) / RATE
    with tempfile.TemporaryDirectory() as directory:
        scene = pathlib.Path(directory) / "cube.prm"
        scene.write_text(CUBE)
        program.run(options, scene, pathlib.Path(directory) / "run",
                    (*program.QUIET, f"Support/Fixed components={fixed}",
                     f"Support/Displacements={moved.format(furthest)}",
                     f"Time/Steps={duration:.12g} : {STEPS[test]}",
                     f"Time/Load factor=0 : 0; {duration:.12g} : 1", *settings))
        lines = tables.read(pathlib.Path(directory) / "run" / "statistics.csv")
    found = {round(float(line["time"]) * RATE, 9): float(line["clamp_x"])
             for line in lines}
    return [found[round(abs(strain), 9)] for strain in strains]


def misfits(options, points, settings=()):
    """Differences of each test [kPa]."""
    return {test: [stress - measured for stress, (_, measured) in zip(
        stresses(options, test, [strain for strain, _ in of_test], settings), of_test)]
            for test, of_test in points.items()}


def root_mean_square(values):
    values = list(values)
    return math.sqrt(sum(value**2 for value in values) / len(values))


def relative(errors, points):
    """Root mean square of each test and of all, over the largest stress of all."""
    largest = max(abs(stress) for of_test in points.values() for _, stress in of_test)
    every = [error for of_test in errors.values() for error in of_test]
    return {**{test: root_mean_square(of_test) / largest
               for test, of_test in errors.items()},
            "all": root_mean_square(every) / largest}


def main():
    parser = program.parser(__doc__)
    parser.add_argument("--points", required=True)
    options = parser.parse_args()
    points = read_points(options.points)
    found = relative(misfits(options, points), points)
    print(", ".join(f"{test} {100 * value:.2f} %" for test, value in found.items()))
    if found["all"] >= LARGEST:
        sys.exit(f"the misfit must be below {100 * LARGEST:g} %")
    # The points tell laws apart: those without softening are worse.
    plain = relative(misfits(options, points,
                             ("Material/Viscous=", "Material/Law=isochoric neo-Hooke",
                              "Material/Young's modulus=28.5")), points)
    print(f"neo-Hooke {100 * plain['all']:.2f} %")
    if plain["all"] <= LARGEST:
        sys.exit("neo-Hooke must be further away than the preset")


if __name__ == "__main__":
    main()
