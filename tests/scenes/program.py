# SPDX-License-Identifier: LGPL-2.1-or-later
"""Runs of the program: the options that name it, and running a scene."""

import argparse
import subprocess
import sys

# Tables and decks are compared, frames are for people.
QUIET = ("Output/Frames=none",)


def parser(description):
    """A parser of command lines that has the program's options."""
    result = argparse.ArgumentParser(description=description)
    result.add_argument("--program", required=True)
    result.add_argument("--processes", type=int, default=1)
    result.add_argument("--mpiexec", default="mpirun")
    return result


def run(options, scene, directory, settings=(), processes=None):
    """Run a scene with `settings` ('Subsection/Name=value') into a directory; the
    answer is what the program said."""
    command = [options.program, str(scene), "--output", str(directory)]
    for setting in settings:
        command += ["--set", setting]
    processes = processes or options.processes
    if processes > 1:
        command = [options.mpiexec, "-np", str(processes)] + command
    result = subprocess.run(command, capture_output=True, text=True)
    if result.returncode != 0:
        sys.exit(f"exit status {result.returncode}\n{result.stderr}")
    return result.stdout
