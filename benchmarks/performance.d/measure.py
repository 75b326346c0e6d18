"""How runs are timed: of the program, of benchmark programs and of CalculiX."""

import csv
import dataclasses
import json
import os
import pathlib
import subprocess
import tempfile
import time

ROOT = pathlib.Path(__file__).resolve().parents[2]
STORE = ROOT / "build" / "performance.json"
CUBE = ROOT / "prm" / "kakefuda_1996" / "cut.prm"


def remembered(key, measure):
    """What measure() gives, or gave when it was called for this key before."""
    known = json.loads(STORE.read_text()) if STORE.exists() else {}
    if key not in known:
        known[key] = measure()
        STORE.write_text(json.dumps(known, indent=1))
    print(key, known[key], flush=True)
    return known[key]


def timed(command, directory=None, limit=None, **environment):
    """Seconds and peak memory in MB of a command, which must succeed in `limit`
    seconds; nothing if it takes longer."""
    with tempfile.TemporaryFile("w+") as said:
        begin = time.monotonic()
        process = subprocess.Popen([str(word) for word in command], cwd=directory,
                                   stdout=said, stderr=said,
                                   env={**os.environ, **environment})
        while True:
            ended, status, usage = os.wait4(process.pid, os.WNOHANG)
            if ended:
                break
            if limit and time.monotonic() - begin > limit:
                process.kill()
                process.wait()
                return None
            time.sleep(0.01)
        seconds = time.monotonic() - begin
        said.seek(0)
        text = said.read()
    if status != 0:
        raise RuntimeError(f"failed: {command}\n{text[-2000:]}")
    return seconds, usage.ru_maxrss / 1024, text


def processes(n):
    """What starts a command on so many processes."""
    environment = ["bash", "-c", f'source "{ROOT}/scripts/lib/mpi.sh"; exec "$@"', "bash"]
    return [*environment, *(["mpirun", "-np", str(n)] if n > 1 else [])]


def benchmark(name, *arguments, n_processes=1):
    """The names and values that a benchmark's program prints."""
    command = [*processes(n_processes), ROOT / "build" / f"benchmark_{name}", *arguments]
    words = timed(command)[2].split()
    return {name: float(value) for name, value in zip(words[::2], words[1::2])}


def settings(values):
    return [word for name, value in values.items()
            for word in ("--set", f"{name}={value}")]


@dataclasses.dataclass
class Run:
    """A run of the program."""

    seconds: float
    memory: float
    events: list


def until_row(command, directory, n_rows):
    """Start a cut, and end it when so many rows have been solved behind the first.
    Seconds before the second one, and for each that follows it."""
    process = subprocess.Popen([str(word) for word in command],
                               stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL)
    path = directory / "statistics.csv"
    try:
        while True:
            time.sleep(0.1)
            if path.exists():
                with open(path, newline="") as table:
                    seconds = [float(line["seconds"]) for line in csv.DictReader(table)
                               if line["event"] == "deform"]
                if len(seconds) > n_rows:
                    return seconds[0], (seconds[-1] - seconds[0]) / (len(seconds) - 1)
            if process.poll() is not None:
                raise RuntimeError(f"ended early: {command}")
    finally:
        process.kill()
        process.wait()


QUIET = {"Output/Frames": "none", "Output/Checkpoint": "none",
         "Output/Node tables": "false"}


def program(scene, values, directory=None, n_processes=1):
    """Run a scene without output but the statistics, unless values say otherwise."""
    with tempfile.TemporaryDirectory() as temporary:
        directory = directory or temporary
        command = [*processes(n_processes), ROOT / "build" / "setsudan", scene,
                   "--output", directory, *settings({**QUIET, **values})]
        seconds, memory, _ = timed(command)
        with open(pathlib.Path(directory) / "statistics.csv", newline="") as table:
            return Run(seconds, memory, list(csv.DictReader(table)))


def cube(n):
    """The paper's cube of n^3 elements, cut in the middle."""
    return {"Body/Elements": f"{n},{n},{n}", "Cut/Surfaces": f"y:{n // 2}"}


def table(titles, rows):
    lines = [titles, ["---"] * len(titles), *rows]
    return "\n".join("| " + " | ".join(map(str, line)) + " |" for line in lines)


def number(value):
    """Two digits, or all that stand before the point."""
    return f"{value:.0f}" if value >= 100 else f"{value:.2g}"
