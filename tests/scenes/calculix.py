# SPDX-License-Identifier: LGPL-2.1-or-later
"""CalculiX on the decks that the program writes."""

import tables


def displacements(deck):
    """The displacements that ccx has found for a deck, by number of node."""
    found = {}
    with open(deck.with_suffix(".dat")) as lines:
        for line in lines:
            words = line.split()
            if len(words) == 4 and words[0].isdigit():
                found[int(words[0])] = [float(word) for word in words[1:]]
    return found


def compare(deck, own):
    """How many nodes a deck has, the largest displacement in the program's own table of
    them, and the largest difference from it relative to that."""
    expected = {int(row["node"]): [float(row[u]) for u in ("ux", "uy", "uz")]
                for row in tables.read(own)}
    found = displacements(deck)
    if found.keys() != expected.keys():
        raise RuntimeError(f"{deck.name}: ccx gives {len(found)} nodes of {len(expected)}")
    largest = max(abs(u) for node in expected.values() for u in node)
    error = max(tables.relative_error(u, v, largest) for node in expected
                for u, v in zip(found[node], expected[node]))
    return len(expected), largest, error
