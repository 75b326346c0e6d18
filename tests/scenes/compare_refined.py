#!/usr/bin/env python3
# SPDX-License-Identifier: LGPL-2.1-or-later
"""Refinement near the cut against refinement everywhere.

The body is cut row by row on its own elements, on elements refined near the cut,
and on elements refined everywhere. At states of equal depth the displacements of
the nodes that all three have are compared: what refinement everywhere changes is
the estimated error of the unrefined body, and refinement near the cut must differ
from refinement everywhere by a given part of it at most.
"""

import pathlib
import sys
import tempfile

import program
import tables

LARGEST_PART = 0.05


def run(options, settings):
    """The displacements of the body's own nodes, by depth of the front, number
    and side."""
    with tempfile.TemporaryDirectory() as directory:
        program.run(options, options.scene, directory,
                    ("Output/Node tables=true", *program.QUIET, *settings))
        states = {}
        for line in tables.read(pathlib.Path(directory) / "statistics.csv"):
            if line["event"] == "deform":
                nodes = tables.read(pathlib.Path(directory) /
                                    f"nodes_{int(line['frame']):04}.csv")
                states[line["depth"]] = {
                    (node["number"], node["side"]):
                    [float(node[u]) for u in ("ux", "uy", "uz")] for node in nodes}
        return states


def difference(state, other, nodes):
    return max(abs(a - b) for node in nodes for a, b in zip(state[node], other[node]))


def main():
    parser = program.parser(__doc__)
    parser.add_argument("--scene", required=True)
    options = parser.parse_args()

    near = "Cut/Refinement near cut="
    coarse = run(options, [near + "0"])
    local = run(options, [near + "1"])
    everywhere = run(options, [near + "0", "Body/Refinement=1"])
    depths = [depth for depth in coarse if depth in local and depth in everywhere]
    if len(depths) < 2:
        sys.exit("there are no states of equal depth")
    failed = False
    for depth in depths:
        nodes = coarse[depth].keys() & local[depth].keys() & everywhere[depth].keys()
        if len(nodes) < len(coarse[depth]):
            sys.exit(f"{len(coarse[depth]) - len(nodes)} nodes are missing")
        estimate = difference(coarse[depth], everywhere[depth], nodes)
        error = difference(local[depth], everywhere[depth], nodes)
        print(f"depth {depth}: {len(nodes)} nodes, estimated error {estimate:.3g}, "
              f"refined near the cut {error:.3g}, part {error / estimate:.2f}")
        failed = failed or not error <= LARGEST_PART * estimate
    sys.exit(1 if failed else 0)


main()
