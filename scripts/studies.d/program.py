# SPDX-License-Identifier: LGPL-2.1-or-later
"""Runs of the program with changed settings, and what they leave."""

import json
import os
import pathlib
import subprocess
import sys
from types import SimpleNamespace

sys.path.append(str(pathlib.Path(__file__).resolve().parents[1] / "render.d"))
from run_directory import read_parameters, read_statistics

# What the scripts rely on, whatever the scene has: a table that begins with its
# names, and a checkpoint that tells whether a run has ended.
NEEDED = {"Output/Units": "none", "Output/Checkpoint": "auto"}


class Refusal(Exception):
    """What is wrong with the input or with a run, in one sentence."""


class Program:
    """Starts of one scene; several may be under way at once."""

    def __init__(self, path, scene):
        self.path = os.path.abspath(path)
        self.scene = str(scene)
        if not os.path.isfile(self.scene):
            raise Refusal(f"there is no scene '{self.scene}'")

    def start(self, settings, output, *options):
        """What came out of a start: status and text."""
        command = [self.path, self.scene, *options, "--output", str(output)]
        for name, value in {**settings, **NEEDED}.items():
            command += ["--set", f"{name}={value}"]
        return subprocess.run(command, capture_output=True, text=True, check=False,
                              env={**os.environ, "OPENBLAS_NUM_THREADS": "1"})

    def parameters(self, settings, output):
        """'Subsection/Name' -> value of a scene with settings.

        Raises Refusal where the program does not take them."""
        printed = self.start(settings, output, "--print-parameters")
        if printed.returncode != 0:
            raise Refusal(last_line(printed))
        return parse_parameters(printed.stdout)

    def run(self, settings, output):
        """Run, or go on with a run of the same scene that was stopped; one that has
        ended stays. Raises Refusal where it fails."""
        has_ended = (pathlib.Path(output) / "summary.json").is_file()
        if (pathlib.Path(output) / "checkpoint").is_file() or has_ended:
            resumed = self.start(settings, output, "--resume")
            if resumed.returncode == 0 and is_whole(output):
                return
            if "Start it anew" not in resumed.stderr and \
                    "is of another scene" not in resumed.stderr and \
                    resumed.returncode != 0:
                raise Refusal(last_line(resumed))
        done = self.start(settings, output)
        if done.returncode != 0:
            raise Refusal(last_line(done))


def is_whole(output):
    return (pathlib.Path(output) / "summary.json").is_file()


def last_line(process):
    lines = [line.strip() for line in process.stderr.splitlines() if line.strip()]
    if not lines:
        return f"the program ended with status {process.returncode}"
    return lines[-1].removeprefix("setsudan: ").rstrip(".")


def parse_parameters(text):
    """As run_directory.read_parameters, of text."""
    parameters, sections = {}, []
    for line in text.splitlines():
        line = line.split("#")[0].strip()
        if line.startswith("subsection "):
            sections.append(line[len("subsection "):].strip())
        elif line == "end" and sections:
            sections.pop()
        elif line.startswith("set ") and "=" in line:
            name, value = line[len("set "):].split("=", 1)
            parameters["/".join(sections + [name.strip()])] = value.strip()
    return parameters


def read_run(output):
    """The parameters, statistics and summary of a run that has ended, with frames or
    without."""
    output = pathlib.Path(output)
    statistics = read_statistics(str(output / "statistics.csv"))
    return SimpleNamespace(
        path=str(output),
        parameters=read_parameters(str(output / "parameters.prm")),
        statistics=statistics,
        cuts=sorted({line["cut"] for line in statistics}),
        summary=read_summary(output))


def read_summary(output):
    return json.loads((pathlib.Path(output) / "summary.json").read_text())
