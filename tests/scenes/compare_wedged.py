#!/usr/bin/env python3
# SPDX-License-Identifier: LGPL-2.1-or-later
"""A blade that only pushes (Division/Split rows = wedged) against what it must be
the same as, in variations of one scene: no blade where the cut gapes by more than
the blade is thick, a prescribed opening where it presses everywhere, and its own
loads and energies by another way.
"""

import pathlib
import sys
import tempfile

import program
import tables

SAME = 1e-9
# The halves are pressed together, so that the blade touches them everywhere.
PRESSED = ("Support/Fixed faces=bottom", "Support/Displacements=",
           "Load/Pressures=left:0.6; right:0.6")
# With linear elements there are as many conditions as there are pairs of nodes.
LINEAR = "Body/Element type=linear"
SHEAR = "Yield/Criterion=maximum shear"
NUMBERS = ("load_factor", "cutting_stress", "opening_force", "strain_energy",
           "potential_energy", "max_displacement", "max_shear")


class Runs:
    """Runs of variations of the scene."""

    def __init__(self, options, directory):
        self.options = options
        self.directory = directory

    def __call__(self, rows, *settings):
        """The table of a run, and the displacements of all of its states in which a row
        is judged."""
        program.run(self.options, self.options.scene, self.directory,
                    ("Output/Node tables=true", *program.QUIET,
                     f"Division/Split rows={rows}", *settings))
        lines = [line for line in tables.read(self.directory / "statistics.csv")
                 if line["event"] == "deform"]
        nodes = [tables.read(self.directory / f"nodes_{int(line['frame']):04}.csv")
                 for line in lines]
        return lines, [[float(node[u]) for state in nodes for node in state]
                       for u in ("ux", "uy")]

    def deform(self, rows, *settings):
        """The numbers of these states."""
        return [{column: float(value or "nan") for column, value in line.items()
                 if column not in ("event", "row_pieces")}
                for line in self(rows, *settings)[0]]


def difference(one, other):
    """The largest difference of two runs, relative to the largest value."""
    def of(values, others):
        scale = max(map(abs, others))
        return max(tables.relative_error(a, b, scale) for a, b in zip(values, others))
    if len(one[0]) != len(other[0]):
        return float("inf")
    columns = ([[float(line[column]) for line in lines] for lines in (one[0], other[0])]
               for column in NUMBERS)
    return max([of(*pair) for pair in columns] + [of(*pair) for pair in zip(one[1], other[1])])


def thin_blade(run):
    """It has no part in a cut that gapes by more than it is thick; a prescribed
    opening pulls the walls together, and takes the stress from the front."""
    settings = (SHEAR, "Blade/Thickness=0.001", "Blade/Edge loads=0:0.01",
                "Division/Load control=constant", "Blade/Sharpness=0.999")
    error = difference(run("wedged", *settings), run("free", *settings))
    wedged, opened = (run.deform(rows, *settings) for rows in ("wedged", "opened"))
    yield "as a free cut that gapes", error <= SAME, error
    yield "no force", all(line["opening_force"] == 0 for line in wedged), 0
    ratio = wedged[3]["cutting_stress"] / opened[3]["cutting_stress"]
    yield "where an opening pulls", opened[3]["opening_pull"] > 0 and ratio > 3, ratio


def pressed(run):
    """Where all walls press on the blade it keeps them just its thickness apart."""
    for release in ("node row", "element row"):
        settings = (SHEAR, LINEAR, *PRESSED, f"Division/Release={release}")
        error = difference(run("wedged", *settings), run("opened", *settings))
        yield f"as a prescribed opening, {release}", error <= SAME, error
    # With mid-side nodes it is only a mean that is kept. What obeys an opening obeys
    # that too, and what obeys that is allowed to a free cut: so their minima follow.
    settings = (SHEAR, *PRESSED, "Division/Load control=constant", "Blade/Sharpness=1")
    free, wedged, opened = ([line["potential_energy"] for line in
                             run.deform(rows, *settings)][1:]
                            for rows in ("free", "wedged", "opened"))
    part = max((b - a) / (b - c) for a, b, c in zip(wedged, opened, free))
    yield "between a free cut and an opening", all(
        c < a < b for a, b, c in zip(wedged, opened, free)), part
    yield "nearer to that", part <= 0.2, part


def without_thickness(run):
    """Walls that would pass through each other touch."""
    settings = (SHEAR, LINEAR, *PRESSED, "Blade/Thickness=0")
    free, wedged = (run.deform(rows, *settings)[-2] for rows in ("free", "wedged"))
    yield "free walls overlap", free["overlap"] > 0.1, free["overlap"]
    yield "others do not", wedged["overlap"] <= SAME, wedged["overlap"]
    yield "but press", wedged["opening_force"] > 0.1, wedged["opening_force"]


def ramp(run):
    """The load factor at which a row yields, as loads a little above and below it
    say that do not rise."""
    zone = "Yield/Process zone=3"
    part = 1e-8
    for criterion in ("maximum shear", "von Mises", "traction on the cut", "mean shear"):
        settings = (f"Yield/Criterion={criterion}", zone, *PRESSED)
        row = 3
        found = run.deform("wedged", *settings)[row]

        def reached(factor):
            constant = ("Division/Load control=constant", "Blade/Sharpness=1",
                        f"Blade/Edge loads=0:{factor:.17g}")
            return run.deform("wedged", *settings, *constant)[row]["cutting_stress"]

        below, above = (reached(found["load_factor"] * (1 + sign * part))
                        for sign in (-1, 1))
        yield f"yields at its load, {criterion}", (
            below < found["required_stress"] < above), found["load_factor"]


def energy(run):
    """What is set free is the difference of the potential energies of states that
    other runs find, and the work of the load on its way to the next front."""
    found = run.deform("wedged")
    touched = 0
    for row in range(4):
        factor, length = (found[row]["load_factor"],
                          found[row + 1]["depth"] - found[row]["depth"])
        constant = (SHEAR, "Division/Load control=constant", "Blade/Sharpness=1",
                    f"Blade/Edge loads=0:{factor:.17g}")
        before, after = run.deform("wedged", *constant)[row:row + 2]
        touched += after["opening_force"] > 0
        released = (before["potential_energy"] - after["potential_energy"] +
                    factor * length) / length
        error = abs(released / found[row]["required_stress"] - 1)
        yield f"the energy that row {row} sets free", error <= 1e-8, error
    yield "with contact", touched > 0, touched


def main():
    parser = program.parser(__doc__)
    parser.add_argument("--scene", required=True)
    options = parser.parse_args()
    failed = False
    with tempfile.TemporaryDirectory() as directory:
        run = Runs(options, pathlib.Path(directory))
        for check in (thin_blade, pressed, without_thickness, ramp, energy):
            for what, holds, value in check(run):
                print(f"{'' if holds else 'FAILED: '}{what}: {value:.3g}")
                failed = failed or not holds
    sys.exit(1 if failed else 0)


main()
