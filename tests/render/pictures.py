# SPDX-License-Identifier: LGPL-2.1-or-later
"""Runs, drawn by scripts/render: which pictures there are and what is in them.

usage: pictures.py PROGRAM
"""

import itertools
import json
import pathlib
import shutil
import subprocess
import sys

TESTS = pathlib.Path(__file__).resolve().parents[1]
RENDER = TESTS.parent / "scripts" / "render"
sys.path += [str(TESTS / "readers"), str(RENDER) + ".d"]
from runs import BODIES, LINEAR, SKIPPED, Run, cube, main, square

SIZE = (420, 360)
NAMES = ["animation.gif", "film_strip.png", "film_strip.pdf", "forces.png",
         "forces.pdf"]
NINE = {"Blade/Edge loads": ", ".join(f"{i / 4}:{0.001 * (i + 1)}" for i in range(9))}
TWO_CUTS = {"Body/Elements": "4, 4", "Blade/Direction": "0, -1; -1, 0",
            "Cut/Surfaces": "x:2; y:2", "Load/Body force": "0, 0"}
SOFT = {"Material/Young's modulus": "1e-4"}


def problems_of(run, output):
    result = subprocess.run(
        [str(RENDER), str(output), "--size", "%dx%d" % SIZE, "--title", run.name],
        capture_output=True, text=True, check=False)
    if result.returncode != 0:
        yield f"scripts/render: {result.stderr.strip()}"
        return
    folder = output / "render"
    view = json.loads((folder / "plain" / "view.json").read_text())
    drawn = json.loads((folder / "plain" / "labels.json").read_text())
    frames = sorted(int(path.stem[6:]) for path in output.glob("frame_*.vtu"))
    yield from file_problems(folder, frames)
    yield from label_problems(drawn)
    yield from blade_problems(run, view, drawn)
    yield from surface_problems(run, output)
    if run.name == "two cuts":
        yield from strip_problems(drawn["film_strip"])
    if (view["warp"] != 1) != (run.name == "soft"):
        yield f"displacements are drawn x {view['warp']}"


def file_problems(folder, frames):
    """All files are there; pictures have the size, several colours and much white."""
    names = NAMES + [f"frame_{frame:04d}.png" for frame in frames]
    missing = [name for name in names if not (folder / name).is_file()
               or (folder / name).stat().st_size < 1000]
    if missing:
        yield f"missing or empty: {missing}"
        return
    for name in names:
        if name.endswith(".png"):
            image = Image.open(folder / name).convert("RGB")
            if name.startswith("frame") and image.size != SIZE:
                yield f"{name} has the size {image.size}"
            colours = image.getcolors(image.width * image.height)
            white = sum(count for count, colour in colours
                        if colour == (255, 255, 255))
            if len(colours) < 50 or not 0.1 < white / (image.width
                                                       * image.height) < 0.98:
                yield f"{name} has {len(colours)} colours, {white} white pixels"


def label_problems(drawn):
    """No label of a force overlaps another."""
    places = {**drawn["labels"], **{f"panel {panel['frame']}": panel["labels"]
                                    for panel in drawn["film_strip"]}}
    for name, boxes in places.items():
        for a, b in itertools.combinations(boxes, 2):
            if a[0] < b[2] and b[0] < a[2] and a[1] < b[3] and b[1] < a[3]:
                yield f"{name}: the labels at {a} and {b} overlap"


def blade_problems(run, view, drawn):
    """States under the blade have its forces, its edge, and a label or more."""
    loaded = [frame for frame, state in view["frames"].items() if state["arrows"]]
    if not loaded:
        yield "there is no blade"
    for frame in loaded:
        state = view["frames"][frame]
        arrows = state["arrows"]
        if "nine" in run.name and len(arrows) != 9:
            yield f"frame {frame} has {len(arrows)} forces"
        if not state["front"]:
            yield f"frame {frame} has no front"
        if not drawn["labels"][f"frame_{int(frame):04d}.png"]:
            yield f"frame {frame} has forces without a label"
        if any(abs(x) > 0.7 for arrow in arrows for x in arrow["tip"]):
            yield f"frame {frame} has a force outside of the picture"


def surface_problems(run, output):
    """The lattice of a body at rest encloses it: the table of points is right."""
    frame = Frame(RunDirectory(str(output)), 0, "node")
    frame.warp(1, None)
    low, high = frame.surface.min(axis=0), frame.surface.max(axis=0)
    if run.scene is not None and isinstance(run.scene, dict):
        corners = frame.surface[frame.lattice.quadrilaterals()]
        areas = np.linalg.norm(np.cross(corners[:, 2] - corners[:, 0],
                                        corners[:, 3] - corners[:, 1]), axis=1) / 2
        expected = 24 if run.dimension == 3 else 4
        if abs(areas.sum() - expected) > 1e-5 * expected:
            yield f"the surface measures {areas.sum()} instead of {expected}"
    if (low > frame.rest.min(axis=0) + 1e-6).any() or \
            (high < frame.rest.max(axis=0) - 1e-6).any():
        yield f"the surface goes from {low} to {high}"


def strip_problems(panels):
    """Each of two cuts has its first, a middle and its last state."""
    if len(panels) > 8:
        yield f"the film strip has {len(panels)} panels"
    for cut in ("cut 1: ", "cut 2: "):
        captions = [panel["caption"][0][len(cut):] for panel in panels
                    if panel["caption"][0].startswith(cut)]
        if captions[:1] != ["deformed"] or not captions[-1].endswith("pieces") or \
                not any("split" in caption for caption in captions[1:-1]):
            yield f"the film strip shows of {cut}{captions}"


try:
    import matplotlib  # noqa: F401: what the pictures need, with VTK
    import numpy as np
    from frame import Frame
    from PIL import Image
    from run_directory import RunDirectory
except ImportError as error:
    print(f"skipped: {error}")
    sys.exit(SKIPPED)
if not shutil.which("xvfb-run"):
    print("skipped: there is no xvfb-run")
    sys.exit(SKIPPED)
main(problems_of, [
    square("two cuts", TWO_CUTS, pieces=4),
    cube("nine forces", NINE),
    cube("soft", LINEAR, SOFT),
    Run("tube", BODIES / "tube.prm", 0, ((0, 0, 0), (0, 0, 0)),
        settings=["Output/Frames=stages"]),
], ("vtkmodules.vtkRenderingOpenGL2", "matplotlib"))
