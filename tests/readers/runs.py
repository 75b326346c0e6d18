# SPDX-License-Identifier: LGPL-2.1-or-later
"""Scenes whose results are read: small ones of all kinds, what their bodies measure,
and starting them."""

import argparse
import pathlib
import subprocess
import sys
import tempfile
from typing import NamedTuple, Sequence

TESTS = pathlib.Path(__file__).resolve().parents[1]
sys.path += [str(TESTS / "program"), str(TESTS / "scenes")]
from program_cases import scene_text

SKIPPED = 77
CUBE = {
    "Length unit": "mm",
    "Force unit": "N",
    "Body/Size": "2, 2, 2",
    "Body/Elements": "2, 2, 2",
    "Material/Shear limit": "0.001",
    "Support/Fixed faces": "bottom",
    "Load/Body force": "0, 0, -0.001",
    "Blade/Edge loads": "0.5:0.01, 1.5:0.02",
    "Blade/Thickness": "0.01",
    "Cut/Surfaces": "y:1",
    "Output/Node tables": "true",
}
SQUARE = {
    **CUBE,
    "Dimension": "2",
    "Body/Size": "2, 2",
    "Body/Elements": "2, 2",
    "Load/Body force": "0, -0.001",
    "Blade/Direction": "0, -1",
    "Blade/Edge loads": "0:0.01",
    "Cut/Surfaces": "x:1",
}
LINEAR, QUADRATIC = ({"Body/Element type": kind} for kind in ("linear", "quadratic"))
REFINED = {"Cut/Refinement near cut": "1", "Body/Elements": "3, 4, 2",
           "Cut/Surfaces": "y:2"}
CROSSED = {"Body/Elements": "2, 2, 1", "Cut/Surfaces": "y:1; x:1"}
TRAVEL = {"Blade/Drive": "travel", "Blade/Edge loads": "", "Blade/Shape": "wedge",
          "Blade/Thickness": "0.1", "Blade/Shoulder radius": "0.1",
          "Blade/Sharpness": "0", "Material/Toughness": "1e-5",
          "Yield/Criterion": "energy release"}
FAR = {"Body/Translate": "500000, 5000000, 0",
       "Blade/Edge loads": "500000.5:0.01, 500001.5:0.02"}
BODIES = TESTS.parent / "prm" / "bodies"
CASES = TESTS / "cases"


class Run(NamedTuple):
    """A scene: as values, or a file; what its body measures; how many pieces."""

    name: str
    scene: object
    volume: float
    box: Sequence[Sequence[float]]
    pieces: int = 2
    # The number of cells, where elements are not refined.
    cells: int = 0
    # How exact volumes by VTK are: it takes curved cells for straight ones.
    tolerance: float = 1e-6
    settings: Sequence[str] = ()
    # Whether it does not run on several processes.
    is_serial: bool = False

    @property
    def dimension(self):
        return len(self.box[0])


def cube(name, *changes, pieces=2, cells=0, shift=(0, 0, 0), **more):
    values = {key: value for change in (CUBE, *changes) for key, value in change.items()}
    high = [x + 2 for x in shift]
    return Run(name, values, 8, (shift, high), pieces, cells, **more)


def square(name, *changes, pieces=2, cells=0, **more):
    values = {key: value for change in (SQUARE, *changes)
              for key, value in change.items()}
    return Run(name, values, 4, ((0, 0), (2, 2)), pieces, cells, **more)


def start(options, run, directory):
    """Start a scene; its results are below the directory."""
    scene = run.scene
    if isinstance(scene, dict):
        scene = directory / "scene.prm"
        scene.write_text(scene_text(run.scene)[0])
    command = [options.program, str(scene), "--output", str(directory / "out")]
    for setting in run.settings:
        command += ["--set", setting]
    if options.processes > 1:
        command = [options.mpiexec, "-np", str(options.processes), *command]
    result = subprocess.run(command, capture_output=True, text=True, check=False,
                            cwd=directory)
    if result.returncode != 0:
        raise RuntimeError(result.stderr.strip())
    return directory / "out"


def main(test, runs, modules=("vtkmodules",)):
    """Start each run and hand its results to the test, a function of the run and of
    its directory that gives problems; skip where a reader is missing."""
    parser = argparse.ArgumentParser()
    parser.add_argument("program")
    parser.add_argument("mpiexec", nargs="?", default="mpirun")
    parser.add_argument("processes", nargs="?", type=int, default=1)
    options = parser.parse_args()
    for module in modules:
        try:
            __import__(module)
        except ImportError:
            print(f"skipped: there is no {module}")
            sys.exit(SKIPPED)
    n_problems = 0
    for run in runs:
        if run.is_serial and options.processes > 1:
            continue
        with tempfile.TemporaryDirectory() as name:
            try:
                output = start(options, run, pathlib.Path(name))
                problems = list(test(run, output))
            except RuntimeError as error:
                problems = [str(error)]
        n_problems += len(problems)
        print(f"{run.name}: {len(problems)} problems")
        print("".join(f"  {problem}\n" for problem in problems[:12]), end="")
    sys.exit(1 if n_problems else 0)
