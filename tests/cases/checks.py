# SPDX-License-Identifier: LGPL-2.1-or-later
"""What is asked of a run: functions of its directory and of what it said, which give
problems."""

import pathlib
import re
import sys

sys.path.append(str(pathlib.Path(__file__).resolve().parents[1] / "scenes"))
from tables import read

TOLERANCE = 1e-8


def no_message(_, result):
    """Standard error is empty."""
    if result.stderr:
        yield f"standard error: {result.stderr.strip()}"


def results_of(directory):
    """The directory of the results, wherever a scene has put them."""
    return next(directory.rglob("statistics.csv")).parent


def event(name, tolerance=TOLERANCE, **columns):
    """The last line of this event has these values, to the tolerance (absolute
    below 1); of 'deform' it is the first line, that of the body that is whole."""
    def check(directory, _):
        lines = [line for line in read(results_of(directory) / "statistics.csv")
                 if line["event"] == name]
        if not lines:
            yield f"there is no event '{name}'"
            return
        line = lines[0 if name == "deform" else -1]
        for column, expected in columns.items():
            value = line.get(column)
            if value in (None, "") or not (abs(float(value) - expected)
                                           <= tolerance * max(1, abs(expected))):
                yield f"{column} of '{name}' is {value} instead of {expected}"

    return check


def blocks(path):
    """Dimension, entity, type and number of elements of each block of a file of
    version 4.1."""
    lines = iter(path.read_text().partition("$Elements\n")[2].splitlines())
    for _ in range(int(next(lines).split()[0])):
        dimension, entity, kind, number = map(int, next(lines).split())
        yield dimension, entity, kind, number
        for _ in range(number):
            next(lines)


def group_size(path, dimension, name):
    """The number of elements of a group in a file of version 4.1."""
    text = path.read_text()
    group = re.search(rf'^{dimension} (\d+) "{name}"$', text, re.M).group(1)
    lines = text.partition("$Entities\n")[2].splitlines()
    counts = [int(word) for word in lines[0].split()]
    begin = 1 + sum(counts[:dimension])
    entities = [line.split() for line in lines[begin : begin + counts[dimension]]]
    members = {int(words[0]) for words in entities
               if group in words[8 : 8 + int(words[7])]}
    return sum(number for size, entity, _, number in blocks(path)
               if size == dimension and entity in members)


def pieces_of(directory):
    """Numbers of elements of the pieces."""
    for path in sorted(results_of(directory).glob("piece_*.msh")):
        largest = max(dimension for dimension, *_ in blocks(path))
        yield sum(number for dimension, _, _, number in blocks(path)
                  if dimension == largest)


def pieces(*expected):
    """Numbers of elements of the pieces, in any order."""
    def check(directory, _):
        found = sorted(pieces_of(directory))
        if found != sorted(expected):
            yield f"pieces of {found} elements instead of {sorted(expected)}"

    return check


def warnings(result):
    return [line for line in result.stdout.splitlines() if line.startswith("Warning")]


def warns(*words):
    """One warning has all of these words or regular expressions."""
    def check(_, result):
        if not any(all(re.search(word, line) for word in words)
                   for line in warnings(result)):
            yield f"no warning has {words}: {warnings(result)}"

    return check


def warns_not(word):
    """No warning has this."""
    def check(_, result):
        yield from (f"a warning: {line}" for line in warnings(result)
                    if re.search(word, line))

    return check


def lacks(word):
    """The message has not this regular expression."""
    return re.compile(rf"^(?!.*{word})")
