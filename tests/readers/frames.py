# SPDX-License-Identifier: LGPL-2.1-or-later
"""Frames, opened by VTK: cells, points, fields, volumes, and what is known of the state.

usage: frames.py PROGRAM [MPIEXEC [PROCESSES]]
"""

import math

from runs import (BODIES, CASES, CROSSED, CUBE, FAR, LINEAR, QUADRATIC, REFINED, TRAVEL,
                  Run, cube, main, square)
from tables import read

VECTOR, TENSOR = "XYZ", ("XX", "YY", "ZZ", "XY", "YZ", "XZ")
POINT_DATA = {
    "displacement": (3, False, VECTOR),
    "stress": (6, False, TENSOR),
    "strain": (6, False, TENSOR),
    "principal_stress": (3, False, None),
    "maximum_shear": (1, False, None),
    "von_Mises": (1, False, None),
    "node": (1, True, None),
    "front": (1, True, None),
}
CELL_DATA = {name: (1, True, None) for name in ("element", "side", "piece", "material")}
FACTS = {"TimeValue": 1, "cut": 1, "row": 1, "depth": 1, "load_factor": 1,
         "blade_force": 1}
BLADE = {"blade_points": 3, "blade_forces": 3, "blade_direction": 3, "cut_normal": 3}
# Points and fields have the digits of Float32.
DIGITS = 2e-6
CORNERS = {2: 4, 3: 8}


def near(a, b, scale, digits=DIGITS):
    return all(abs(x - y) <= digits * scale for x, y in zip(a, b))


def text_of(grid, name, bearer):
    """A fact that is a text: an array of it, or the name of another's component."""
    if name in grid.field_data and grid.field_data[name].text:
        return grid.field_data[name].values[0]
    return grid.field_data[bearer].names[0] if bearer in grid.field_data else None


def geometry_problems(run, grid):
    """Cells, their volumes, and the box around them."""
    if run.cells and len(grid.kinds) != run.cells:
        yield f"{len(grid.kinds)} cells instead of {run.cells}"
    if not grid.kinds:
        return
    length = max(max(map(abs, corner)) for corner in run.box)
    digits = 1e-12 if grid.double else 1e-7
    yield from bounds_problems(grid.points, run.box, length * digits + 1e-12)
    sizes = grid.sizes()
    if abs(sum(sizes) / run.volume - 1) > run.tolerance:
        yield f"the volume is {sum(sizes)} instead of {run.volume}"
    if min(sizes) <= 0:
        yield f"a cell has the volume {min(sizes)}"


def stress_problems(grid):
    """Stress, its principal values, and what is made of them agree."""
    fields = [grid.point_data[name].values for name in (
        "stress", "principal_stress", "maximum_shear", "von_Mises")]
    scale = max(abs(x) for stress in fields[0] for x in stress) or 1
    for stress, principal, (shear,), (mises,) in zip(*fields):
        xx, yy, zz, xy, yz, xz = stress
        squares = sum((p - q) ** 2 for p, q in zip(principal, principal[1:] + principal[:1]))
        if not (near([xx + yy + zz], [sum(principal)], 9 * scale)
                and near([shear], [(max(principal) - min(principal)) / 2], 9 * scale)
                and near([mises], [math.sqrt(squares / 2)], 9 * scale)
                and near([xx * xx + yy * yy + zz * zz + 2 * (xy**2 + yz**2 + xz**2)],
                         [sum(p * p for p in principal)], 9 * scale**2)):
            yield f"principal stresses {principal} of {stress}, {shear}, {mises}"
            return


def node_problems(run, grid, table):
    """Points that are nodes of the body are at one place each, and move as the table
    of nodes says."""
    nodes, front = (grid.point_data[name].numbers() for name in ("node", "front"))
    if not set(front) <= {0, 1} or min(nodes) < -1:
        yield f"front is {set(front)}, nodes begin at {min(nodes)}"
    numbers = {int(row["number"]) for row in table}
    missing = (numbers ^ set(nodes)) - {-1}
    if run.name.startswith("quadratic"):
        # Nodes in the middle of faces and elements have numbers in the table only.
        missing = set(nodes) - numbers - {-1}
    if numbers and missing and not run.name.startswith("refined"):
        yield f"nodes {sorted(missing)[:9]} are in the frame or in the table only"
    known = {}
    axes = "xyz"[: run.dimension]
    for row in table:
        place = [float(row[axis]) for axis in axes]
        moved = [float(row[f"u{axis}"]) for axis in axes]
        known.setdefault(int(row["number"]), []).append((place, moved))
    size = max(max(map(abs, corner)) for corner in run.box)
    displacements = grid.point_data["displacement"].values
    largest = max(abs(x) for u in displacements for x in u)
    for node, point, moved in zip(nodes, grid.points, displacements):
        if node in known and not any(
                near(place, point, size) and near(u, moved, largest)
                for place, u in known[node]):
            yield f"node {node} at {point} moves by {moved}, not {known[node]}"
            return


def fact_problems(run, grid, time, lines):
    """What the frame says of its event is in the table, too."""
    facts = grid.field_data
    for name, n in FACTS.items():
        if name not in facts:
            yield f"there is no {name} of the state"
            return
        yield from facts[name].problems(n, length=1)
    event = text_of(grid, "event", "event")
    line = next((line for line in lines if line["event"] == event), None)
    if line is None:
        yield f"the event is {event}, in the table {[line['event'] for line in lines]}"
        return
    for name in ("cut", "row", "depth", "load_factor", "blade_force"):
        value = facts[name].numbers()[0]
        if not near([value], [float(line[name])], max(1, abs(value)), 1e-9):
            yield f"{name} is {value} in the frame, {line[name]} in the table"
    if facts["TimeValue"].numbers()[0] != time:
        yield f"TimeValue is {facts['TimeValue'].numbers()[0]} instead of {time}"
    if isinstance(run.scene, dict) and (
            text_of(grid, "length_unit", "depth") != run.scene["Length unit"]
            or text_of(grid, "force_unit", "blade_force") != run.scene["Force unit"]):
        yield "the units are not those of the scene"
    front = set(grid.point_data["front"].numbers())
    if event in ("rest", "divide"):
        if front != {0}:
            yield f"a front at the event {event}"
    elif run.pieces > 1:
        yield from blade_problems(grid, facts)


def blade_problems(grid, facts):
    """The blade's forces act on the front, along its direction, and are the table's."""
    for name, n in BLADE.items():
        if name not in facts:
            yield f"there is no {name}"
            return
        yield from facts[name].problems(n, names=VECTOR)
    direction = facts["blade_direction"].values[0]
    normal = facts["cut_normal"].values[0]
    along = sum(a * b for force in facts["blade_forces"].values
                for a, b in zip(force, direction))
    if not near([along], facts["blade_force"].values[0], max(1, abs(along)), 1e-9):
        yield f"the blade's forces are {along} along its direction"
    for vector in (direction, normal):
        if not near([sum(x * x for x in vector)], [1], 1, 1e-9):
            yield f"{vector} is no direction"
    if len(facts["blade_points"].values) != len(facts["blade_forces"].values):
        yield "not each of the blade's forces has a point"
    if sum(grid.point_data["front"].numbers()) == 0:
        yield "no point is at the front"


def frame_problems(run, grid, time, lines, table):
    yield from expected_arrays(grid.point_data, POINT_DATA, len(grid.points), "points")
    yield from expected_arrays(grid.cell_data, CELL_DATA, len(grid.kinds), "cells")
    if set(POINT_DATA) <= set(grid.point_data) and grid.kinds:
        yield from stress_problems(grid)
        yield from node_problems(run, grid, table)
        yield from fact_problems(run, grid, time, lines)
    if "Accuracy/Estimate=true" in run.settings and lines[0]["event"] != "rest":
        expected = {"energy_error": (1, False, None)}
        yield from expected_arrays(grid.cell_data, expected, len(grid.kinds), "cells")


def surface_problems(run, grid, lines):
    """A surface of quadrilaterals, or lines, whose edge is where the blade is."""
    if set(grid.kinds) != {9 if run.dimension == 3 else 3}:
        yield f"cells of the kinds {set(grid.kinds)}"
    axis = run.dimension - 1
    edge = min(point[axis] for point in grid.points)
    expected = run.box[1][axis] - float(lines[-1]["travel"])
    if abs(edge - expected) > 1e-6 * run.box[1][axis]:
        yield f"its edge is at {edge} instead of {expected}"


def check(run, output):
    """All frames of a run, and its pieces in the last one."""
    lines = read(output / "statistics.csv")
    shown = frames_of(output / "cut.pvd")
    frames = [(time, path) for time, path in shown if path.name.startswith("frame")]
    for time, path in shown:
        if path.name.startswith("blade"):
            problems = surface_problems(run, Grid(path), [
                line for line in lines if path.stem == f"blade_{int(line['frame']):04}"])
            yield from (f"{path.name}: {problem}" for problem in problems)
    # There is no blade in the first and in the last one.
    if "travel" in lines[0] and len(shown) != 2 * len(frames) - 2:
        yield f"{len(shown) - len(frames)} blades with {len(frames)} frames"
    if len(frames) != len({line["frame"] for line in lines}):
        yield f"{len(frames)} frames in cut.pvd"
    for number, (time, path) in enumerate(frames):
        try:
            grid = Grid(path)
        except ReadError as error:
            yield str(error)
            return
        table = output / f"nodes_{number:04}.csv"
        of_frame = [line for line in lines if int(line["frame"]) == number]
        problems = [*geometry_problems(run, grid), *frame_problems(
            run, grid, time, of_frame, read(table) if table.exists() else [])]
        yield from (f"{path.name}: {problem}" for problem in problems)
    found = {int(piece) for piece in grid.cell_data["piece"].numbers()}
    if "piece" not in grid.cell_data or found != set(range(run.pieces)):
        yield f"pieces {found} in the last frame"


BEAM = ((0, 0, 0), (4, 1, 1))
RUNS = [
    cube("serendipity", cells=8),
    cube("linear", LINEAR, cells=8),
    cube("quadratic", QUADRATIC, cells=8),
    cube("refined", REFINED),
    cube("refined, linear", {**REFINED, **LINEAR}),
    cube("refined everywhere", {"Body/Refinement": "1"}, cells=64),
    cube("crossing cuts", CROSSED, pieces=4, cells=4),
    cube("an estimate", settings=["Accuracy/Estimate=true"], cells=8),
    cube("far away", FAR, shift=(500000, 5000000, 0), cells=8),
    cube("a blade that travels", TRAVEL, cells=8, is_serial=True),
    square("square", cells=4),
    square("a blade that travels through a square", TRAVEL, cells=4, is_serial=True),
    square("linear square", LINEAR, cells=4),
    square("quadratic square", QUADRATIC, cells=4),
    square("refined square", {"Cut/Refinement near cut": "1"}),
    Run("two materials", CASES / "opencascade" / "scene_cut.prm", 8, ((0, 0, 0), (2, 2, 2)),
        cells=16),
    Run("no cut", {key: value for key, value in CUBE.items() if key != "Cut/Surfaces"
                   and not key.startswith("Blade")}, 8, ((0, 0, 0), (2, 2, 2)), 1, 8),
    Run("a cylinder", BODIES / "cylinder.prm", 200 * math.pi, ((-5, -5, 0), (5, 5, 8)),
        tolerance=0.02),
]

if __name__ == "__main__":
    try:
        from vtk_files import (Grid, ReadError, bounds_problems, expected_arrays,
                               frames_of)
    except ImportError:
        pass
    main(check, RUNS)
