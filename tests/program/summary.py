# SPDX-License-Identifier: LGPL-2.1-or-later
"""summary.json of runs that end in each way: one line, whose numbers are those of
statistics.csv.

usage: summary.py PROGRAM
"""

import json
import math
import pathlib
import subprocess
import sys
import tempfile

from program_cases import HANGS

SCENES = pathlib.Path(__file__).resolve().parents[1] / "scenes"
sys.path.append(str(SCENES))
from tables import read

# A blade that travels: through, in three cuts, and to where its path ends; arrested
# before the first yield, behind some, and without a cut.
RUNS = ["blade_wedge", "blade_dice", "blade_withdraw", "arrest", "arrest_inside",
        "deformation"]
KEYS = ["first_yield", "mean_force", "work", "max_strain", "doubtful_states", "frames",
        "pieces", "processes", "seconds"]
TOLERANCE = 1e-9


def expected(lines):
    """The summary of the lines of a table, as far as they tell it."""
    travels = "travel" in lines[0]
    yields = [line for line in lines if line["event"] == "yield"]
    work, way = 0.0, 0.0
    for before, line in zip(yields, yields[1:]):
        if travels and before["cut"] == line["cut"]:
            work += float(line["work"]) - float(before["work"])
            way += float(line["travel"]) - float(before["travel"])
    first = "travel" if travels else "load_factor"
    return {
        "first_yield": float(yields[0][first]) if yields else None,
        "mean_force": work / way if way > 0 else None,
        "work": float(lines[-1]["work"]) if travels else None,
        "max_strain": max(float(line["max_strain"]) for line in lines),
        "frames": int(lines[-1]["frame"]) + 1,
        "pieces": int(lines[-1]["pieces"]),
        "processes": 1}


def is_close(value, wanted):
    if value is None or wanted is None:
        return value is wanted
    return math.isclose(value, wanted, rel_tol=TOLERANCE, abs_tol=1e-14)


def problems(program, name, directory):
    output = directory / name
    done = subprocess.run(
        [program, str(SCENES / f"{name}.prm"), "--output", str(output), "--set",
         "Output/Frames=none"], stdout=subprocess.PIPE, stderr=subprocess.PIPE,
        universal_newlines=True, timeout=HANGS, check=False)
    if done.returncode != 0:
        yield done.stderr
        return
    text = (output / "summary.json").read_text()
    if text.count("\n") != 1 or not text.endswith("\n"):
        yield f"it is not one line: {text}"
    summary = json.loads(text)
    if list(summary) != KEYS:
        yield f"its keys are {list(summary)}"
        return
    lines = read(output / "statistics.csv")
    for key, wanted in expected(lines).items():
        if not is_close(summary[key], wanted):
            yield f"{key} is {summary[key]} instead of {wanted}"
    doubts = done.stdout.rpartition("; ")[2].partition(" of them not to be trusted")
    if summary["doubtful_states"] != (int(doubts[0]) if doubts[1] else 0):
        yield f"doubtful_states is {summary['doubtful_states']}: {done.stdout[-200:]}"
    if not summary["seconds"] >= float(lines[-1]["seconds"]):
        yield f"seconds is {summary['seconds']}"


def main(program):
    failed = False
    with tempfile.TemporaryDirectory() as directory:
        for name in RUNS:
            for problem in problems(program, name, pathlib.Path(directory)):
                print(f"FAILED: {name}: {problem}")
                failed = True
    return int(failed)


if __name__ == "__main__":
    sys.exit(main(sys.argv[1]))
