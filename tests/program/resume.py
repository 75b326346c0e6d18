# SPDX-License-Identifier: LGPL-2.1-or-later
"""Runs that are stopped, whatever by: their files are whole, and resumed they end
with the files of a run that nothing has stopped, up to the solvers' tolerance.

usage: resume.py GROUP PROGRAM [PROCESSES MPIEXEC]
"""

import concurrent.futures
import itertools
import os
import pathlib
import random
import re
import resource
import signal
import subprocess
import sys
import tempfile
import time

from program_cases import HANGS, scene_text
from run_files import broken_files, differences, results
from stepped import SteppedRun

sys.path.append(str(pathlib.Path(__file__).resolve().parents[1] / "scenes"))
from tables import read

SCENE = {
    "Body/Size": "8, 8, 6",
    "Body/Elements": "3, 2, 2",
    "Support/Fixed faces": "bottom",
    "Support/Loose pieces": "drop",
    "Load/Body force": "0, 0, -0.001",
    "Blade/Direction": "0, 0, -1; -1, 0, 0",
    "Blade/Edge loads": "2:1, 6:1",
    "Blade/Sharpness": "1",
    "Cut/Surfaces": "y:1; z:1",
    "Output/Node tables": "true",
    "Output/Checkpoint": "every row",
}

ENVIRONMENT = {**os.environ, "OPENBLAS_NUM_THREADS": "1"}
SCENES = pathlib.Path(__file__).resolve().parents[1] / "scenes"
# What carries most from one state to the next: multigrid, a ramp of the load, seams
# made before the yield, refinement for a target, curved elements of two materials.
KINDS = ["iterative.prm", "double_cantilever.prm", "accuracy.prm", "refined_2d.prm",
         "group_of_faces.prm", "blade_wedge.prm", "blade_wire.prm", "blade_stress.prm",
         "blade_withdraw.prm", "wedged.prm", "board_cut.prm", "finite_auto.prm",
         "finite_withdraw.prm", "plastic_cut.prm",
         "viscous_cut.prm", "viscous_wedge.prm", "clay_wedge.prm"]


class Failure(Exception):
    """What a run did that it must not."""


class Runs:
    """Starts of one scene, and the directory of a run that nothing stopped."""

    def __init__(self, program, directory, launcher=(), scene=None):
        self.program, self.launcher = program, launcher
        self.directory = pathlib.Path(directory)
        (self.directory / "scene.prm").write_text(scene_text(SCENE)[0])
        self.scene = scene or ["scene.prm"]
        self.numbers = itertools.count()
        begin = time.monotonic()
        self.expected = self.new_directory()
        status, message, self.lines = self.step(self.expected).finish()
        if status != 0:
            raise Failure(message)
        # How long a line takes; nothing that is checked depends on it.
        self.seconds = (time.monotonic() - begin) / len(self.lines)

    def new_directory(self):
        return self.directory / f"run_{next(self.numbers):04}"

    def start(self, output, *options, limit=None):
        def limit_size():
            resource.setrlimit(resource.RLIMIT_FSIZE, (limit, limit))

        return subprocess.Popen(
            [*self.launcher, *self.command(output, *options)],
            cwd=self.directory,
            env=ENVIRONMENT,
            stdout=subprocess.DEVNULL,
            stderr=subprocess.PIPE,
            universal_newlines=True,
            preexec_fn=limit_size if limit else None,
        )

    def command(self, output, *options):
        return [self.program, *self.scene, "--output", str(output), *options]

    def step(self, output, *options):
        """A run that goes on as its lines are read."""
        return SteppedRun(self.launcher, self.command(output, *options),
                          self.directory / f"lines_{next(self.numbers):04}",
                          cwd=self.directory, env=ENVIRONMENT)

    def finish(self, process, status=0):
        """Wait for a run; the answer is its message."""
        _, message = process.communicate(timeout=HANGS)
        if process.returncode != status:
            raise Failure(f"status {process.returncode}: {message.strip()}")
        return message.strip()

    def compare(self, output):
        problems = list(differences(output, self.expected))
        if problems:
            raise Failure("; ".join(problems[:5]))

    def check_files(self, output):
        if output.exists():
            problems = list(broken_files(output))
            if problems:
                raise Failure("; ".join(problems[:5]))

    def resume_and_compare(self, output):
        self.finish(self.start(output, "--resume"))
        self.compare(output)


def check_sentence(message, *pieces):
    """A message of one sentence, that has these pieces."""
    if (
        len(message.splitlines()) != 1
        or not message.startswith("setsudan: ")
        or not message.endswith(".")
        or any(piece not in message for piece in pieces)
    ):
        raise Failure(f"the message is '{message}'")


def kill_behind(run, n_lines, seconds=0):
    """SIGKILL, some time after a line and before the second next."""
    run.advance(n_lines)
    time.sleep(seconds)
    status, message, _ = run.kill()
    if status == 0:
        raise Failure(f"the run ended behind {n_lines} lines {message}")


def kill_and_resume(runs, number, share):
    """A run is killed when a share of its lines has been read, and perhaps again
    where it goes on."""
    generator = random.Random(number)
    output = runs.new_directory()
    # The run cannot end before its last line but one has been read.
    n_lines = int(share * (len(runs.lines) - 1))
    kill_behind(runs.step(output), n_lines, generator.uniform(0, 2 * runs.seconds))
    runs.check_files(output)
    if number % 2 == 1:
        # Lines 0 and 1 of a run that goes on tell of the body and the solver.
        rest = 1 if n_lines + 3 < len(runs.lines) else 0
        kill_behind(runs.step(output, "--resume"), rest,
                    generator.uniform(0, 2 * runs.seconds))
        runs.check_files(output)
    runs.resume_and_compare(output)


def kill(runs, n_tries):
    """SIGKILL all along the run, and again while it is resumed."""
    with concurrent.futures.ThreadPoolExecutor(max_workers=2) as pool:
        list(pool.map(lambda number: kill_and_resume(runs, number, number / n_tries),
                      range(n_tries)))
    return f"{n_tries} runs killed"


def all_kinds(runs, n_times):
    """The scenes of other tests, each killed some times on its way."""
    for name in KINDS:
        scene = Runs(
            runs.program,
            tempfile.mkdtemp(dir=runs.directory),
            scene=[str(SCENES / name), "--set", "Output/Checkpoint=every row"],
        )
        output = scene.new_directory()
        resumption = []
        for _ in range(n_times):
            kill_behind(scene.step(output, *resumption),
                        len(scene.lines) // (n_times + 1))
            resumption = ["--resume"]
        scene.resume_and_compare(output)
    return f"{len(KINDS)} scenes"


def check_last_event(output, message):
    """A run that was interrupted has all events in its table."""
    named = re.search(r"interrupted behind row (\d+) of cut (\d+)", message)
    last = read(output / "statistics.csv")[-1]
    if (int(last["row"]) + 1, int(last["cut"])) != tuple(map(int, named.groups())):
        raise Failure(f"the table ends at row {int(last['row']) + 1}: {message}")


def interrupt_behind(runs, n_lines, kind, *options):
    """Ctrl-C, or what a batch system sends: the run stops with a sentence."""
    output = runs.new_directory()
    run = runs.step(output, *options)
    run.advance(n_lines)
    run.send(kind)
    status, message, _ = run.finish()
    if status != 1:
        raise Failure(f"status {status} behind {n_lines} lines {message}")
    runs.check_files(output)
    check_last_event(output, message)
    return output, message


def interrupt(runs, n_tries):
    """Signals behind lines of the whole run, up to those after which no row comes."""
    last_row = max(i for i, line in enumerate(runs.lines) if re.match(r"  row \d", line))
    for i in range(n_tries):
        # The first line is said when the program listens to signals.
        n_lines = 1 + i * (last_row - 2) // (n_tries - 1)
        kind = (signal.SIGINT, signal.SIGTERM)[i % 2]
        output, message = interrupt_behind(runs, n_lines, kind)
        check_sentence(message, "interrupted behind row", "--resume")
        runs.resume_and_compare(output)
        # Without checkpoints, for which the table would be written anyway.
        _, message = interrupt_behind(runs, n_lines, kind,
                                      "--set", "Output/Checkpoint=none")
        check_sentence(message, "leaves nothing to resume from")
    return f"{2 * n_tries} runs interrupted"


def full_disk(runs, n_tries):
    """No file may become larger than a limit: each of them comes to its turn."""
    sizes = sorted({path.stat().st_size for path in results(runs.expected)})
    limits = [size - 1 for size in sizes if size > 1][:: max(1, len(sizes) // n_tries)]
    for limit in limits:
        output = runs.new_directory()
        message = runs.finish(runs.start(output, limit=limit), status=1)
        check_sentence(message, "cannot be written: File too large")
        runs.check_files(output)
        if any(path.stat().st_size > limit for path in results(output)):
            raise Failure("a file is larger than the limit")
        runs.resume_and_compare(output)
    return f"{len(limits)} limits"


def refusals(runs, _):
    """What cannot be resumed is refused, or has ended."""
    before = {path: path.read_bytes() for path in results(runs.expected)}
    runs.finish(runs.start(runs.expected, "--resume"))
    other = ["--resume", "--set", "Material/Shear limit=2"]
    message = runs.finish(runs.start(runs.expected, *other), status=1)
    check_sentence(message, "another scene", "'set Shear limit", "= 1.0'", "= 2'")
    never = ["--resume", "--set", "Output/Checkpoint=none"]
    message = runs.finish(runs.start(runs.expected, *never), status=1)
    check_sentence(message, "'Checkpoint' is 'none'")
    if before != {path: path.read_bytes() for path in results(runs.expected)}:
        raise Failure("a run that has ended was changed")

    # Nowhere, and in a directory that is still empty, a run begins.
    runs.resume_and_compare(runs.new_directory())
    output = runs.new_directory()
    output.mkdir()
    runs.resume_and_compare(output)

    # Checkpoints that are none, and one of another number of processes.
    output = runs.new_directory()
    limit = max(path.stat().st_size for path in results(runs.expected)) - 1
    if limit < (runs.expected / "parameters.prm").stat().st_size:
        raise Failure("a run that must be stopped on its way would not even begin")
    runs.finish(runs.start(output, limit=limit), status=1)
    whole = (output / "checkpoint").read_bytes()
    for damaged in (whole[:-1], whole[: len(whole) // 2], b"checkpoint"):
        (output / "checkpoint").write_bytes(damaged)
        message = runs.finish(runs.start(output, "--resume"), status=1)
        check_sentence(message, "damaged", "without --resume")
    (output / "checkpoint").write_bytes(whole)
    runs.resume_and_compare(output)
    return "all refused"


GROUPS = {
    "kill": (kill, 24),
    "kill_processes": (kill, 6),
    "all_kinds": (all_kinds, 3),
    "interrupt": (interrupt, 6),
    "full_disk": (full_disk, 8),
    "refusals": (refusals, 1),
}


def main(group, program, processes="1", mpiexec="mpirun"):
    launcher = [] if processes == "1" else [mpiexec, "-np", processes]
    test, n_tries = GROUPS[group]
    with tempfile.TemporaryDirectory() as directory:
        try:
            print(test(Runs(program, directory, launcher), n_tries))
        except Failure as failure:
            print(f"FAILED: {failure}")
            return 1
    return 0


if __name__ == "__main__":
    sys.exit(main(*sys.argv[1:]))
