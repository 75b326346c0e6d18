#!/usr/bin/env python3
# SPDX-License-Identifier: LGPL-2.1-or-later
"""The decks of CalculiX that several processes write are those of one: the same
nodes, elements and equations, and the same numbers to 1e-9 of the largest."""

import pathlib
import sys
import tempfile

import program
import tables

TOLERANCE = 1e-9


def write_decks(options, processes, directory):
    program.run(options, options.scene, directory,
                ("Output/CalculiX decks=true", *program.QUIET), processes)
    return {path.name: path for path in pathlib.Path(directory).glob("stage_*")}


def read_values(lines):
    """Numbers of a block: by node, by node and component, or by the dependent
    unknown and the terms of an equation."""
    words = [word.strip() for line in lines for word in line.split(",") if word.strip()]
    keyword = lines[0].split(",")[0].strip()
    words = words[len(lines[0].split(",")):]
    if keyword == "*EQUATION":
        terms = [tuple(words[i:i + 2]) for i in range(1, len(words), 3)]
        return {(keyword, terms[0], term): float(words[3 + 3 * i])
                for i, term in enumerate(terms)}
    n_keys = {"*NODE": 1, "*BOUNDARY": 3, "*CLOAD": 2}[keyword]
    values = {}
    for line in lines[1:]:
        entries = [entry.strip() for entry in line.split(",")]
        for i, value in enumerate(entries[n_keys:]):
            values[(keyword, *entries[:n_keys], i)] = float(value)
    return values


def read_deck(path):
    """All numbers of a deck by what they belong to, and the rest as text."""
    blocks = []
    for line in path.read_text().splitlines():
        if line.startswith("*") and not line.startswith("**"):
            blocks.append([])
        if not line.startswith("**"):
            blocks[-1].append(line)
    values, text = {}, []
    for block in blocks:
        if block[0].split(",")[0] in ("*NODE", "*BOUNDARY", "*CLOAD", "*EQUATION"):
            values.update(read_values(block))
        else:
            text.append(block)
    return values, text


def compare(path, other):
    (values, text), (others, other_text) = read_deck(path), read_deck(other)
    if text != other_text:
        sys.exit(f"{path.name}: elements or materials differ")
    # A force that is 0 on one side may be a sum that cancels to noise on the other.
    differing = {key for key in values.keys() ^ others.keys() if key[0] != "*CLOAD"}
    if differing:
        sys.exit(f"{path.name}: {sorted(map(str, differing))[:3]} differ")
    largest = 0
    for keyword in {key[0] for key in values}:
        keys = [key for key in values.keys() | others.keys() if key[0] == keyword]
        scale = max(abs(values.get(key, 0)) for key in keys)
        largest = max(largest, *(tables.relative_error(values.get(key, 0),
                                                       others.get(key, 0), scale)
                                 for key in keys))
    return largest


def main():
    parser = program.parser(__doc__)
    parser.add_argument("--scene", required=True)
    options = parser.parse_args()
    with tempfile.TemporaryDirectory() as one, tempfile.TemporaryDirectory() as many:
        decks = write_decks(options, 1, one)
        others = write_decks(options, options.processes, many)
        if decks.keys() != others.keys() or not decks:
            sys.exit(f"{len(decks)} files on one process and {len(others)} on several")
        largest = max(compare(decks[name], others[name])
                      for name in decks if name.endswith(".inp"))
    print(f"{len(decks) // 2} decks agree to {largest:.1e}")
    if not largest <= TOLERANCE:
        sys.exit(f"which exceeds {TOLERANCE}")


main()
