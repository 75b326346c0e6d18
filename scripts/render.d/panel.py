"""Plain pictures with what a reader needs: names, forces, colours."""

import json
import os

import matplotlib
import matplotlib.image
from blade import Blade
from matplotlib.cm import ScalarMappable
from matplotlib.colors import Normalize
from matplotlib.patheffects import withStroke

BLUE = "#1f4e8c"
HALO = [withStroke(linewidth=3, foreground="white")]


class Pictures:
    """The plain pictures of one run."""

    def __init__(self, run):
        self.folder = os.path.join(run.path, "render", "plain")
        self.run = run
        with open(os.path.join(self.folder, "view.json")) as file:
            self.view = json.load(file)

    def image(self, frame):
        return matplotlib.image.imread(
            os.path.join(self.folder, f"{frame:04d}.png"))

    def draw(self, axes, frame, font_size=9):
        """The picture with the blade's forces as arrows."""
        image = self.image(frame)
        height, width = image.shape[:2]
        axes.imshow(image, interpolation="antialiased")
        axes.set_axis_off()
        state = self.view["frames"][str(frame)]

        def pixel(place):
            return width / 2 + place[0] * height, height / 2 - place[1] * height

        front = [pixel(arrow["tip"]) for arrow in state["arrows"]]
        if len(front) > 1:
            axes.plot(*zip(*front), "--", color=BLUE, linewidth=1)
        for arrow in state["arrows"]:
            drawn = axes.annotate(
                f"{arrow['force']:.3g}", xy=pixel(arrow["tip"]),
                xytext=pixel(arrow["tail"]), color=BLUE, ha="center",
                va="bottom", fontsize=font_size, fontweight="bold",
                annotation_clip=False, path_effects=HALO,
                arrowprops={"arrowstyle": "-|>", "color": BLUE,
                            "linewidth": 1.6, "shrinkA": 0, "shrinkB": 0})
            drawn.arrow_patch.set_path_effects(HALO)
        if state["apart"]:
            axes.text(0.5, 0.0, "(pieces drawn apart)", ha="center", va="top",
                      fontsize=font_size, transform=axes.transAxes)

    def draw_colours(self, figure, axes, **options):
        """The colour bar, with the field's name and unit."""
        view = self.view
        colours = ScalarMappable(Normalize(*view["range"]), view["map"])
        name = view["field"].replace("_", " ")
        unit = f" [{view['unit']}]" if view["unit"] else ""
        bar = figure.colorbar(colours, cax=axes, **options,
                              extend="both" if view["range"][0] else "max")
        bar.set_label(name + unit)


def legend(run):
    if not Blade(run.parameters).forces(0, 1):
        return "Grey: the body at rest."
    force = run.parameters.get("Force unit", "")
    unit = f" [{force}]" if force else ""
    return f"Arrows: forces of the blade{unit}. Dashed: the row they act on " \
           "next. Grey: the body at rest."


def stage(run, frame):
    """What happened in a frame, in a few words."""
    events = {line["event"]: line for line in run.events(frame)}
    line = list(events.values())[-1]
    if "divide" in events:
        return "cut open" if int(line["pieces"]) == 1 else \
            f"divided into {line['pieces']} pieces"
    if "rest" in events:
        return "at rest"
    cuts = {line["cut"] for line in run.statistics}
    of_cut = f"cut {line['cut'] + 1}: " if len(cuts) > 1 else ""
    return of_cut + stage_of_cut(events, line)


def stage_of_cut(events, line):
    row = f"row {line['row'] + 1}"
    if "arrest" in events:
        return f"arrested at {row}"
    if line["released_rows"] == 0:
        return "deformed" if "yield" not in events else "deformed, yields"
    return f"{line['released_rows']} row{'s'[:line['released_rows'] > 1]} " \
           f"split, force on {row}"


def numbers(run, frame):
    """The state's numbers, in one line."""
    loaded = [line for line in run.events(frame) if line["event"] == "deform"]
    if not loaded:
        return ""
    line, unit = loaded[-1], run.unit("stress")
    return (f"blade force {line['blade_force']:.4g} "
            f"{run.parameters.get('Force unit', '')},  cutting stress "
            f"{line['cutting_stress']:.4g} of {line['required_stress']:.4g} "
            f"{unit} required")
