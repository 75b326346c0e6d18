#!/usr/bin/env python3
# SPDX-License-Identifier: LGPL-2.1-or-later
"""A wedge through gel under finite strain, by the numbers of an independent program
(half of the block, contact by penalty at nodes or Gauss points); and as plane strain
and a slab in space, with small travel and as the linear theory has it, and one half as
the mirror image of the other.
"""

import pathlib
import sys
import tempfile

import gel_mesh
import program
import tables

GEL = "finite_gel.prm"
BLOCK = "finite_wedge.prm"
SMALL = "Deformation/Strain=small"
SLAB = (("Dimension = 2", "Dimension = 3"), ("= 12, 8", "= 12, 1, 8"),
        ("= 6, 8", "= 6, 1, 8"),
        ("Fixed faces = bottom", "Fixed faces = bottom\n"
         "  set Fixed components = front : y; back : y"))


def run(options, scene, *settings, changes=(), table="statistics.csv"):
    """A table of a run, of a scene with some text replaced."""
    with tempfile.TemporaryDirectory() as directory:
        directory = pathlib.Path(directory)
        text = (pathlib.Path(options.scenes) / scene).read_text()
        for old, new in changes:
            assert old in text
            text = text.replace(old, new)
        (directory / scene).write_text(text)
        if scene == GEL:
            gel_mesh.write(directory / "gel.msh", 1.)
        program.run(options, directory / scene, directory / "results",
                    (*program.QUIET, *settings))
        return tables.read(directory / "results" / table)


def check(name, found, expected, bound):
    """Whether two numbers agree up to a part of the second."""
    print(f"{name}: {found:.7g}, expected {expected:.7g}")
    if not abs(found - expected) <= bound * abs(expected):
        print(f"  FAILED: off by more than {bound:.2g} of that")
        return False
    return True


def number(line, column):
    return float(line[column])


def split_of(lines):
    """The first split: before and behind it."""
    at = next(i for i, line in enumerate(lines) if line["event"] == "release")
    return lines[at - 1], lines[at]


def check_split(options):
    """The split that makes the crack 4 mm deep, and that of 8 mm."""
    before, behind = split_of(run(options, GEL, "Cut/Notch=3", "Blade/Travel=4.3"))
    results = [
        check("4 mm, travel", number(before, "travel"), 4.215, 0.01),
        check("4 mm, force before", number(before, "blade_force"), 8.85e-3, 0.01),
        check("4 mm, force behind", number(behind, "blade_force"), 2.86e-3, 0.01)]
    stored = sum(number(behind, column)
                 for column in ("strain_energy", "surface_energy", "excess_energy"))
    results.append(check("4 mm, energy over work", stored, number(behind, "work"), 0.01))
    before, behind = split_of(run(options, GEL, "Cut/Notch=7", "Blade/Travel=8.05",
                                     "Blade/Advance=1"))
    mean = (number(before, "blade_force") + number(behind, "blade_force")) / 2
    results.append(check("8 mm, mean force", mean, 6.08e-3, 0.01))
    return results


def check_friction(options):
    """A crack of 8 mm, and the edge at 4 mm."""
    forces = []
    for friction in (0, 0.1, 0.3):
        line = run(options, GEL, "Cut/Notch=8", "Blade/Travel=4",
                   "Material/Toughness=1", f"Blade/Friction={friction}")[-1]
        forces.append(number(line, "blade_force"))
    return [check("force with friction 0.1 over that without", forces[1] / forces[0],
                  1.653, 0.02),
            check("with friction 0.3", forces[2] / forces[0], 3.208, 0.02)]


def check_slab(options):
    """A slab between two walls is plane strain."""
    settings = ("Blade/Travel=2.5",)
    results = []
    for plane, slab in zip(run(options, BLOCK, *settings),
                           run(options, BLOCK, *settings, changes=SLAB), strict=True):
        if number(plane, "travel") == 0:
            continue
        for column in ("travel", "blade_force", "strain_energy"):
            results.append(check(f"slab, {plane['event']}, {column}",
                                 number(slab, column), number(plane, column), 1e-7))
    return results


def check_mirror(options):
    """Both halves of a block that is cut in the middle; nodes of the two walls have the
    same place. Half of it cannot be run: the blade goes through a cut."""
    nodes = run(options, BLOCK, "Blade/Friction=0.1", "Blade/Travel=4",
                "Output/Node tables=true", table="nodes_0005.csv")
    at = {}
    for node in nodes:
        x, y, u, v = (number(node, column) for column in ("x", "y", "ux", "uy"))
        at.setdefault((x, y), []).append((u, v))
    largest = max(abs(number(node, "uy")) for node in nodes)
    differences = [abs(a - b) for (x, y), moved in at.items()
                   for one, other in zip(sorted(moved), sorted(
                       (-u, v) for u, v in at[12 - x, y]), strict=True)
                   for a, b in zip(one, other)]
    return [check("mirror image, 1 + largest difference",
                  1 + max(differences) / largest, 1, 1e-8)]


def check_small_travel(options):
    """Where the blade has travelled little the linear theory differs by a part that
    goes with the travel."""
    def difference(travel):
        settings = (f"Blade/Travel={travel}", "Cut/Notch=0")
        finite, small = (number(run(options, BLOCK, *settings, *strain)[-1],
                                "blade_force") for strain in ((), (SMALL,)))
        print(f"travel {travel}: force {finite:.8g}, linear {small:.8g}")
        return finite / small - 1

    return [check("difference to the linear theory, tenfold travel over single",
                  difference(0.02) / difference(0.002), 10, 0.1)]


def main():
    parser = program.parser(__doc__)
    parser.add_argument("--scenes", required=True)
    options = parser.parse_args()
    results = [*check_split(options), *check_friction(options), *check_slab(options),
               *check_mirror(options), *check_small_travel(options)]
    return 0 if all(results) else 1


if __name__ == "__main__":
    sys.exit(main())
