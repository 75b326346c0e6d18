# SPDX-License-Identifier: LGPL-2.1-or-later
"""Tables of results: reading, and comparing number by number."""

import csv


def read(path):
    with open(path, newline="") as table:
        return list(csv.DictReader(table))


def relative_error(value, expected, scale=0.0):
    """The difference relative to the expected value or, if larger, a scale."""
    size = max(abs(expected), scale)
    return abs(value - expected) / size if size > 0 else abs(value)
