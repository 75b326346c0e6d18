# SPDX-License-Identifier: LGPL-2.1-or-later
"""The command line: what is wrong with it ends with status 2, what only asks for
something with status 0, and none of it writes a file.

usage: command_line.py PROGRAM
"""

import pathlib
import subprocess
import sys
import tempfile

from program_cases import HANGS, PLANE_SCENE, SCENE, Case, run_cases, scene_text

BODIES = pathlib.Path(__file__).resolve().parents[2] / "prm" / "bodies"
SCENES = {"scene.prm": scene_text(SCENE)[0], "plane.prm": scene_text(PLANE_SCENE)[0]}
SECTIONS = ("read scene", "set up body", "find cut", "surgery", "solve", "check state",
            "release ties", "frames and tables")
WINDOWS_SCENE = {"scene.prm": SCENES["scene.prm"].replace("\n", "\r\n")}


def case(status, arguments, *pieces, files=None):
    name = "setsudan " + " ".join(arguments)
    return Case(name, arguments, files or SCENES, status, pieces)


CASES = [
    case(2, [], "SCENE"),
    case(2, ["--nonsense"], "--nonsense"),
    case(2, ["scene.prm", "--nonsense"], "--nonsense"),
    case(2, ["scene.prm", "plane.prm"], "plane.prm"),
    case(2, ["scene.prm", "--set"], "--set"),
    case(2, ["scene.prm", "--output"], "--output"),
    case(2, ["--validate"], "SCENE"),
    case(0, ["--help"], "SCENE", "--set", "--output", "--resume", "--validate", "--verbose",
         "--version"),
    case(0, ["--version"], "setsudan "),
    case(0, ["scene.prm", "--validate"], "scene.prm is a valid scene"),
    case(0, ["plane.prm", "--validate"], "plane.prm is a valid scene"),
    case(0, ["--validate", "--set", "Body/Elements=1,4,2", "scene.prm"], "valid"),
    case(0, ["scene.prm", "--validate"], "valid", files=WINDOWS_SCENE),
    # A direction that is not quite along the cut is projected.
    case(0, ["scene.prm", "--validate", "--set", "Blade/Direction=0,0.9,-1"], "valid"),
    case(0, ["scene.prm", "--validate", "--set", "Blade/Direction=0,1,-1"], "valid"),
    case(0, ["scene.prm", "--validate", "--verbose"], "Linear algebra: ", "valid"),
    case(0, ["--print-parameters"], "subsection Material", "set Young's modulus"),
    case(0, ["--print-materials"], "firm tofu", "St. Pierre", "assumed"),
    case(0, ["plane.prm", "--print-parameters"], "set Size         = 10, 10\n"),
    case(0, ["--print-parameters", "--set", "Body/Size=7,8,9"], "= 7,8,9"),
]


def run(program, arguments, directory):
    return subprocess.run(
        [program, *arguments],
        cwd=directory,
        stdout=subprocess.PIPE,
        stderr=subprocess.PIPE,
        universal_newlines=True,
        timeout=HANGS,
    )


def check_printed_parameters(program, arguments, options=()):
    """What --print-parameters prints is a scene, and prints the same again."""
    with tempfile.TemporaryDirectory() as name:
        directory = pathlib.Path(name)
        for file, text in SCENES.items():
            (directory / file).write_text(text)
        printed = run(program, [*arguments, "--print-parameters"], directory)
        (directory / "printed.prm").write_text(printed.stdout)
        valid = run(program, ["printed.prm", "--validate", *options], directory)
        again = run(program, ["printed.prm", "--print-parameters", *options], directory)
    if valid.returncode == 0 and (options or again.stdout == printed.stdout):
        return 0
    print(f"FAILED: printed parameters of {arguments}: {valid.stderr.strip()}")
    return 1


def check_run(program):
    """A scene that is right runs, and an arrest is a result."""
    failures = 0
    for options in ([], ["--set", "Material/Shear limit=1e9"]):
        with tempfile.TemporaryDirectory() as name:
            directory = pathlib.Path(name)
            (directory / "scene.prm").write_text(SCENES["scene.prm"])
            result = run(program, ["scene.prm", "--output", "here", *options], directory)
            table = (directory / "here" / "statistics.csv").read_text()
        arrested = ",arrest," in table
        if result.returncode != 0 or arrested != bool(options):
            failures += 1
            print(f"FAILED: a run with {options}: {result.stderr.strip()}")
    return failures


def check_times(program):
    """With --verbose, and only with it, a run ends with a table of its times."""
    failures = 0
    for options, wanted in ([], False), (["--verbose"], True):
        with tempfile.TemporaryDirectory() as name:
            directory = pathlib.Path(name)
            (directory / "scene.prm").write_text(SCENES["scene.prm"])
            said = run(program, ["scene.prm", *options], directory).stdout
        said = said[said.find("Results in "):]
        if any((f"| {section} " in said) != wanted for section in SECTIONS):
            failures += 1
            print(f"FAILED: times with {options}: {said}")
    return failures


def check_parameters_of_run(program):
    """parameters.prm in the output is a scene there, also with a body's file."""
    body = BODIES / "two_materials.prm"
    with tempfile.TemporaryDirectory() as name:
        directory = pathlib.Path(name)
        options = ["--set", "Output/Frames=none", "--set", "Cut/Surfaces="]
        run(program, [str(body), "--output", "results/first", *options], directory)
        scene = "results/first/parameters.prm"
        valid = run(program, [scene, "--validate"], directory)
        run(program, [scene, "--output", "second"], directory)
        tables = [
            directory / results / "statistics.csv"
            for results in ("results/first", "second")
        ]
        lines = [table.read_text().splitlines() for table in tables if table.exists()]
    if valid.returncode == 0 and len(lines) == 2 and len(lines[0]) == len(lines[1]):
        return 0
    print(f"FAILED: parameters.prm of a run: {valid.stderr.strip()}")
    return 1


if __name__ == "__main__":
    PROGRAM = sys.argv[1]
    FAILURES = run_cases(PROGRAM, CASES)
    FAILURES += check_printed_parameters(PROGRAM, ["scene.prm"])
    FAILURES += check_printed_parameters(PROGRAM, ["plane.prm"])
    # By default nothing holds the body, since no face is the obvious one.
    SUPPORT = ["--set", "Support/Fixed faces=bottom"]
    FAILURES += check_printed_parameters(PROGRAM, [], SUPPORT)
    FAILURES += check_run(PROGRAM)
    FAILURES += check_times(PROGRAM)
    FAILURES += check_parameters_of_run(PROGRAM)
    sys.exit(1 if FAILURES else 0)
