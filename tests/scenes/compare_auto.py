#!/usr/bin/env python3
# SPDX-License-Identifier: LGPL-2.1-or-later
"""A cut with Deformation/Strain = auto is that of small strain up to the state that
leaves Material/Linear range, and that of finite strain from there on, since states of
an elastic body do not depend on how it came to them. It says so once. And the end of a
run counts the states that small strain is not to be trusted in.
"""

import pathlib
import re
import sys
import tempfile

import program
import tables

NUMBERS = ("load_factor", "cutting_stress", "strain_energy", "potential_energy",
           "max_displacement", "max_strain", "max_shear")
KINDS = {"a ramp of the load": ("finite_auto",),
         "forces that are given": ("finite_auto", "Division/Load control=constant",
                                   "Blade/Edge loads=0 : 1"),
         "energies": ("finite_auto", "Yield/Criterion=energy release", "Load/Pressures=",
                      "Material/Toughness=0.01"),
          "a blade that travels": ("finite_wedge", "Material/Linear range=0.5",
                                  "Blade/Friction=0")}


def run(options, strain, scene, *settings):
    """What is said, and the lines of the solved states."""
    with tempfile.TemporaryDirectory() as directory:
        said = program.run(options, pathlib.Path(options.scenes) / f"{scene}.prm", directory,
                           (*program.QUIET, f"Deformation/Strain={strain}", *settings))
        lines = tables.read(pathlib.Path(directory) / "statistics.csv")
    return said, [line for line in lines if line["event"] in ("deform", "travel", "divide")]


def difference(line, other):
    """The largest of all numbers, relative to the larger of each two."""
    pairs = [(float(line[name]), float(other[name])) for name in NUMBERS]
    return max(tables.relative_error(a, b, max(abs(a), abs(b))) for a, b in pairs)


def compare(options, kind, settings):
    """Whether a run is made of the states of two others."""
    runs = {strain: run(options, strain, *settings)
            for strain in ("small", "finite", "auto")}
    said, states = runs["auto"]
    changes = re.findall(r"in frame (\d+) a principal strain of (\S+) exceeds "
                         r"Material/Linear range = (\S+): this state", said)
    if len(changes) != 1:
        sys.exit(f"{kind}: finite strain is taken {len(changes)} times:\n{said}")
    first, strain, linear_range = changes[0]
    kinds = ["small" if int(state["frame"]) < int(first) else "finite"
             for state in states]
    print(f"{kind}: " + ", ".join(kinds))
    if len(set(kinds)) != 2 or len(states) != len(runs["finite"][1]):
        sys.exit("there must be states of both kinds")
    for number, (state, taken) in enumerate(zip(states, kinds)):
        error = difference(state, runs[taken][1][number])
        bound = {"small": 0, "finite": 1e-7}[taken]
        if not error <= bound:
            sys.exit(f"state {number + 1} differs from {taken} strain by {error:.1e}")
        if taken == "small" and float(state["max_strain"]) > float(linear_range):
            sys.exit(f"state {number + 1} is beyond the linear range")
    check_report(runs, strain, float(linear_range))


def check_report(runs, first_strain, linear_range):
    """The last lines of all three."""
    for strain in ("finite", "auto"):
        if "Linear range" in runs[strain][0].splitlines()[-1]:
            sys.exit(f"{strain} strain has no linear range to leave")
    said, states = runs["small"]
    strains = [float(state["max_strain"]) for state in states]
    beyond = [strain for strain in strains if strain > linear_range]
    expected = (f"strain of up to {max(strains):.3g} beyond Material/Linear range in "
                f"{len(beyond)}")
    if expected not in said.splitlines()[-1]:
        sys.exit(f"not '{expected}' at the end: {said.splitlines()[-1]}")
    if f"{beyond[0]:.3g}" != first_strain:
        sys.exit(f"the change is said to be at {first_strain}, not {beyond[0]:.3g}")


def main():
    parser = program.parser(__doc__)
    parser.add_argument("--scenes", required=True)
    options = parser.parse_args()
    for kind, settings in KINDS.items():
        compare(options, kind, settings)


main()
