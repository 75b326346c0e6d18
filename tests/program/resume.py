"""Runs that are stopped, whatever by: their files are whole, and resumed they end
with the same files, to the last digit, as a run that nothing has stopped.

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

from program_cases import scene_text
from run_files import broken_files, differences, results

sys.path.append(str(pathlib.Path(__file__).resolve().parents[1] / "scenes"))
from tables import read

SCENE = {
    "Body/Size": "8, 8, 6",
    "Body/Elements": "2, 2, 2",
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


SCENES = pathlib.Path(__file__).resolve().parents[1] / "scenes"
# What carries most from one state to the next: multigrid, a ramp of the load, seams
# made before the yield, refinement for a target, curved elements of two materials.
KINDS = ["iterative.prm", "double_cantilever.prm", "accuracy.prm", "refined_2d.prm",
         "group_of_faces.prm"]


class Failure(Exception):
    """What a run did that it must not."""


class Runs:
    """Starts of one scene, and the directory of a run that nothing stopped."""

    def __init__(self, program, directory, launcher=(), scene=None):
        self.program = program
        self.directory = pathlib.Path(directory)
        (self.directory / "scene.prm").write_text(scene_text(SCENE)[0])
        self.command = [*launcher, program, *(scene or ["scene.prm"])]
        self.numbers = itertools.count()
        begin = time.monotonic()
        self.expected = self.new_directory()
        self.finish(self.start(self.expected))
        self.seconds = time.monotonic() - begin

    def new_directory(self):
        return self.directory / f"run_{next(self.numbers):04}"

    def start(self, output, *options, limit=None):
        def limit_size():
            resource.setrlimit(resource.RLIMIT_FSIZE, (limit, limit))

        return subprocess.Popen(
            [*self.command, "--output", str(output), *options],
            cwd=self.directory,
            env={**os.environ, "OPENBLAS_NUM_THREADS": "1"},
            stdout=subprocess.DEVNULL,
            stderr=subprocess.PIPE,
            universal_newlines=True,
            start_new_session=True,
            preexec_fn=limit_size if limit else None,
        )

    def finish(self, process, status=0):
        """Wait for a run; the answer is its message."""
        _, message = process.communicate(timeout=120)
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


def stop_after(process, seconds, signal_number):
    """Send a signal to all of a run's processes, if it lasts that long."""
    try:
        process.wait(timeout=seconds)
    except subprocess.TimeoutExpired:
        os.killpg(process.pid, signal_number)
    return process


def kill_and_resume(runs, number):
    """One try; the answer is how often the run was killed."""
    generator = random.Random(number)
    output = runs.new_directory()
    options = []
    n_killed = 0
    for factor in (1.0, 0.7)[: generator.choice((1, 2))]:
        seconds = generator.uniform(0, factor * runs.seconds)
        process = stop_after(runs.start(output, *options), seconds, signal.SIGKILL)
        process.communicate()
        runs.check_files(output)
        n_killed += process.returncode != 0
        options = ["--resume"]
    runs.resume_and_compare(output)
    return n_killed


def kill(runs, n_tries):
    """SIGKILL at any time, and again while the run is resumed."""
    with concurrent.futures.ThreadPoolExecutor(max_workers=2) as pool:
        n_killed = sum(
            pool.map(lambda number: kill_and_resume(runs, number), range(n_tries))
        )
    if n_killed < n_tries / 3:
        raise Failure(f"only {n_killed} runs lived long enough to be killed")
    return f"{n_killed} runs killed"


def all_kinds(runs, n_tries):
    """The scenes of other tests, each killed some times on its way."""
    for name in KINDS:
        options = ["--set", "Output/Checkpoint=every row"]
        scene = Runs(
            runs.program,
            tempfile.mkdtemp(dir=runs.directory),
            scene=[str(SCENES / name), *options],
        )
        output = scene.new_directory()
        resumption = []
        for _ in range(n_tries):
            process = scene.start(output, *resumption)
            stop_after(process, 0.6 * scene.seconds, signal.SIGKILL).communicate()
            resumption = ["--resume"]
        scene.resume_and_compare(output)
    return f"{len(KINDS)} scenes"


def interrupt(runs, n_tries):
    """Ctrl-C, and what a batch system sends: the run stops with a sentence."""
    n_interrupted = 0
    for i in range(n_tries):
        output = runs.new_directory()
        # From the time on when the program has begun.
        process = runs.start(output)
        while not (output / "parameters.prm").exists() and process.poll() is None:
            time.sleep(0.002)
        kind = (signal.SIGINT, signal.SIGTERM)[i % 2]
        stop_after(process, i / n_tries * 0.5 * runs.seconds, kind)
        _, message = process.communicate(timeout=120)
        runs.check_files(output)
        if process.returncode != 0:
            n_interrupted += 1
            check_sentence(message.strip(), "interrupted behind row", "--resume")
            if process.returncode != 1:
                raise Failure(f"status {process.returncode}")
        runs.resume_and_compare(output)
    if n_interrupted == 0:
        raise Failure("no run was interrupted")
    return f"{n_interrupted} runs interrupted"


def check_last_event(runs, options, seconds):
    """A run that fails has all events in its table, though it saves nothing else."""
    for fraction in (0.6, 0.7, 0.8, 0.9):
        output = runs.new_directory()
        process = stop_after(
            runs.start(output, *options, "--set", "Output/Checkpoint=none"),
            fraction * seconds, signal.SIGINT)
        _, message = process.communicate(timeout=120)
        named = re.search(r"interrupted behind row (\d+) ", message)
        if named:
            last = read(output / "statistics.csv")[-1]
            if int(last["row"]) + 1 != int(named.group(1)):
                raise Failure(f"the table ends at row {int(last['row']) + 1}: {message}")
            return
    raise Failure("no run was stopped")


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
    "kill": (kill, 50),
    "kill_processes": (kill, 6),
    "all_kinds": (all_kinds, 3),
    "interrupt": (interrupt, 8),
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
