# SPDX-License-Identifier: LGPL-2.1-or-later
"""Problems that the program solves, and the rows of the table that they give."""

import dataclasses
import math
import pathlib
import sys
import tempfile

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parent.parent / "scenes"))
import program  # noqa: E402
import tables  # noqa: E402


@dataclasses.dataclass
class Row:
    """A number of the table: its ratio to the reference must be `expected`, up to
    `bound`; or that at least, where there is no bound."""

    quantity: str
    mesh: str
    reference: float
    computed: float
    bound: float = None
    expected: float = 1.0

    @property
    def ratio(self):
        return self.computed / self.reference

    @property
    def demand(self):
        """What is asked of the ratio, in words."""
        if self.bound is None:
            return f"at least {self.expected:.4g}"
        return f"{self.expected:.4f} ± {self.bound:.2g}"

    def passes(self):
        # Written so that what is no number fails.
        if self.bound is None:
            return self.ratio >= self.expected
        return abs(self.ratio - self.expected) <= self.bound


@dataclasses.dataclass
class Case:
    """A problem: where its reference is from, and the function that computes its
    rows, those that take long only if it is asked to."""

    name: str
    title: str
    source: str
    rows: object


class State:
    """A solved state: its nodes, and its line of the statistics."""

    def __init__(self, directory, line):
        self.line = line
        self.nodes = tables.read(directory / f"nodes_{int(line['frame']):04}.csv")
        for node in self.nodes:
            node["p"] = tuple(float(node[c]) for c in "xyz")

    def at(self, position, column):
        """The value at the node of a position."""
        position = tuple(position) + (0.0,) * (3 - len(position))
        node = min(self.nodes, key=lambda n: math.dist(n["p"], position))
        if math.dist(node["p"], position) > 1e-6:
            sys.exit(f"there is no node at {position}")
        return float(node[column])

    def mean(self, holds, column):
        """The mean over the nodes that lie where `holds` says."""
        values = [float(node[column]) for node in self.nodes if holds(*node["p"])]
        return sum(values) / len(values)


def run_table(options, settings):
    """The statistics of a scene."""
    with tempfile.TemporaryDirectory() as directory:
        directory = pathlib.Path(directory)
        scene = directory / "scene.prm"
        scene.write_text("")
        program.run(options, scene, directory / "results",
                    [f"{name}={value}" for name, value in settings.items()] +
                    list(program.QUIET))
        return tables.read(directory / "results" / "statistics.csv")


def solve_all(options, settings, body=None):
    """The states of a scene before each row of its cut; `body` is written and read."""
    with tempfile.TemporaryDirectory() as directory:
        directory = pathlib.Path(directory)
        scene = directory / "scene.prm"
        scene.write_text("")
        if body:
            body.write(directory / "body.msh")
            settings = {"Dimension": body.dim, "Body/Shape": "file",
                        "Body/File": directory / "body.msh", **settings}
        settings = {"Output/Node tables": "true", **settings}
        program.run(options, scene, directory / "results",
                    [f"{name}={value}" for name, value in settings.items()] +
                    list(program.QUIET))
        lines = tables.read(directory / "results" / "statistics.csv")
        return [State(directory / "results", line) for line in lines
                if line["event"] == "deform"]


def solve(options, settings, body=None):
    """The state of a scene without a cut."""
    state, = solve_all(options, settings, body)
    return state


def material(youngs_modulus, poissons_ratio):
    return {"Material/Young's modulus": youngs_modulus,
            "Material/Poisson's ratio": repr(poissons_ratio)}
