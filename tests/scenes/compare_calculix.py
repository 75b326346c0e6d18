#!/usr/bin/env python3
"""Let CalculiX solve every state of a scene again, from the decks that the program
writes, and compare all displacements to 1e-6 of the state's largest.

Where CalculiX (ccx) is missing the test is skipped.
"""

import pathlib
import shutil
import subprocess
import sys
import tempfile

import program
import tables

TOLERANCE = 1e-6
SKIPPED = 77


def solve(deck):
    """The displacements that ccx finds, by number of node."""
    result = subprocess.run(["ccx", deck.stem], cwd=deck.parent, capture_output=True,
                            text=True)
    if result.returncode != 0 or "*ERROR" in result.stdout:
        sys.exit(f"ccx {deck.name}: {result.stdout[-2000:]}{result.stderr}")
    displacements = {}
    for line in deck.with_suffix(".dat").read_text().splitlines():
        words = line.split()
        if len(words) == 4 and words[0].isdigit():
            displacements[int(words[0])] = [float(word) for word in words[1:]]
    return displacements


def compare(deck):
    """The largest difference relative to the largest displacement."""
    rows = tables.read(deck.with_suffix(".csv"))
    expected = {int(row["node"]): [float(row[u]) for u in ("ux", "uy", "uz")]
                for row in rows}
    found = solve(deck)
    if found.keys() != expected.keys():
        sys.exit(f"{deck.name}: ccx gives {len(found)} nodes of {len(expected)}")
    largest = max(abs(u) for node in expected.values() for u in node)
    error = max(tables.relative_error(u, v, largest) for node in expected
                for u, v in zip(found[node], expected[node]))
    print(f"{deck.name}: {len(rows)} nodes, largest displacement {largest:.3g}, "
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
