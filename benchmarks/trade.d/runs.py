# SPDX-License-Identifier: LGPL-2.1-or-later
"""The runs of the trade: scenes, what is varied, and how one is timed."""

import dataclasses
import pathlib
import tempfile

import measure

ROOT = pathlib.Path(__file__).resolve().parents[2]
STORE = ROOT / "build" / "trade.json"
HERE = pathlib.Path(__file__).resolve().parent
# A run that takes longer than this many seconds is given up.
LIMIT = 240


@dataclasses.dataclass
class Scene:
    """A scene that is run until half of its cut is made, where a quantity of the
    statistics is compared with that of a much finer mesh."""

    name: str
    quantity: str
    column: str
    depth: float
    elements: tuple
    # How often the elements are halved for the reference, of serendipity and of
    # quadratic elements.
    references: tuple
    # The same in plane strain, where it is not that already, and by what its
    # quantity is multiplied.
    plane: dict = dataclasses.field(default_factory=dict)
    width: float = 1.0

    @property
    def in_space(self):
        return len(self.elements) == 3

    @property
    def unit(self):
        """What times are relative to."""
        return Choice(levels=1, plane=not self.in_space)


SCENES = [
    Scene("peel", "strain energy", "strain_energy", 10, (10, 2, 2),
          ((0, 1, 2), (0, 1, 2)), {
        "Dimension": "2", "Body/Size": "20, 2", "Load/Tractions": "top : 0, 0.02",
        "Blade/Direction": "1, 0", "Cut/Surfaces": "plane: 0, 1; 0, 1"}, 4),
    Scene("blade", "cutting stress (mean shear)", "cutting_stress", 5, (2, 2, 2),
          ((1, 2, 3), (1, 2, 3)), {
        "Dimension": "2", "Body/Size": "10, 10", "Blade/Direction": "0, -1",
        "Blade/Edge loads": "0 : 0.2", "Cut/Surfaces": "plane: 5, 0; 1, 0"}),
    Scene("arms", "strain energy", "strain_energy", 12, (5, 2),
          ((2, 3, 4), (2, 3, 4))),
    Scene("slab", "cutting stress (mean shear)", "cutting_stress", 3, (6, 2, 2),
          ((1, 2, 3), (0, 1, 2)), {
        "Dimension": "2", "Body/Size": "12, 6", "Load/Body force": "0, -0.001",
        "Blade/Direction": "0, -1", "Cut/Surfaces": "plane: 4, 0; 1, 0"}),
]


@dataclasses.dataclass(frozen=True)
class Choice:
    """What is varied. The elements of a scene are halved so many times everywhere, and
    so many times more near the cut."""

    element: str = "serendipity"
    levels: int = 0
    near: int = 0
    release: str = "element row"
    plane: bool = False
    solver: str = "direct"
    target: float = 0
    more: tuple = ()

    @property
    def label(self):
        words = ["2D" if self.plane else "3D", self.element, f"h/{2 ** self.levels}"]
        if self.near:
            words.append(f"h/{2 ** (self.levels + self.near)} near the cut")
        words.append(self.release)
        if self.solver != "direct":
            words.append(f"iterative to {self.solver}")
        if self.target:
            words.append(f"Accuracy/Target = {self.target}")
        return ", ".join(words + [value for name, value in self.more
                                  if name == "Yield/Criterion"])

    def settings(self, scene):
        values = {"Output/Frames": "none", "Output/Checkpoint": "none",
                  "Division/Solve": "every row anew",
                  "Body/Element type": self.element, "Division/Release": self.release,
                  "Cut/Refinement near cut": str(self.near), **dict(self.more)}
        if self.target:
            values["Accuracy/Target"] = str(self.target)
            values["Accuracy/States"] = "middle row"
            values["Accuracy/Quantity"] = ("strain energy" if "energy" in scene.quantity
                                           else "cutting stress")
        if self.plane:
            values.update(scene.plane)
        if self.solver == "direct":
            values["Solver/Method"] = "direct"
        else:
            values.update({"Solver/Method": "iterative", "Solver/Tolerance": self.solver})
        counts = scene.elements
        if self.plane and scene.in_space:
            # A plane of the last coordinate and that across the cut or along it.
            counts = counts[1:] if scene.name == "blade" else counts[::2]
        values["Body/Elements"] = ", ".join(str(n * 2 ** self.levels) for n in counts)
        return values


@dataclasses.dataclass
class Result:
    """What a run gave: the quantity, the seconds to it; or why it did not."""

    value: float = None
    seconds: float = None
    refusal: str = ""


def measured(scene, choice, limit=LIMIT):
    """What run() gives, or gave when this was measured before."""
    return Result(**measure.remembered(
        f"{scene.name}: {choice.label}",
        lambda: dataclasses.asdict(run(scene, choice, limit)), STORE))


def scene_text(name, settings):
    """A scene's file with other values, which are not merely added: those of three
    dimensions are none of two."""
    lines, subsection, missing = [], [], dict(settings)
    for line in (HERE / f"{name}.prm").read_text().splitlines():
        words = line.split("=", 1)[0].split()
        if words[:1] == ["subsection"]:
            subsection.append(" ".join(words[1:]))
        elif words[:1] == ["end"]:
            subsection.pop()
        elif words[:1] == ["set"]:
            name = "/".join(subsection + [" ".join(words[1:])])
            if name in missing:
                line = f"set {' '.join(words[1:])} = {missing.pop(name)}"
        lines.append(line)
    for name, value in missing.items():
        subsections = name.split("/")[:-1]
        lines += [f"subsection {one}" for one in subsections]
        lines += [f"set {name.split('/')[-1]} = {value}"] + ["end"] * len(subsections)
    return "\n".join(lines) + "\n"


def run(scene, choice, limit=LIMIT):
    """Run until the scene's depth is reached. The program is ended then."""
    with tempfile.TemporaryDirectory() as directory:
        settings = choice.settings(scene)
        path = pathlib.Path(directory) / "scene.prm"
        path.write_text(scene_text(scene.name, settings))
        command = [str(ROOT / "build" / "setsudan"), str(path), "--output", directory]
        event, refusal = measure.watched(
            command, directory, lambda events: event_at(events, scene.depth), limit)
    if refusal:
        return Result(refusal=refusal)
    width = scene.width if choice.plane and scene.in_space else 1
    return Result(float(event[scene.column]) * width, float(event["seconds"]))


def event_at(events, depth):
    """The deformation of the first row at a depth, once it is written."""
    for event in events:
        if (event["event"] == "deform" and event["row_pieces"] is not None
                and float(event["depth"]) > depth * (1 - 1e-9)):
            return event
    return None


def choices(scene):
    """All that is tried of a scene, the cheap ones first."""
    for plane in (True, False) if scene.in_space else (True,):
        finest = {"linear": 4 if plane else 3, "serendipity": 3 if plane else 2,
                  "quadratic": 3 if plane else 2}
        for element, last in finest.items():
            for levels in range(last + 1):
                yield Choice(element, levels, plane=plane)
        for levels, near in ((0, 1), (0, 2), (0, 3), (1, 1), (1, 2)):
            if plane or levels + near < 3 or scene.name != "peel":
                yield Choice("serendipity", levels, near, plane=plane)
        for levels in range(3 if plane else 2):
            yield Choice("serendipity", levels, release="node row", plane=plane)
        for solver in ("direct", "1e-6"):
            yield Choice("serendipity", 0, target=0.05, plane=plane, solver=solver)
    for solver in ("1e-3", "1e-4", "1e-6", "1e-8", "1e-10"):
        yield dataclasses.replace(scene.unit, solver=solver)


def with_criterion(name):
    """The choice with which the criteria are compared."""
    more = [("Yield/Criterion", name)]
    if name != "mean shear":
        more.append(("Yield/Process zone", "0"))
    return Choice(levels=1, more=tuple(more))


CRITERIA = ("maximum shear", "von Mises", "traction on the cut", "mean shear",
            "energy release")
