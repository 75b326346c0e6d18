# SPDX-License-Identifier: LGPL-2.1-or-later
"""Draw the frames of runs: pictures of the bodies, then the sheets of each run.

All runs share the camera, the colours and the factor of the displacements, so
that their pictures can be compared. DIR/render/plain holds the bodies without
words, and view.json, which says where in the pictures things are.
"""

import argparse
import json
import os

import numpy as np
from camera import Camera
from colours import choose_colours
from curve import plot_together, travels
from frame import Frame
from painter import Painter, outline_of
from run_directory import RunDirectory
from sheets import body_size, draw_sheets

ARROW = 0.35     # length of the largest force's arrow, of the body's size
SHEET = 0.2      # how far the blade's sheet stands out of the body
TOO_FAR = 1.0    # a displacement of the body's size is not drawn as it is,
DRAWN = 0.3      # but as about so much of the size


def main(options):
    runs = [RunDirectory(path) for path in options.directories]
    frames = [[Frame(run, number, options.field) for number in run.frames]
              for run in runs]
    every = [frame for of_run in frames for frame in of_run]
    factor = options.warp or fitting_warp(every)
    for of_run in frames:
        warp(of_run, factor)
    colours = choose_colours(every, options.field, options.range)
    add_blades(every)

    size = body_size(options.size)
    camera = Camera(every, options.view)
    shown = np.concatenate([np.vstack([frame.surface, *frame.shown])
                            for frame in every])
    camera.fit(shown, size)
    painter = Painter(camera, size, colours)
    for run, of_run in zip(runs, frames):
        view = dict(colours, unit=run.unit(options.field), warp=factor,
                    size=options.size, height=2 * camera.half_height,
                    window=camera.window(shown),
                    length_unit=run.parameters.get("Length unit", ""),
                    axes=axes_of(camera, every[0]),
                    title=options.title or run.name())
        paint_run(painter, camera, run, of_run, view)
        draw_sheets(run)
    travelling = [run for run in runs if travels(run)]
    if len(travelling) > 1:
        for run in travelling:
            plot_together(travelling, os.path.join(run.path, "render", "mean_forces"))


def read_options():
    parser = argparse.ArgumentParser()
    parser.add_argument("directories", nargs="+")
    parser.add_argument("--title")
    parser.add_argument("--field", default="maximum_shear")
    parser.add_argument("--range", type=numbers)
    parser.add_argument("--warp", type=float)
    parser.add_argument("--size", type=numbers, default=[900, 900])
    parser.add_argument("--view", type=numbers, default=[25, 25])
    return parser.parse_args()


def numbers(text):
    """The two numbers of 'A,B' or, as whole ones, of 'AxB'."""
    if "x" in text:
        return [int(number) for number in text.split("x")]
    return [float(number) for number in text.split(",")]


def fitting_warp(frames):
    """1, or a round factor by which a body that leaves all bounds stays near."""
    largest = max(np.linalg.norm(frame.displacement, axis=1).max()
                  for frame in frames)
    share = largest / frames[0].size()
    if share <= TOO_FAR:
        return 1.0
    wanted = DRAWN / share
    power = 10.0 ** np.floor(np.log10(wanted))
    return float(max(n * power for n in (1, 2, 5) if n * power <= wanted))


def warp(frames, factor):
    direction = np.array([0.0, 0.0, -1.0])
    for frame in frames:
        if frame.has_blade:
            direction = frame.facts["blade_direction"][0]
        frame.warp(factor, -direction)


def add_blades(frames):
    """Arrows (tip, tail, force), the front's lines, and what is to be seen."""
    size = frames[0].size()
    forces = [frame.forces() for frame in frames]
    largest = max((np.linalg.norm(force) for of_frame in forces
                   for _, force in of_frame), default=1)
    for frame, of_frame in zip(frames, forces):
        frame.arrows = [(tip, tip - force * ARROW * size / largest,
                         float(np.linalg.norm(force)))
                        for tip, force in of_frame]
        frame.lines = frame.front()
        # A blade that travels has a surface of its own.
        frame.backs = [back_of(frame, line) for line in frame.lines
                       if not frame.blade]
        frame.shown = [tail for _, tail, _ in frame.arrows] + frame.backs


def back_of(frame, line):
    """The upper end of the blade's sheet, which is straight as the blade."""
    direction = frame.facts["blade_direction"][0]
    level = (frame.rest @ direction).min() - SHEET * frame.size()
    return line + np.outer(level - line @ direction, direction)


def paint_run(painter, camera, run, frames, view):
    folder = os.path.join(run.path, "render", "plain")
    os.makedirs(folder, exist_ok=True)
    outline = outline_of(frames[0])
    view["frames"] = {}
    for frame in frames:
        image = painter.paint(frame, outline, zip(frame.lines, frame.backs))
        image.save(os.path.join(folder, f"{frame.number:04d}.png"),
                   compress_level=1)
        view["frames"][frame.number] = {
            "apart": frame.is_apart,
            "front": [camera.pixels(line) for line in frame.lines],
            "arrows": [{"tip": camera.pixels(tip)[0],
                        "tail": camera.pixels(tail)[0], "force": force}
                       for tip, tail, force in frame.arrows]}
    with open(os.path.join(folder, "view.json"), "w") as file:
        json.dump(view, file, indent=1)


def axes_of(camera, frame):
    """Where the axes point in the picture."""
    dimension = 2 if frame.cells.shape[1] in (4, 9) else 3
    return camera.project(np.eye(3)[:dimension]).tolist()


if __name__ == "__main__":
    main(read_options())
