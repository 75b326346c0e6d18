# SPDX-License-Identifier: LGPL-2.1-or-later
"""How runs are timed: of the program, of benchmark programs and of others."""

import csv
import dataclasses
import json
import os
import pathlib
import resource
import subprocess
import sys
import tempfile
import time

ROOT = pathlib.Path(__file__).resolve().parents[2]
STORE = ROOT / "build" / "performance.json"
CUBE = ROOT / "prm" / "kakefuda_1996" / "cut.prm"


def remembered(key, measure, store=STORE):
    """What measure() gives, or gave when it was called for this key before."""
    known = json.loads(store.read_text()) if store.exists() else {}
    if key not in known:
        known[key] = measure()
        store.write_text(json.dumps(known, indent=1))
    print(key, known[key], file=sys.stderr, flush=True)
    return known[key]


def timed(command, directory=None, **environment):
    """Seconds, peak memory in MB and output of a command, which must succeed."""
    with tempfile.TemporaryFile("w+") as said:
        begin = time.monotonic()
        process = subprocess.Popen([str(word) for word in command], cwd=directory,
                                   stdout=said, stderr=said,
                                   env={**os.environ, **environment})
        _, status, usage = os.wait4(process.pid, 0)
        seconds = time.monotonic() - begin
        said.seek(0)
        text = said.read()
    if status != 0:
        raise RuntimeError(f"failed: {command}\n{text[-2000:]}")
    return seconds, usage.ru_maxrss / 1024, text


def of_processor(run):
    """The processor's seconds that a run takes in processes of its own, which other work
    on the machine changes less than those of a clock; and what it gives."""
    def spent():
        usage = resource.getrusage(resource.RUSAGE_CHILDREN)
        return usage.ru_utime + usage.ru_stime

    before = spent()
    result = run()
    return spent() - before, result


def events_in(directory):
    """The lines of a run's statistics, so far."""
    path = pathlib.Path(directory) / "statistics.csv"
    if not path.exists():
        return []
    with open(path, newline="") as table:
        return list(csv.DictReader(table))


def watched(command, directory, found, limit=None):
    """Run the program until found(events) gives something, and end it: what that is, and
    why there is nothing."""
    with tempfile.TemporaryFile("w+") as said:
        process = subprocess.Popen([str(word) for word in command], stdout=said,
                                   stderr=said)
        begin = time.monotonic()
        try:
            while True:
                ended = process.poll() is not None
                result = found(events_in(directory))
                if result:
                    return result, ""
                if ended:
                    said.seek(0)
                    return None, said.read().strip().splitlines()[-1]
                if limit and time.monotonic() - begin > limit:
                    return None, f"longer than {limit} s"
                time.sleep(0.02)
        finally:
            process.kill()
            process.wait()


def processes(n):
    """What starts a command on so many processes."""
    environment = ["bash", "-c", f'source "{ROOT}/scripts/lib/mpi.sh"; exec "$@"', "bash"]
    return [*environment, *(["mpirun", "-np", str(n)] if n > 1 else [])]


def values_in(text):
    """Values by the names that stand before them."""
    words = text.split()
    return {name: float(value) for name, value in zip(words[::2], words[1::2])}


def benchmark(name, *arguments, n_processes=1):
    """The names and values that a benchmark's program prints."""
    command = [*processes(n_processes), ROOT / "build" / f"benchmark_{name}", *arguments]
    return values_in(timed(command)[2])


def settings(values):
    return [word for name, value in values.items()
            for word in ("--set", f"{name}={value}")]


@dataclasses.dataclass
class Run:
    """A run of the program."""

    seconds: float
    memory: float
    events: list


QUIET = {"Output/Frames": "none", "Output/Checkpoint": "none",
         "Output/Node tables": "false"}


def program(scene, values, directory=None, n_processes=1):
    """Run a scene without output but the statistics, unless values say otherwise."""
    with tempfile.TemporaryDirectory() as temporary:
        directory = directory or temporary
        command = [*processes(n_processes), ROOT / "build" / "setsudan", scene,
                   "--output", directory, *settings({**QUIET, **values})]
        seconds, memory, _ = timed(command)
        return Run(seconds, memory, events_in(directory))


def cube(n):
    """The paper's cube of n^3 elements, cut in the middle."""
    return {"Body/Elements": f"{n},{n},{n}", "Cut/Surfaces": f"y:{n // 2}"}


def table(titles, rows):
    lines = [titles, ["---"] * len(titles), *rows]
    return "\n".join("| " + " | ".join(map(str, line)) + " |" for line in lines)


def number(value):
    """Two digits, or all that stand before the point."""
    return f"{value:.0f}" if value >= 100 else f"{value:.2g}"
