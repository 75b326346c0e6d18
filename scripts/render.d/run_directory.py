# SPDX-License-Identifier: LGPL-2.1-or-later
"""What a run of setsudan left in its output directory."""

import csv
import os
import re
import sys


class RunDirectory:
    """The frames, statistics and parameters of one run."""

    def __init__(self, path):
        self.path = path
        shown = read_sequence(path)
        self.frames = of_kind("frame", shown)
        self.blades = of_kind("blade", shown)
        self.parameters = read_parameters(os.path.join(path, "parameters.prm"))
        self.statistics = read_statistics(os.path.join(path, "statistics.csv"))
        self.cuts = sorted({line["cut"] for line in self.statistics})

    def name(self):
        """The directory's, in words."""
        return os.path.basename(os.path.abspath(self.path)).replace("_", " ")

    def unit(self, field):
        """The unit of a field, made of the labels of length and force."""
        length = self.parameters.get("Length unit", "")
        force = self.parameters.get("Force unit", "")
        if field.startswith("displacement"):
            return length
        if field == "energy_release":
            return f"{force}/{length}" if length and force else ""
        is_stress = field.startswith(("stress", "principal_stress", "von_Mises",
                                      "maximum_shear"))
        return f"{force}/{length}²" if is_stress and length and force else ""

    def events(self, frame):
        return [line for line in self.statistics if line["frame"] == frame]


def of_kind(kind, files):
    """Number -> file, of the files of one kind."""
    return {int(re.search(r"(\d+)\.p?vtu$", file).group(1)): file for file in files
            if os.path.basename(file).startswith(kind)}


def read_sequence(path):
    """The files that cut.pvd lists."""
    sequence = os.path.join(path, "cut.pvd")
    files = []
    if os.path.exists(sequence):
        with open(sequence) as pvd:
            files = re.findall(r'file="([^"]+)"', pvd.read())
    if not files:
        sys.exit(f"{path} holds no frames: run a scene with Output/Frames = "
                 "every row or stages into it first.")
    return [os.path.join(path, name) for name in files]


def read_statistics(path):
    if not os.path.exists(path):
        sys.exit(f"{os.path.dirname(path)} has no statistics.csv: it is not the "
                 "output of a run.")
    with open(path, newline="") as table:
        return [convert(line) for line in csv.DictReader(table)]


def read_parameters(path):
    """'Subsection/Name' -> value, as text."""
    parameters, sections = {}, []
    with open(path) as lines:
        for line in lines:
            line = line.split("#")[0].strip()
            if line.startswith("subsection "):
                sections.append(line[len("subsection "):].strip())
            elif line == "end":
                sections.pop()
            elif line.startswith("set "):
                name, value = line[len("set "):].split("=", 1)
                parameters["/".join(sections + [name.strip()])] = value.strip()
    return parameters


TEXTS = ("event", "row_pieces")
COUNTS = ("frame", "cut", "row", "released_rows", "pieces")


def convert(line):
    """A line of the statistics with its numbers as numbers; those of the whole body
    are missing where only the front is known."""
    return {name: value if name in TEXTS else
            int(value) if name in COUNTS else float(value)
            for name, value in line.items() if value}
