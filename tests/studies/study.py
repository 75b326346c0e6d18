# SPDX-License-Identifier: LGPL-2.1-or-later
"""scripts/study: its table and plots, that it goes on, and what it refuses.

usage: study.py PROGRAM
"""

import csv
import importlib.util
import json
import pathlib
import shutil
import sys
import tempfile

from scripts import SCENE, Failure, needs, refuses, start

GRID = """
scene = "scene.prm"
directory = "out"
jobs = 2
plot = [["mean_force", "Material/Toughness"], ["first_yield", "Blade/Friction"]]
[grid]
"Material/Toughness" = [0.5, 1]
"Blade/Friction" = [0, 0.2]
"""
HEAD = 'scene = "scene.prm"\ndirectory = "new"\n'
# What is wrong, and what the sentence must have.
WRONG = [
    ("", "no scene"),
    ('scene = "scene.prm"\n', "no directory"),
    ("scene = ", "no TOML file"),
    ('scene = "other.prm"\ndirectory = "new"\n[grid]\n"Blade/Friction" = [1]\n',
     "no scene '.*other.prm'"),
    (HEAD + "colour = 1\n", "unknown key 'colour'"),
    (HEAD, "either"),
    (HEAD + "[grid]\n", "grid.*empty"),
    (HEAD + '[grid]\n"Blade/Friction" = []\n', "Blade/Friction.*not empty"),
    (HEAD + '[grid]\n"Blade/Friction" = 1\n', "Blade/Friction.*list"),
    (HEAD + '[grid]\n"Blade/Friction" = [[1]]\n', "neither a number nor a text"),
    (HEAD + '[grid]\n"Blade/Frictio" = [1]\n', "Frictio"),
    (HEAD + '[grid]\n"Blade/Friction" = [0.1, -1]\n', "Friction = -1.*Friction"),
    (HEAD + '[grid]\n"Blade/Friction" = [1, 1]\n', "twice"),
    (HEAD + '[grid]\n"Output/Directory" = ["a"]\n', "Output/Directory"),
    (HEAD + 'jobs = 0\n[grid]\n"Blade/Friction" = [1]\n', "jobs"),
    (HEAD + 'sheet = 1\n[grid]\n"Blade/Friction" = [1]\n', "sheet.*true, false or a list"),
    (HEAD + 'sheet = true\n[grid]\n"Blade/Friction" = [1]\n', "a sheet needs frames"),
    (HEAD + 'plot = "work"\n[grid]\n"Blade/Friction" = [1]\n', "plot"),
    (HEAD + 'plot = ["work", "Blade/Angle"]\n[grid]\n"Blade/Friction" = [1]\n',
     "Blade/Angle"),
]


def times(folder):
    return {path: path.stat().st_mtime_ns for path in folder.rglob("summary.json")}


def table_of(folder):
    with open(folder / "out" / "study.csv", newline="") as file:
        return list(csv.DictReader(file))


def check_grid(program, folder):
    """Four runs, whose numbers are those of their summaries; the plots are there."""
    (folder / "grid.toml").write_text(GRID)
    start("study", program, "grid.toml", folder=folder)
    lines = table_of(folder)
    settings = [(line["Material/Toughness"], line["Blade/Friction"]) for line in lines]
    if settings != [("0.5", "0"), ("0.5", "0.2"), ("1", "0"), ("1", "0.2")]:
        raise Failure(f"the table has the runs {settings}")
    for line in lines:
        summary = json.loads((folder / "out" / line["directory"] /
                              "summary.json").read_text())
        for key, value in summary.items():
            if line[key] != ("" if value is None else str(value)):
                raise Failure(f"{key} of {line['directory']} is {line[key]}, not {value}")
    forces = [float(line["mean_force"]) for line in lines]
    if not forces[0] < forces[1] < forces[3] or not forces[0] < forces[2] < forces[3]:
        raise Failure(f"the mean forces are {forces}")
    for name in ("forces", "mean_force_against_Material_Toughness",
                 "first_yield_against_Blade_Friction"):
        for kind in (".png", ".pdf"):
            path = folder / "out" / (name + kind)
            if not path.is_file() or path.stat().st_size < 1000:
                raise Failure(f"there is no {path.name}")


def check_going_on(program, folder):
    """Runs that have ended stay; one that is missing, and one of another scene, are run
    again."""
    before, lines = times(folder), table_of(folder)
    missing, other = (folder / "out" / lines[i]["directory"] for i in (1, 2))
    (missing / "summary.json").unlink()
    text = (other / "parameters.prm").read_text()
    (other / "parameters.prm").write_text(text.replace("= 30", "= 31"))
    start("study", program, "grid.toml", folder=folder)
    changed = {path.parent for path, time in times(folder).items()
               if before[path] != time}
    if changed != {missing, other}:
        raise Failure(f"the runs made again are {changed}")
    for line, earlier in zip(table_of(folder), lines):
        if {**line, "seconds": 0} != {**earlier, "seconds": 0}:
            raise Failure(f"the table has changed: {line}, before {earlier}")
    # A scene that has changed gives other runs.
    (folder / "scene.prm").write_text(SCENE.replace("= 30", "= 32"))
    start("study", program, "grid.toml", folder=folder)
    if any(before.get(path) == time for path, time in times(folder).items()):
        raise Failure("runs of another scene were kept")
    (folder / "scene.prm").write_text(SCENE)


def check_failure(program, folder):
    """A run that fails is named; the others are in the table."""
    (folder / "runs.toml").write_text(
        'scene = "scene.prm"\ndirectory = "out"\n[[run]]\n"Blade/Friction" = 0.3\n'
        '[[run]]\n"Material/Toughness" = 2\n')
    # A directory that holds files of somebody else.
    blocked = folder / "out" / "Friction=0.3"
    blocked.mkdir()
    (blocked / "pieces.csv").write_text("mine")
    message = start("study", program, "runs.toml", folder=folder, status=1)
    if "Friction=0.3 failed: " not in message or "pieces.csv" not in message:
        raise Failure(f"the message is '{message}'")
    first, second = table_of(folder)
    if first["work"] or not second["work"] or first["Material/Toughness"]:
        raise Failure(f"the table is {first}, {second}")
    if (blocked / "pieces.csv").read_text() != "mine":
        raise Failure("a file of somebody else was replaced")


def check_sheet(program, folder):
    """A line for each run, in the same colours; where pictures can be painted."""
    if not importlib.util.find_spec("vtkmodules") or not shutil.which("xvfb-run"):
        return
    heights = []
    for values, sheet in (("0.5", "true"), ("0.5, 2", '["--range", "0,7"]')):
        (folder / "sheet.toml").write_text(
            f'scene = "scene.prm"\ndirectory = "sheets"\nsheet = {sheet}\n[grid]\n'
            f'"Material/Toughness" = [{values}]\n"Output/Frames" = ["stages"]\n')
        start("study", program, "sheet.toml", folder=folder)
        pixels = plt.imread(folder / "sheets" / "sheet.png")
        heights.append(len(pixels))
        if pixels.min() > 0.5 or (pixels[..., :3].std(axis=2) > 0.1).sum() < 100:
            raise Failure("the sheet is white or grey")
    views = [json.loads(path.read_text())
             for path in (folder / "sheets").rglob("view.json")]
    if len(views) != 2 or any(view["range"] != [0, 7] for view in views):
        raise Failure("the runs of a sheet have other colours than it asks for")
    if not 1.4 * heights[0] < heights[1] < 2 * heights[0]:
        raise Failure(f"sheets of one and of two runs are {heights} pixels high")


def check_labels():
    """Runs are named by the settings that all have, where these tell them apart."""
    sys.path.append(str(pathlib.Path(__file__).resolve().parents[2] / "scripts" /
                        "studies.d"))
    from study_file import labels_of
    for last, expected in (("b", ["X = a", "X = b"]), ("a", ["X = a", "X = a, Y = c"])):
        labels = labels_of([{"M/X": "a"}, {"M/X": last, "M/Y": "c"}])
        if labels != expected:
            raise Failure(f"runs are named {labels} instead of {expected}")


def check_refusals(program, folder):
    for text, piece in WRONG:
        (folder / "wrong.toml").write_text(text)
        refuses("study", program, "wrong.toml", folder=folder, pieces=[piece])
    refuses("study", program, "missing.toml", folder=folder, pieces=["missing.toml"])


def main(program):
    with tempfile.TemporaryDirectory() as directory:
        folder = pathlib.Path(directory)
        (folder / "scene.prm").write_text(SCENE)
        try:
            check_labels()
            check_refusals(program, folder)
            check_grid(program, folder)
            check_going_on(program, folder)
            check_failure(program, folder)
            check_sheet(program, folder)
        except Failure as failure:
            print(f"FAILED: {failure}")
            return 1
    return 0


if __name__ == "__main__":
    needs("tomllib", "matplotlib")
    from matplotlib import pyplot as plt
    sys.exit(main(str(pathlib.Path(sys.argv[1]).resolve())))
