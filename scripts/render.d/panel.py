# SPDX-License-Identifier: LGPL-2.1-or-later
"""Plain pictures with what a reader needs: forces, colours, scale."""

import json
import os

import matplotlib
import numpy as np
from colours import colour_map
from labels import Labels
from matplotlib.cm import ScalarMappable
from matplotlib.colors import Normalize
from matplotlib.patheffects import withStroke
from matplotlib.ticker import MaxNLocator
from PIL import Image

BLUE = "#1f4e8c"
SHADES = 51  # of red, green and blue in a small file
HALO = [withStroke(linewidth=2.5, foreground="white")]


class Pictures:
    """The plain pictures of one run."""

    def __init__(self, run):
        self.folder = os.path.join(run.path, "render", "plain")
        self.run = run
        with open(os.path.join(self.folder, "view.json")) as file:
            self.view = json.load(file)
        width, height = self.image(next(iter(run.frames))).size
        self.aspect = width / height

    def image(self, frame):
        return Image.open(os.path.join(self.folder, f"{frame:04d}.png"))

    def window(self, margin):
        """What pictures show, with a margin: (left, right, below, above)."""
        left, right, below, above = self.view["window"]
        return left - margin, right + margin, below - margin, above + margin

    def draw(self, axes, frame, font_size=8, window=None):
        """The picture, or a window of it, with the blade's forces as arrows;
        returns the extents of the labels."""
        width = self.aspect / 2
        axes.imshow(self.image(frame), interpolation="antialiased",
                    extent=(-width, width, -0.5, 0.5))
        left, right, below, above = window or (-width, width, -0.5, 0.5)
        axes.set(xlim=(left, right), ylim=(below, above))
        axes.set_axis_off()
        axes.apply_aspect()
        state = self.view["frames"][str(frame)]
        line_width = font_size / 7
        for line in state["front"]:
            axes.plot(*zip(*line), "--" if len(line) > 1 else ".", color=BLUE,
                      linewidth=line_width, markersize=5 * line_width,
                      scalex=False, scaley=False)
        for arrow in state["arrows"]:
            drawn = axes.annotate(
                "", xy=arrow["tip"], xytext=arrow["tail"], annotation_clip=False,
                arrowprops={"arrowstyle": "-|>", "color": BLUE, "shrinkA": 0,
                            "shrinkB": 0, "linewidth": line_width,
                            "mutation_scale": 1.2 * font_size})
            drawn.arrow_patch.set_path_effects(HALO)
        return label_forces(axes, state["arrows"], font_size)

    def draw_colours(self, figure, axes, font_size=8, **options):
        """The colour bar, with the field's name and unit."""
        view = self.view
        colours = ScalarMappable(Normalize(*view["range"]), colour_map(view))
        bar = figure.colorbar(colours, cax=axes, extend=view["extend"], **options)
        bar.locator = MaxNLocator(4, integer=view["colours"] < 256)
        bar.minorticks_off()
        bar.formatter.set_powerlimits((-3, 4))
        bar.formatter.set_useMathText(True)
        bar.update_ticks()
        bar.outline.set_linewidth(0.5)
        axes.tick_params(labelsize=font_size, width=0.5)
        for axis in (axes.xaxis, axes.yaxis):
            axis.get_offset_text().set_fontsize(font_size)
        unit = f" [{view['unit']}]" if view["unit"] else ""
        bar.set_label(view["field"].replace("_", " ") + unit, fontsize=font_size)

    def draw_scale(self, figure, corner, picture_height, font_size=8):
        """A bar of a round length from a corner (in inches) of the figure, for
        pictures of a height in inches, and the axes beside it."""
        per_inch = self.view["height"] / picture_height
        length = round_below(0.25 * self.aspect * self.view["height"])
        width, height = figure.get_size_inches()
        axes = figure.add_axes([0, 0, 1, 1], frameon=False, xlim=(0, width),
                               ylim=(0, height), xticks=[], yticks=[])
        x, y = corner
        end = x + length / per_inch
        axes.plot([x, x, x, end, end, end],
                  [y + d for d in (-0.03, 0.03, 0, 0, 0.03, -0.03)], "k-",
                  linewidth=1, solid_joinstyle="miter")
        axes.text((x + end) / 2, y + 0.05,
                  f"{length:g} {self.view['length_unit']}".strip(),
                  ha="center", va="bottom", fontsize=font_size)
        self.draw_axes(axes, (end + 0.05 * font_size, y), 0.03 * font_size,
                       font_size)

    def draw_axes(self, axes, origin, length, font_size):
        for name, (dx, dy) in zip("xyz", self.view["axes"]):
            if dx * dx + dy * dy < 0.01:  # it points at the reader
                continue
            axes.annotate("", xytext=origin,
                          xy=(origin[0] + length * dx, origin[1] + length * dy),
                          arrowprops={"arrowstyle": "-|>", "color": "black",
                                      "shrinkA": 0, "shrinkB": 0, "linewidth": 0.7,
                                      "mutation_scale": 0.7 * font_size})
            axes.text(origin[0] + 1.35 * length * dx, origin[1] + 1.35 * length * dy,
                      name, ha="center", va="center", fontsize=font_size,
                      style="italic")


def label_forces(axes, arrows, font_size):
    """The largest forces first, as far as there is room."""
    labels = Labels(axes, font_size, color=BLUE, fontweight="bold",
                    path_effects=HALO)
    largest_first = sorted(arrows, key=lambda arrow: -arrow["force"])
    labels.place([(arrow["tip"], arrow["tail"], f"{arrow['force']:.3g}")
                  for arrow in largest_first])
    return labels.extents()


def write(figure, left, bottom, text, **style):
    """A text at a place of the figure, made smaller if it is too long for it."""
    drawn = figure.text(left, bottom, text, **style)
    width = drawn.get_window_extent(figure.canvas.get_renderer()).width
    room = (1 - 2 * left) * figure.bbox.width
    drawn.set_fontsize(drawn.get_fontsize() * min(1, room / max(width, 1)))


def save_small(figure, name):
    """A PNG of fewer shades than the eye tells apart."""
    figure.canvas.draw()
    pixels = np.asarray(figure.canvas.buffer_rgba())[:, :, :3].astype(float)
    shades = np.round(pixels * SHADES / 255) * (255 / SHADES)
    Image.fromarray(shades.astype(np.uint8)).save(name, optimize=True)


def round_below(length):
    """The largest of 1, 2, 5, 10... that is not longer."""
    power = 10.0 ** int(f"{length:e}".split("e")[1])
    return max(n * power for n in (1, 2, 5) if n * power <= length)


matplotlib.use("Agg")
