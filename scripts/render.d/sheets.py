# SPDX-License-Identifier: LGPL-2.1-or-later
"""Labelled frames, film strip, animation and plots of one painted run."""

import json
import os
from math import sqrt

from animation import animate
from curve import plot_curve, travels
from film_strip import draw_film_strip
from forces import plot_forces
from matplotlib import pyplot as plt
from panel import Pictures, write
from words import cutting_stress, legend, load, stage

DPI = 100
# Around the body, for a picture of USUAL pixels: colours, words above and below.
RIGHT, ABOVE, BELOW, USUAL = 110, 88, 100, 900
SMALLEST = 0.75  # of words, as far as there is room


def draw_sheets(run):
    pictures = Pictures(run)
    folder = os.path.join(run.path, "render")
    files, labels = [], {}
    for frame in run.frames:
        files.append(os.path.join(folder, f"frame_{frame:04d}.png"))
        labels[os.path.basename(files[-1])] = label_frame(pictures, frame, files[-1])
    panels = draw_film_strip(pictures, os.path.join(folder, "film_strip"))
    animate(files, os.path.join(folder, "animation.gif"))
    if any(line["event"] == "deform" for line in run.statistics):
        plot = plot_curve if travels(run) else plot_forces
        plot(run, pictures.view["title"], os.path.join(folder, "forces"))
    with open(os.path.join(folder, "plain", "labels.json"), "w") as file:
        json.dump({"labels": labels, "film_strip": panels}, file, indent=1)


def scale_of(size):
    """Of words and margins: smaller pictures need larger ones for their size."""
    return max(min(SMALLEST, min(size) / 450), sqrt(size[0] * size[1]) / USUAL)


def body_size(size):
    """Of the plain picture in a frame of a size, in pixels."""
    scale = scale_of(size)
    return [round(size[0] - RIGHT * scale),
            round(size[1] - (ABOVE + BELOW) * scale)]


def label_frame(pictures, frame, name):
    run, view = pictures.run, pictures.view
    width, height = view["size"]
    scale = scale_of(view["size"])
    body_width, body_height = body_size(view["size"])
    figure = plt.figure(figsize=(width / DPI, height / DPI), dpi=DPI)
    body = figure.add_axes([0, BELOW * scale / height, body_width / width,
                            body_height / height])
    extents = pictures.draw(body, frame, font_size=11 * scale)
    head = f"{view['title']}: {stage(run, frame)}"
    below = [words for words in (load(run, frame), cutting_stress(run, frame))
             if words]
    if view["frames"][str(frame)]["apart"]:
        below = ["pieces drawn apart"]
    for text, size, top in ((head, 15, 34), ("; ".join(below), 11, 62)):
        write(figure, 20 * scale / width, 1 - top * scale / height, text,
              fontsize=size * scale)
    write(figure, 20 * scale / width, 12 * scale / height, legend(run, view),
          fontsize=10 * scale)
    pictures.draw_colours(
        figure, figure.add_axes([1 - (RIGHT - 5) * scale / width, 0.25,
                                 18 * scale / width, 0.5]), 10 * scale)
    pictures.draw_scale(figure, (20 * scale / DPI, 54 * scale / DPI),
                        body_height / DPI, 10 * scale)
    figure.savefig(name, dpi=DPI, pil_kwargs={"compress_level": 4})
    plt.close(figure)
    return extents
