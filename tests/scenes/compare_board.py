#!/usr/bin/env python3
# SPDX-License-Identifier: LGPL-2.1-or-later
"""A board against what it must be the same as: it carries the weight and the
blade's force in all states of a cut; under a block that is pressed down it has the
force of another program.
"""

import pathlib
import sys
import tempfile

import program
import tables

WEIGHT = 60 * 40 * 0.01
WEDGE = ("Blade/Shape=wedge", "Blade/Wedge angle=20", "Blade/Thickness=2",
         "Blade/Shoulder radius=4", "Blade/Friction=0.1")
# GetFEM, contact as an integral over the bottom: linear elasticity, and isochoric
# neo-Hooke.
FORCE_OF_GETFEM = 50.657
FINITE_FORCE_OF_GETFEM = 56.0949
FINITE = "Deformation/Strain=finite"


def balance(run):
    """The board carries the block and what the blade presses."""
    for name, strain, settings in (("thin blade", (), ()), ("wedge", (), WEDGE),
                                   ("thin blade, finite strain", (FINITE,), ())):
        lines = run("board_cut", *strain, *settings)[1:]
        error = max(abs(float(line["board_force"]) - WEIGHT - float(line["blade_force"]))
                    for line in lines) / WEIGHT
        yield f"weight and {name}", error <= 1e-8, error
        last = lines[-1]
        yield f"weight of both pieces, {name}", last["pieces"] == "2" and abs(
            float(last["board_force"]) / WEIGHT - 1) <= 1e-8, float(last["board_force"])
        largest = max(float(line["blade_force"]) for line in lines)
        yield f"with a force of the {name}", largest > WEIGHT, largest


def block(run):
    """A block that slides on the board while it is pressed down."""
    last = run("board_plane", "Body/Elements=10,10,10")[-1]
    error = abs(float(last["board_force"]) / FORCE_OF_GETFEM - 1)
    yield "force of another program", error <= 1e-3, error
    error = abs(float(last["board_force"]) + float(last["clamp_z"]))
    yield "support and board", error <= 1e-8, error
    # Where supports hold what would lie on the board it does nothing.
    rollers = ("Support/Displacements=", "Support/Fixed faces=left",
               "Support/Fixed boxes=-1,-1,-1,11,11,0.01:z", "Load/Body force=0.01,0,0")
    with_board, without = (
        float(run("board_plane", *plane, *rollers)[-1]["max_displacement"])
        for plane in ((), ("Board/Plane=", "Board/Friction=0.5")))
    error = abs(with_board / without - 1)
    yield "rollers in place of the board", error <= 1e-12, error


def finite_block(run):
    """The same under finite strain, and in closed form where nothing bulges."""
    last = run("board_plane", "Body/Elements=10,10,10", FINITE,
               "Material/Law=isochoric neo-Hooke",
               "Material/Volumetric energy=quadratic")[-1]
    error = abs(float(last["board_force"]) / FINITE_FORCE_OF_GETFEM - 1)
    yield "finite strain: force of another program", error <= 1e-6, error
    # mu (l - 1 / l) at l = 0.9 on an area of 100, all of whose corners touch.
    last = run("board_plane", "Body/Elements=2,2,2", FINITE,
               "Material/Poisson's ratio=0")[-1]
    error = abs(float(last["board_force"]) / (2.5 * 100 * (1 / 0.9 - 0.9)) - 1)
    yield "finite strain: closed form", error <= 1e-9, error


def end(run):
    """A blade that the toughness stops is stopped by the board at the latest."""
    lines, said = run("board_cut", "Material/Toughness=1e6", said=True)
    travel = float(lines[-1]["travel"])
    yield "a blade on the board", lines[-1]["event"] == "arrest" and \
        "edge is on the board" in said and 40 <= travel <= 40.4 + 1e-9, travel
    lines, said = run("board_cut", "Support/Fixed faces=bottom", said=True)
    yield "a board that does nothing, states", "the board does nothing" in said, len(lines)
    lines, said = run("board_cut", said=True)
    yield "one that carries, states", "the board does nothing" not in said, len(lines)


def main():
    parser = program.parser(__doc__)
    parser.add_argument("--scenes", required=True)
    options = parser.parse_args()
    failed = False
    with tempfile.TemporaryDirectory() as directory:
        def run(scene, *settings, said=False):
            text = program.run(options, pathlib.Path(options.scenes) / f"{scene}.prm",
                               directory, (*program.QUIET, *settings))
            lines = tables.read(pathlib.Path(directory) / "statistics.csv")
            return (lines, text) if said else lines
        for check in (balance, block, finite_block, end):
            for what, holds, value in check(run):
                print(f"{'' if holds else 'FAILED: '}{what}: {value:.3g}")
                failed = failed or not holds
    sys.exit(1 if failed else 0)


main()
