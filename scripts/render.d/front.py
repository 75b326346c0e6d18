# SPDX-License-Identifier: LGPL-2.1-or-later
"""The line of the row that a blade is about to cut."""

import numpy as np

GAP = 3.0  # a step of so many usual ones separates two lines
FINE = 16  # points of a line that show how it is bent


def ordered_front(points, direction, normal):
    """Lines through a row's nodes, in order."""
    grain = 1e-5 * max(np.ptp(points, axis=0).max(), 1e-300)
    _, first = np.unique(np.round(points / grain), axis=0, return_index=True)
    points = points[first]
    order = chain(points, np.cross(normal, direction))
    return [points[part] for part in split(points, order)]


def refined(line):
    """A line of few points, with more between them."""
    steps = max(1, FINE // len(line))
    t = np.linspace(0, 1, steps, endpoint=False)[:, None]
    between = [start + t * (end - start) for start, end in zip(line, line[1:])]
    return np.vstack([*between, line[-1:]])


def chain(points, along):
    """An order from one end, from each point to the nearest that is left."""
    left = np.ones(len(points), bool)
    order = [int(np.argmin(points @ along))]
    left[order[0]] = False
    while left.any():
        distance = np.linalg.norm(points - points[order[-1]], axis=1)
        order.append(int(np.argmin(np.where(left, distance, np.inf))))
        left[order[-1]] = False
    return order


def split(points, order):
    """The chain's parts, a ring closed."""
    if len(order) < 3:
        return [order]
    steps = np.linalg.norm(np.diff(points[order], axis=0), axis=1)
    usual = GAP * np.median(steps)
    ends = np.flatnonzero(steps > usual) + 1
    parts = [list(part) for part in np.split(order, ends)]
    if len(parts) == 1 and len(order) > 3 and \
            np.linalg.norm(points[order[0]] - points[order[-1]]) < 1.5 * steps.max():
        parts[0].append(order[0])
    return parts
