# SPDX-License-Identifier: LGPL-2.1-or-later
"""What the measurements say of a cluster."""

import math

# A network as clusters have it today: seconds for a message on its way, bytes per second
# and process.
LATENCY = 2e-6
BANDWIDTH = 2e9
UNKNOWNS = 1e9


def predict(alone, parted, n_processes):
    """Seconds for 10^9 unknowns.

    alone: a measured solve on one process. parted: one on several, all neighbours of each
    other, from which messages, bytes and collectives of an iteration are taken.
    """
    own = UNKNOWNS / n_processes
    per_unknown = alone["solve"] / alone["iterations"] / alone["unknowns"]
    # What is said grows with the surface of what a process has. In a part of 8 each
    # has three of six faces inside the body, in a large machine all six.
    surface = 2 * (own / (parted["unknowns"] / parted["processes"])) ** (2 / 3)
    bytes_said = parted["bytes"] * surface
    # 7 neighbours among 8 processes, 26 inside a large machine.
    messages = parted["messages"] * 26 / 7
    collectives = parted["collectives"] * 2 * math.log2(n_processes)
    iteration = {"work": per_unknown * own, "bytes": bytes_said / BANDWIDTH,
                 "messages": messages * LATENCY, "collectives": collectives * LATENCY}
    set_up = alone["set_up"] / alone["unknowns"] * own
    return iteration, set_up


def table_of(alone, parted, counts):
    rows = []
    for n in counts:
        iteration, set_up = predict(alone, parted, n)
        each = sum(iteration.values())
        rows.append([n, f"{UNKNOWNS / n:.2g}",
                     f"{alone['memory'] / alone['unknowns'] * UNKNOWNS / n / 1024:.1f}",
                     *(f"{100 * part / each:.0f} %" for part in iteration.values()),
                     f"{set_up:.1f}", f"{each * alone['iterations']:.1f}",
                     f"{100 * iteration['work'] / each:.0f} %"])
    return rows
