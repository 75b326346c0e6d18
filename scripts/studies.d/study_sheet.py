# SPDX-License-Identifier: LGPL-2.1-or-later
"""The film strips of all runs of a study on one sheet, with the same colours."""

import pathlib
import subprocess

from film_strip import (CAPTION, DPI, EDGE, FINE, FOOT, MARGIN, WIDTH, caption_of, choose,
                        draw_foot)
from matplotlib import pyplot as plt
from panel import Pictures, save_small, write
from program import Refusal, last_line
from run_directory import RunDirectory
from study_file import labels_of

RENDER = pathlib.Path(__file__).resolve().parents[1] / "render"
HEAD = 0.24  # inches, of a run's settings


def draw_sheet(ended, name, options):
    """NAME.png and NAME.pdf; each run has a line of panels below its settings, painted
    with options of scripts/render.

    Raises Refusal where the pictures cannot be painted."""
    painted = subprocess.run([str(RENDER), *(run.path for _, run in ended), *options],
                             capture_output=True, text=True, check=False)
    if painted.returncode != 0:
        raise Refusal(f"there is no sheet: {last_line(painted)}")
    strips = [Pictures(RunDirectory(run.path)) for _, run in ended]
    chosen = [choose(pictures.run) for pictures in strips]
    labels = labels_of([settings for settings, _ in ended])
    panel = (WIDTH - 2 * EDGE) / max(map(len, chosen))
    left, right, below, above = window = strips[0].window(MARGIN)
    tall = panel * (above - below) / (right - left)
    step = HEAD + CAPTION + tall
    height = len(ended) * step + FOOT
    figure = plt.figure(figsize=(WIDTH, height), dpi=DPI)
    for row, (text, pictures, frames) in enumerate(zip(labels, strips, chosen)):
        top = height - row * step
        write(figure, EDGE / WIDTH, (top - 0.18) / height, text, fontsize=9)
        for column, frame in enumerate(frames):
            x = EDGE + column * panel
            axes = figure.add_axes([x / WIDTH, (top - step) / height, panel / WIDTH,
                                    tall / height])
            figure.text(x / WIDTH, (top - HEAD - 0.03) / height,
                        "\n".join(caption_of(pictures.run, pictures.view, frame)),
                        fontsize=5, va="top", linespacing=1.15)
            pictures.draw(axes, frame, font_size=5, window=window)
    draw_foot(figure, strips[0], tall / (above - below))
    save_small(figure, f"{name}.png")
    figure.savefig(f"{name}.pdf", dpi=FINE)
    plt.close(figure)
