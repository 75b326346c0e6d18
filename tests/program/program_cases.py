# SPDX-License-Identifier: LGPL-2.1-or-later
"""Starts of the program, each in a directory of its own, and what they must do.

A test makes a list of Case and hands it to run_cases().
"""

import concurrent.futures
import os
import pathlib
import re
import resource
import signal
import subprocess
import tempfile
from typing import Callable, Dict, NamedTuple, Pattern, Sequence, Union

SCENE = {
    "Dimension": "3",
    "Body/Size": "10, 10, 10",
    "Body/Elements": "1, 2, 1",
    "Material/Poisson's ratio": "0.2",
    "Support/Fixed faces": "bottom",
    "Blade/Direction": "0, 0, -1",
    "Blade/Edge loads": "0:10, 5:50, 10:10",
    "Cut/Surfaces": "y:1",
    "Output/Directory": "made/by/the/run",
}

PLANE_SCENE = {
    **SCENE,
    "Dimension": "2",
    "Body/Size": "10, 10",
    "Body/Elements": "2, 1",
    "Blade/Direction": "0, -1",
    "Blade/Edge loads": "0:10",
    "Cut/Surfaces": "x:1",
}


# The longest that a run may take where it waits for ever [s].
HANGS = 600


class Case(NamedTuple):
    """What is started, and what it must answer."""

    name: str
    arguments: Sequence[str]
    files: Dict[str, Union[str, bytes]]
    status: int
    # What standard error (of a failure) or standard output must contain: texts, or
    # regular expressions.
    pieces: Sequence[Union[str, Pattern]]
    # The most memory that the program may have, in bytes.
    memory: int = resource.RLIM_INFINITY
    # What starts the program, such as mpirun -np 2.
    launcher: Sequence[str] = ()
    # What is asked of a run's files, each with the directory and what the program
    # said; the answers are problems. Without them nothing may be written.
    checks: Sequence[Callable] = ()
    # The processor's time that each process may take, which does not depend on what
    # else the machine does.
    seconds: int = 60


def scene_text(values):
    """A scene file, and the line of each parameter in it."""
    text, lines = [], {}
    for path, value in values.items():
        subsection, _, name = path.rpartition("/")
        text += ["subsection " + subsection] if subsection else []
        text.append(f"set {name} = {value}")
        lines[path] = len(text)
        text += ["end"] if subsection else []
    return "\n".join(text) + "\n", lines


def wrong_value(path, value, allowed, scene=None, also=None):
    """A scene whose parameter `path` has a value that is not allowed."""
    values = {**(scene or SCENE), **(also or {}), path: value}
    text, lines = scene_text(values)
    subsection, _, name = path.rpartition("/")
    place = f"subsection {subsection}, '{name}'" if subsection else f"'{name}'"
    pieces = [f"scene.prm:{lines[path]}: {place} is '{value}'; allowed is: ", allowed]
    return Case(f"{path} = {value}", ["scene.prm"], {"scene.prm": text}, 1, pieces)


def wrong_text(name, text, *pieces, files=None):
    """A scene file with this text; `pieces` are of the message."""
    return Case(name, ["scene.prm"], {"scene.prm": text, **(files or {})}, 1, pieces)


def files_below(directory):
    return sorted(str(p.relative_to(directory)) for p in directory.rglob("*"))


def contains(text, piece):
    return piece in text if isinstance(piece, str) else piece.search(text)


def missing(case, text):
    """The pieces that a text has not."""
    return [getattr(piece, "pattern", piece) for piece in case.pieces
            if not contains(text, piece)]


def message_problems(case, result):
    """A failure is one sentence on standard error, and nothing else."""
    lines = result.stderr.splitlines()
    if case.launcher:
        # It adds what it thinks of the status.
        lines = [line for line in lines if line.startswith("setsudan")]
    if len(lines) != 1:
        return [f"{len(lines)} lines on standard error instead of one"]
    problems = []
    if not (lines[0].startswith("setsudan: ") and lines[0].endswith(".")):
        problems.append("the message is not 'setsudan: <sentence>.'")
    if result.stdout:
        problems.append("something on standard output")
    if re.search(r"allowed is:\W*$", lines[0]):
        problems.append("the message does not say what is allowed")
    problems += [f"not in the message: {piece}" for piece in missing(case, lines[0])]
    return problems


def start(program, case, directory):
    """How a run of the program has ended."""
    command = [*case.launcher, program, *case.arguments]

    def limit():
        resource.setrlimit(resource.RLIMIT_AS, (case.memory, case.memory))
        resource.setrlimit(resource.RLIMIT_CPU, (case.seconds, case.seconds + 1))

    try:
        return subprocess.run(
            command,
            cwd=directory,
            env={**os.environ, "OPENBLAS_NUM_THREADS": "1"},
            stdout=subprocess.PIPE,
            stderr=subprocess.PIPE,
            universal_newlines=True,
            timeout=HANGS,
            preexec_fn=limit,
        )
    except subprocess.TimeoutExpired:
        return subprocess.CompletedProcess(
            command, None, "", f"setsudan: no end within {HANGS} s.")


def run(program, case):
    """The problems of a case, and what the program said."""
    with tempfile.TemporaryDirectory() as name:
        directory = pathlib.Path(name)
        for file, text in case.files.items():
            (directory / file).parent.mkdir(parents=True, exist_ok=True)
            content = text if isinstance(text, bytes) else text.encode()
            (directory / file).write_bytes(content)
        before = files_below(directory)
        result = start(program, case, directory)
        written = [f for f in files_below(directory) if f not in before]
        problems = []
        if result.returncode == -signal.SIGXCPU:
            problems.append(f"no end within {case.seconds} s of the processor")
        elif result.returncode != case.status:
            problems.append(f"status {result.returncode} instead of {case.status}")
        else:
            for check in case.checks:
                problems += check(directory, result)
    if written and not case.checks:
        problems.append("it wrote " + ", ".join(written[:3]))
    if case.status == 1 and not case.checks:
        problems += message_problems(case, result)
    else:
        said = result.stdout + result.stderr
        problems += [f"not in what it said: {piece}" for piece in missing(case, said)]
    return problems, result


def run_cases(program, cases):
    """Run all cases, print what is wrong, and return the exit status."""
    n_failed = 0
    with concurrent.futures.ThreadPoolExecutor(max_workers=2) as pool:
        results = pool.map(lambda case: run(program, case), cases)
        for case, (problems, result) in zip(cases, results):
            if problems:
                n_failed += 1
                print(f"FAILED: {case.name}\n  " + "\n  ".join(problems))
                print(f"  standard error: {result.stderr.strip()}")
    print(f"{len(cases)} cases, {n_failed} failed")
    return 1 if n_failed or not cases else 0
