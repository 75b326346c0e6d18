"""Labelled frames, film strip, animation and plot of one painted run.

sheets.py DIR
"""

import os
import sys

import matplotlib
import numpy as np

matplotlib.use("Agg")
from matplotlib import pyplot as plt  # noqa: E402
from panel import Pictures, legend, numbers, stage  # noqa: E402
from PIL import Image  # noqa: E402
from run_directory import RunDirectory  # noqa: E402

PANELS = 6                # of a film strip, at most
SHOWN = 8.0               # seconds of an animation that is not short
SHORTEST, LONGEST = 0.12, 1.5  # seconds a frame is shown


def main(path):
    run = RunDirectory(path)
    pictures = Pictures(run)
    folder = os.path.join(path, "render")
    files = [label_frame(pictures, frame, folder) for frame in run.frames]
    draw_film_strip(pictures, os.path.join(folder, "film_strip.png"))
    animate(files, os.path.join(folder, "animation.gif"))
    if any(line["event"] == "deform" for line in run.statistics):
        plot_forces(run, os.path.join(folder, "forces.png"))


def label_frame(pictures, frame, folder):
    height, width = pictures.image(frame).shape[:2]
    full_width, full_height = width + 170, height + 130
    figure = plt.figure(figsize=(full_width / 100, full_height / 100))
    body = figure.add_axes([0, 45 / full_height, width / full_width,
                            height / full_height])
    pictures.draw(body, frame, font_size=13)
    for text, size, top in ((stage(pictures.run, frame), 17, 40),
                            (numbers(pictures.run, frame), 12, 70),
                            (legend(pictures.run), 11, full_height - 12)):
        figure.text(20 / full_width, 1 - top / full_height, text,
                    fontsize=size)
    pictures.draw_colours(figure, figure.add_axes([1 - 120 / full_width, 0.25,
                                                   20 / full_width, 0.5]))
    name = os.path.join(folder, f"frame_{frame:04d}.png")
    figure.savefig(name, dpi=100)
    plt.close(figure)
    return name


def draw_film_strip(pictures, name):
    """The stages from rest to pieces, as in figure 5 of the paper."""
    frames = list(pictures.run.frames)
    after_first = np.linspace(1, len(frames) - 1, PANELS - 1).round()
    chosen = [frames[i] for i in sorted({0, *after_first.astype(int)})]
    height, width = pictures.image(frames[0]).shape[:2]
    panel = 2.9
    figure = plt.figure(figsize=(panel * len(chosen),
                                 panel * height / width + 1.0))
    grid = figure.add_gridspec(2, len(chosen), height_ratios=[30, 1],
                               left=0.01, right=0.99, top=0.9, bottom=0.14,
                               wspace=0.02, hspace=0.1)
    for column, frame in enumerate(chosen):
        axes = figure.add_subplot(grid[0, column])
        pictures.draw(axes, frame)
        axes.set_title(f"({chr(ord('a') + column)}) "
                       f"{stage(pictures.run, frame)}", fontsize=10)
    middle = grid[1, :].subgridspec(1, 3, width_ratios=[4, 3, 0.2])
    pictures.draw_colours(figure, figure.add_subplot(middle[1]),
                          orientation="horizontal")
    figure.text(0.02, 0.1, legend(pictures.run), fontsize=9)
    figure.savefig(name, dpi=100)
    plt.close(figure)


def animate(files, name):
    seconds = min(LONGEST, max(SHORTEST, SHOWN / len(files)))
    images = [with_palette(Image.open(file).convert("RGB")) for file in files]
    durations = [int(1000 * seconds)] * (len(images) - 1) + [2500]
    images[0].save(name, save_all=True, append_images=images[1:], loop=0,
                   duration=durations)


def with_palette(image):
    """The 256 colours of a GIF, rare ones as the arrows' among them."""
    palette = image.quantize(256, method=Image.Quantize.MAXCOVERAGE)
    return image.quantize(palette=palette, dither=Image.Dither.FLOYDSTEINBERG)


def plot_forces(run, name):
    length = run.parameters.get("Length unit", "")
    force = run.parameters.get("Force unit", "")
    figure, (above, below) = plt.subplots(2, 1, sharex=True, figsize=(6.4, 6),
                                          constrained_layout=True)
    cuts = sorted({line["cut"] for line in run.statistics})
    for cut in cuts:
        lines = [line for line in run.statistics
                 if line["cut"] == cut and line["event"] == "deform"]
        of_cut = f" (cut {cut + 1})" if len(cuts) > 1 else ""
        depth = [line["depth"] for line in lines]

        def plot(axes, column, label, style):
            axes.plot(depth, [line[column] for line in lines], style,
                      label=label + of_cut)

        plot(above, "blade_force", "blade force", "o-")
        plot(below, "cutting_stress", "cutting stress", "o-")
        plot(below, "required_stress", "required stress", "--")
    above.set_ylabel(f"blade force [{force}]")
    below.set_ylabel(f"stress [{run.unit('stress')}]")
    below.set_xlabel(f"depth of the front row [{length}]")
    for axes in (above, below):
        axes.set_ylim(bottom=0)
        axes.grid(alpha=0.3)
        axes.legend()
    figure.savefig(name, dpi=100)
    plt.close(figure)


main(sys.argv[1])
