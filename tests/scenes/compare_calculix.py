#!/usr/bin/env python3
# SPDX-License-Identifier: LGPL-2.1-or-later
"""Let CalculiX solve every state of a scene again, from the decks that the program
writes, and compare all displacements to 1e-6 of the state's largest.

Where CalculiX (ccx) is missing the test is skipped.
"""

import pathlib
import shutil
import subprocess
import sys
import tempfile

import calculix
import program
import tables

TOLERANCE = 1e-6
SKIPPED = 77


def compare(deck):
    """Let ccx solve a deck: the largest difference relative to the largest
    displacement."""
    result = subprocess.run(["ccx", deck.stem], cwd=deck.parent, capture_output=True,
                            text=True)
    if result.returncode != 0 or "*ERROR" in result.stdout:
        sys.exit(f"ccx {deck.name}: {result.stdout[-2000:]}{result.stderr}")
    n_nodes, largest, error = calculix.compare(deck, deck.with_suffix(".csv"))
    print(f"{deck.name}: {n_nodes} nodes, largest displacement {largest:.3g}, "
          f"largest difference {error:.1e} of it")
    return error


def main():
    parser = program.parser(__doc__)
    parser.add_argument("--scene", required=True)
    parser.add_argument("--set", action="append", default=[], dest="settings")
    options = parser.parse_args()
    if shutil.which("ccx") is None:
        print("skipped: there is no ccx")
        sys.exit(SKIPPED)

    with tempfile.TemporaryDirectory() as directory:
        program.run(options, options.scene, directory,
                    ("Output/CalculiX decks=true", *program.QUIET, *options.settings))
        directory = pathlib.Path(directory)
        states = {int(line["frame"]) for line in
                  tables.read(directory / "statistics.csv")} - {0}
        decks = sorted(directory.glob("stage_*.inp"))
        if len(decks) != len(states):
            sys.exit(f"{len(decks)} decks for {len(states)} states")
        largest = max(compare(deck) for deck in decks)
    if not largest <= TOLERANCE:
        sys.exit(f"the largest difference {largest:.1e} exceeds {TOLERANCE}")


main()
