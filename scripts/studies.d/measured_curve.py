# SPDX-License-Identifier: LGPL-2.1-or-later
"""A measured force-travel curve, and what of a run is compared with it."""

import csv
import math
import re

import numpy as np
from program import Refusal

# Meters and newtons of the units that the program knows (source/material/presets.cc).
LENGTHS = {"m": 1., "cm": 1e-2, "mm": 1e-3, "um": 1e-6}
FORCES = {"N": 1., "kN": 1e3, "mN": 1e-3, "uN": 1e-6, "gf": 9.80665e-3, "kgf": 9.80665}
COLUMNS = ("travel", "force")


def read_curve(path, parameters):
    """Travels and forces of a table, in the units of a scene with these parameters.

    Raises Refusal where something is wrong with it."""
    try:
        with open(path, newline="", encoding="utf-8-sig") as file:
            lines = [(number, [word.strip() for word in next(csv.reader([line]))])
                     for number, line in enumerate(file, 1)
                     if line.strip() and not line.startswith("#")]
    except OSError as error:
        raise Refusal(f"'{path}' cannot be read: {error.strerror}") from error
    except UnicodeDecodeError as error:
        raise Refusal(f"'{path}' is no text: {error}") from error
    if not lines:
        raise Refusal(f"'{path}' is empty")
    places, factors = columns_of(path, lines[0][1], parameters)
    curve = []
    for number, words in lines[1:]:
        point = [number_of(path, number, words, place) * factor
                 for place, factor in zip(places, factors)]
        if curve and point[0] <= curve[-1][0]:
            raise Refusal(f"{path}:{number}: the travel '{words[places[0]]}' must be more "
                          "than that of the point before")
        curve.append(point)
    return np.array(curve).reshape(-1, 2).T


def columns_of(path, words, parameters):
    """Where the columns are, and what their numbers are multiplied with."""
    units = {}
    for place, word in enumerate(words):
        found = re.fullmatch(r"(\w+)\s*(?:\[(.*)\])?", word)
        if found and found[1] in COLUMNS:
            units[found[1]] = place, (found[2] or "").strip()
    for name in COLUMNS:
        if name not in units or not units[name][1]:
            raise Refusal(f"'{path}' has no column '{name} [UNIT]'; its first line must "
                          "name both columns with their units, such as "
                          "'travel [mm],force [mN]'")
    scene = {name: parameters.get(f"{name} unit", "") for name in ("Length", "Force")}
    length = factor_of(path, units["travel"][1], scene["Length"], LENGTHS, "Length")
    unit, per, thickness = units["force"][1].partition("/")
    force = factor_of(path, unit.strip(), scene["Force"], FORCES, "Force")
    if per:
        if parameters["Dimension"] != "2":
            raise Refusal(f"'{path}' has a force per length, '{units['force'][1]}', which "
                          "a scene of Dimension = 2 has only")
        force /= factor_of(path, thickness.strip(), scene["Length"], LENGTHS, "Length")
    return [units[name][0] for name in COLUMNS], [length, force]


def factor_of(path, unit, of_scene, known, kind):
    if unit == of_scene:
        return 1.
    for where, word in ((f"'{path}'", unit), (f"{kind} unit of the scene", of_scene)):
        if word not in known:
            raise Refusal(f"{where} has the unit '{word}', which cannot be converted; "
                          f"units of {kind.lower()} are {', '.join(known)}")
    return known[unit] / known[of_scene]


def number_of(path, line, words, place):
    word = words[place] if place < len(words) else ""
    try:
        value = float(word)
    except ValueError:
        value = math.nan
    if not math.isfinite(value):
        raise Refusal(f"{path}:{line}: '{word}' is not a number")
    return value


def cells_around(travel):
    """The ends of the cells, n + 1 for n points, that meet half way between
    neighbouring points; the first and the last one are as long on both sides.

    A point's force stands for the mean of its cell, so that the sum over cells is the
    trapezoid rule's work, and no two cells share a point."""
    middles = (travel[1:] + travel[:-1]) / 2
    return np.concatenate([[2 * travel[0] - middles[0]], middles,
                           [2 * travel[-1] - middles[-1]]])


def work_of(statistics):
    """Travels and works of a run's first cut between which the work is taken as linear:
    all its states up to the first yield, and its yields from there on.

    Between two yields the force is a tooth of the mesh's saw; its mean is the force that
    remains on finer meshes."""
    cut = statistics[0]["cut"]
    # The pieces have no blade, whose work the last of its states has.
    lines = [line for line in statistics
             if line["cut"] == cut and line["event"] != "divide"]
    first = next((i for i, line in enumerate(lines) if line["event"] == "yield"),
                 len(lines))
    # Rows that split at one travel leave one point.
    works = {0.: 0.}
    works.update((line["travel"], line["work"]) for i, line in enumerate(lines)
                 if i <= first or line["event"] == "yield" or i == len(lines) - 1)
    return np.array(sorted(works.items())).T


def mean_forces(work, ends):
    """The mean force of each cell: what the work rises by over the cell's length. Before
    the entry and behind the cut's end there is none."""
    return np.diff(np.interp(ends, *work)) / np.diff(ends)
