# SPDX-License-Identifier: LGPL-2.1-or-later
"""Tables by the csv module, decks by CalculiX, and parameters.prm by the program.

usage: tables_and_decks.py PROGRAM
"""

import csv
import math
import re
import shutil
import subprocess
import sys

from runs import CROSSED, LINEAR, QUADRATIC, REFINED, cube, main, square

# Columns whose values are words.
WORDS = ("event", "row_pieces", "side")
EVENTS = {"rest", "deform", "yield", "release", "divide", "arrest"}


def table_problems(path):
    """A table has lines of one length, of numbers that are finite."""
    with open(path, newline="", encoding="ascii") as table:
        lines = list(csv.reader(table, strict=True))
    names = lines[0]
    if len(set(names)) != len(names) or not all(re.fullmatch(r"\w+", n) for n in names):
        yield f"{path.name} has the columns {names}"
    for number, line in enumerate(lines[1:], 2):
        if len(line) != len(names):
            yield f"{path.name}:{number} has {len(line)} columns of {len(names)}"
            return
        for name, value in zip(names, line):
            if name in WORDS or name == "number" and not value:
                # Nodes that refinement has made have no number.
                continue
            try:
                if not math.isfinite(float(value)):
                    yield f"{path.name}:{number}: {name} is {value}"
            except ValueError:
                yield f"{path.name}:{number}: {name} is '{value}'"


def statistics_problems(output):
    path = output / "statistics.csv"
    yield from table_problems(path)
    with open(path, newline="", encoding="ascii") as table:
        lines = list(csv.DictReader(table))
    if not {line["event"] for line in lines} <= EVENTS:
        yield f"the events are {[line['event'] for line in lines]}"
    frames = [int(line["frame"]) for line in lines]
    if frames != sorted(frames) or frames[0] != 0:
        yield f"the frames are {frames}"


def deck_problems(path):
    """CalculiX solves a deck without an error, and writes its displacements."""
    if shutil.which("ccx") is None:
        print("skipped: there is no ccx")
        return
    result = subprocess.run(["ccx", path.stem], cwd=path.parent, capture_output=True,
                            text=True, check=False)
    said = [line for line in result.stdout.splitlines() if "*ERROR" in line
            or "*WARNING" in line]
    if result.returncode != 0 or said:
        yield f"ccx {path.name}: status {result.returncode}: {said[:3]}"
    results = path.with_suffix(".dat")
    if not results.exists() or "displacements" not in results.read_text():
        yield f"ccx {path.name} finds no displacements"


def parameters_problems(run, output):
    """parameters.prm is a scene, with all that was set, and gives the same again."""
    path = output / "parameters.prm"
    again = output.parent / "again"
    for arguments in (["--validate"], ["--output", str(again)]):
        result = subprocess.run([sys.argv[1], str(path), *arguments], check=False,
                                capture_output=True, text=True)
        if result.returncode != 0:
            yield f"parameters.prm {arguments[0]}: {result.stderr.strip()}"
    for name, value in run.scene.items():
        name = name.rpartition("/")[2]
        if not re.search(rf"set {name}\s*= {re.escape(value)}\s*(#|$)", path.read_text(),
                         re.M):
            yield f"parameters.prm has not {name} = {value}"
    if sorted(p.name for p in output.iterdir()) != sorted(p.name for p in again.iterdir()):
        yield "parameters.prm gives other files"


def check(run, output):
    yield from parameters_problems(run, output)
    yield from statistics_problems(output)
    tables = sorted(output.glob("nodes_*.csv"))
    decks = sorted(output.glob("stage_*.inp"))
    # The state at rest has a table and no deck.
    if len(tables) != len(decks) + 1 and "Output/CalculiX decks" in run.scene:
        yield f"{len(tables)} tables, {len(decks)} decks"
    for path in [*tables, *output.glob("pieces.csv")]:
        yield from table_problems(path)
    for path in decks:
        yield from table_problems(path.with_suffix(".csv"))
        yield from deck_problems(path)


DECKS = {"Output/CalculiX decks": "true"}
RUNS = [
    cube("serendipity", DECKS),
    cube("linear", LINEAR),
    cube("quadratic", QUADRATIC),
    cube("refined", DECKS, REFINED),
    cube("crossing cuts", DECKS, CROSSED),
    square("square", DECKS),
    square("linear square", LINEAR),
]

if __name__ == "__main__":
    main(check, RUNS, ())
