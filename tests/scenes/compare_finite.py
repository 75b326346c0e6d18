#!/usr/bin/env python3
# SPDX-License-Identifier: LGPL-2.1-or-later
"""The cube of Kakefuda et al. (1996) under finite strain, by the numbers that an
independent program found; and where it has no stable equilibrium.
"""

import pathlib
import re
import sys
import tempfile

import program
import tables

FINITE = "Deformation/Strain=finite"
E = "Material/Young's modulus="
RAMP = ("Division/Load control=ramp", "Yield/Check=every row")
HELD = "Support/Fixed boxes=0, 5, 10, 10, 5, 10 : x"
FINE = ("Body/Elements=4, 8, 4", "Cut/Surfaces=y:4", "Blade/Edge loads=uniform : 70")
WIDE = ("Body/Elements=2, 4, 4", "Cut/Surfaces=y:2", "Blade/Edge loads=uniform : 35",
        "Blade/Thickness=2")


def run(options, *settings):
    """What is said, and the lines of the solved states."""
    with tempfile.TemporaryDirectory() as directory:
        said = program.run(options, options.scene, directory,
                           (*program.QUIET, *settings))
        lines = tables.read(pathlib.Path(directory) / "statistics.csv")
    return said, [line for line in lines if line["event"] in ("deform", "divide")]


def check(name, found, expected, bound):
    error = abs(found - expected)
    print(f"{name}: {found:.7g}, expected {expected:.7g}")
    if not error <= bound:
        print(f"  FAILED: off by {error:.2g}, more than {bound:.2g}")
    return error <= bound


def check_states(options):
    """First state, second row, the end of the cut."""
    _, (first, second, divided) = run(options, FINITE)
    numbers = (("displacement", first, "max_displacement", 2.521915),
               ("stress", first, "cutting_stress", 1.933311),
               ("strain energy", first, "strain_energy", 84.977415),
               ("potential energy", first, "potential_energy", -86.945516),
               ("second row, displacement", second, "max_displacement", 2.16982),
               ("second row, stress", second, "cutting_stress", 1.11441))
    results = [check(name, float(line[column]), value, 1e-5 * abs(value))
               for name, line, column, value in numbers]
    # No force is left, and none to which round-off could be compared.
    results.append(check("divided, displacement",
                         float(divided["max_displacement"]), 0, 1e-10))
    _, (stiff, *_) = run(options, FINITE, E + "10")
    results.append(check("E = 10, stress", float(stiff["cutting_stress"]), 1.6035, 1e-4))
    _, (held, *_) = run(options, FINITE, E + "2.5", HELD)
    results.append(check("E = 2.5, held along the edge, displacement",
                         float(held["max_displacement"]), 5.3474, 1e-3))
    return results


def displacements(options, *settings):
    """Of all nodes in the first state."""
    with tempfile.TemporaryDirectory() as directory:
        program.run(options, options.scene, directory,
                    (*program.QUIET, "Output/Node tables=true", *settings))
        return [float(node[column]) for column in ("ux", "uy", "uz")
                for node in tables.read(pathlib.Path(directory) / "nodes_0001.csv")]


def check_small_loads(options):
    """Towards small loads the difference to small strain is of the first order."""
    results = []
    for part, expected in ((1e-3, 7.40e-5), (1e-4, 7.40e-6)):
        loads = f"Blade/Edge loads=0:{10 * part}, 5:{50 * part}, 10:{10 * part}"
        small, finite = (displacements(options, strain, loads)
                         for strain in ("Deformation/Strain=small", FINITE))
        difference = (max(abs(a - b) for a, b in zip(small, finite)) /
                      max(map(abs, small)))
        results.append(check(f"{part} of the load, difference to small strain",
                             difference, expected, .02 * expected))
    return results


def check_ramp(options):
    results = []
    for limit, force, displacement in ((1, 22.684, .8339), (2, 42.411, 1.5423)):
        _, (first, *_) = run(options, FINITE, *RAMP, f"Material/Shear limit={limit}")
        results.append(check(f"shear limit {limit}, force", float(first["blade_force"]),
                             force, 1e-3))
        results.append(check(f"shear limit {limit}, displacement",
                             float(first["max_displacement"]), displacement, 1e-4))
    return results


def check_wide_blade(options):
    _, states = run(options, FINITE, E + "10", *WIDE)
    expected = (1.238, 1.060, 1.208, 1.249, 1.214, 1.135, 1.104)
    return [check(f"blade of 2 cm, row {row + 2}, displacement",
                  float(states[row + 1]["max_displacement"]), value, 1e-3)
            for row, value in enumerate(expected)]


def check_instability(options):
    """Loads that no stable state carries."""
    said, _ = run(options, FINITE, E + "2.5")
    soft = re.search(r"Arrest in row 1: .* beyond (\S+) of the way", said)
    along = re.search(r"gives way along \((\S+),", said)
    results = [check("E = 2.5, part of the load", float(soft[1]), .725, .01),
               check("E = 2.5, gives way along x", abs(float(along[1])), 1, .2)]
    said, _ = run(options, FINITE, *FINE)
    crushed = re.search(r"beyond (\S+) of the way.*Element (\d+) is pressed", said)
    results.append(check("4 x 8 x 4 elements under a line, part of the load",
                         float(crushed[1]), .58, .01))
    return results


def main():
    parser = program.parser(__doc__)
    parser.add_argument("--scene", required=True)
    options = parser.parse_args()
    results = [result for part in (check_states, check_small_loads, check_ramp,
                                   check_wide_blade, check_instability)
               for result in part(options)]
    if not all(results):
        sys.exit("FAILED")


if __name__ == "__main__":
    main()
