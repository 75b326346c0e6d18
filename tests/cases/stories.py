# SPDX-License-Identifier: LGPL-2.1-or-later
"""Stories: tests that start the program more than once in one place."""

import re
import resource

from program_cases import Case, files_below, start
from tables import read


class Place:
    """A directory with files, in which a story starts the program."""

    def __init__(self, program, mpiexec, directory, files):
        self.program, self.mpiexec, self.directory = program, mpiexec, directory
        for name, content in files.items():
            self.write(name, content)

    def write(self, name, content):
        path = self.directory / name
        path.parent.mkdir(parents=True, exist_ok=True)
        path.write_bytes(content if isinstance(content, bytes) else content.encode())

    def start(self, *arguments, processes=1, seconds=60):
        launcher = [] if processes == 1 else [self.mpiexec, "-np", str(processes)]
        case = Case("", arguments, {}, 0, (), launcher=launcher, seconds=seconds,
                    memory=resource.RLIM_INFINITY)
        return start(self.program, case, self.directory)

    def table(self, output):
        """The lines of statistics.csv; none where it is missing."""
        path = self.directory / output / "statistics.csv"
        return read(path) if path.exists() else []

    def contents(self):
        """All files, with what they hold."""
        return {name: (self.directory / name).read_bytes()
                for name in files_below(self.directory)
                if (self.directory / name).is_file()}


def fails(result, *words):
    """Problems of a run that must end with a sentence."""
    lines = [line for line in result.stderr.splitlines() if "setsudan" in line]
    if result.returncode != 1:
        yield f"status {result.returncode} instead of 1"
    if len(lines) != 1 or not re.fullmatch(r"setsudan: .*\.", lines[0]):
        yield f"no sentence: {result.stderr.strip()}"
    yield from (f"not in the message: {word}: {result.stderr.strip()}"
                for word in words if not re.search(word, result.stderr))


def ends_well(result):
    """Problems of a run that must end well."""
    if result.returncode != 0 or result.stderr:
        yield f"status {result.returncode}: {result.stderr.strip()}"


def same_columns(lines, others, columns, tolerance=1e-9):
    """Problems of two tables that must agree in these columns."""
    if not lines or len(lines) != len(others):
        yield f"{len(others)} events instead of {len(lines)}"
        return
    for column in columns:
        scale = max(abs(float(line[column])) for line in lines) or 1
        for line, other in zip(lines, others):
            if not abs(float(line[column]) - float(other[column])) <= tolerance * scale:
                yield f"{column} is {other[column]} instead of {line[column]}"
