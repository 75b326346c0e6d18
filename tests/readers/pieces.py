# SPDX-License-Identifier: LGPL-2.1-or-later
"""Pieces as bodies, opened by VTK, meshio, gmsh and the program itself: together they
are the body, and each has its groups.

usage: pieces.py PROGRAM
"""

import math
import subprocess
import sys

from runs import BODIES, CASES, CROSSED, FAR, LINEAR, QUADRATIC, Run, cube, main, square
from run_files import appended_arrays
from tables import read

# Types of cells: VTK's quadratic quadrilateral and hexahedron, gmsh's.
OF_VTK, OF_GMSH = {2: 23, 3: 25}, {2: 16, 3: 17}
OF_MESHIO = {2: "quad8", 3: "hexahedron20"}
POINT_DATA = {
    "node": (1, True, None),
    "node_in_body": (1, True, None),
    "displacement": (3, False, "XYZ"),
}
CELL_DATA = {name: (1, True, None) for name in (
    "element", "element_in_body", "material")}


def vtu_problems(run, path):
    """A piece in VTK's format; its volume, points and elements are collected."""
    grid = Grid(path)
    if set(grid.kinds) != {OF_VTK[run.dimension]}:
        yield f"cells of the types {set(grid.kinds)}"
        return
    yield from expected_arrays(grid.point_data, POINT_DATA, len(grid.points), "points")
    yield from expected_arrays(grid.cell_data, CELL_DATA, len(grid.kinds), "cells")
    sizes = grid.sizes()
    if min(sizes) <= 0:
        yield f"a cell has the volume {min(sizes)}"
    found = {"volume": sum(sizes), "points": grid.points, "cells": len(grid.kinds)}
    if "element_in_body" in grid.cell_data:
        found["elements"] = grid.cell_data["element_in_body"].numbers()
    for name in ("node", "element"):
        data = grid.point_data if name == "node" else grid.cell_data
        if name in data and sorted(data[name].numbers()) != list(
                range(len(data[name].values))):
            yield f"the numbers '{name}' are not those from 0"
    yield from middle_problems(grid)
    COLLECTED.append(found)


def middle_problems(grid):
    """Middle nodes are near the middle of VTK's lines."""
    corners = {20: 8, 8: 4}
    lines = {20: [(0, 1), (1, 2), (2, 3), (3, 0), (4, 5), (5, 6), (6, 7), (7, 4), (0, 4),
                  (1, 5), (2, 6), (3, 7)], 8: [(0, 1), (1, 2), (2, 3), (3, 0)]}
    for i in range(len(grid.kinds)):
        cell = grid.cell(i)
        for n, (a, b) in enumerate(lines[len(cell)]):
            ends = [grid.points[cell[j]] for j in (a, b)]
            middle = [(u + v) / 2 for u, v in zip(*ends)]
            place = grid.points[cell[corners[len(cell)] + n]]
            if math.dist(place, middle) > 0.2 * math.dist(*ends):
                yield f"point {cell[corners[len(cell)] + n]} is not on its line"
                return


def is_mixed_up_by_meshio(path):
    """Whether meshio takes one array of a file for another: it gives arrays new
    offsets one after another, and looks for those to come by their old offsets, one
    of which may be a new one by chance."""
    old, new, length = [], [], 0
    for _, offset, content in sorted(appended_arrays(path.read_bytes()),
                                     key=lambda array: array[1]):
        old.append(offset)
        new.append(length)
        # In base64, behind their number.
        length += (len(content) + 4 + 2) // 3 * 4
    return any(offset in new[:place] for place, offset in enumerate(old))


def meshio_problems(run, path):
    """meshio reads the same cells and points from both files."""
    if is_mixed_up_by_meshio(path.with_suffix(".vtu")):
        print(f"{path.stem}: meshio mixes up its arrays")
        return
    import meshio
    sizes = set()
    for ending in (".vtu", ".msh"):
        mesh = meshio.read(path.with_suffix(ending))
        cells = [block for block in mesh.cells if block.type == OF_MESHIO[run.dimension]]
        sizes.add((len(mesh.points), sum(len(block.data) for block in cells)))
    if len(sizes) != 1:
        yield f"meshio finds {sizes} points and cells in the two files"
    if "cut" not in mesh.field_data and run.pieces > 1:
        yield f"meshio finds the groups {sorted(mesh.field_data)}"


def gmsh_problems(run, path, piece):
    """gmsh reads the piece, with its groups; all elements are valid."""
    import gmsh
    gmsh.initialize()
    gmsh.option.setNumber("General.Terminal", 0)
    gmsh.logger.start()
    gmsh.open(str(path))
    said = [line for line in gmsh.logger.get() if line.startswith(("Error", "Warning"))]
    yield from (f"gmsh: {line}" for line in said)
    kinds, tags, nodes = gmsh.model.mesh.getElements(run.dimension)
    if list(kinds) != [OF_GMSH[run.dimension]] or len(tags[0]) != piece["cells"]:
        yield f"gmsh finds elements of the kinds {kinds}"
    elif len(set(nodes[0])) != len(piece["points"]):
        yield f"gmsh finds {len(set(nodes[0]))} nodes"
    else:
        points, weights = gmsh.model.mesh.getIntegrationPoints(kinds[0], "Gauss4")
        determinants = gmsh.model.mesh.getJacobians(kinds[0], points)[1]
        volume = sum(determinants[i] * weights[i % len(weights)]
                     for i in range(len(determinants)))
        if abs(volume / piece["volume"] - 1) > max(1e-6, run.tolerance):
            yield f"gmsh finds the volume {volume} instead of {piece['volume']}"
    names = {gmsh.model.getPhysicalName(*group) for group in
             gmsh.model.getPhysicalGroups()}
    if run.pieces > 1 and "cut" not in names:
        yield f"gmsh finds the groups {names}"
    gmsh.logger.stop()
    gmsh.finalize()


def program_problems(run, path):
    """The program takes the piece as a body."""
    scene = path.with_suffix(".prm")
    scene.write_text(f"set Dimension = {run.dimension}\nsubsection Body\n"
                     f"  set Shape = file\n  set File = {path.name}\nend\n"
                     "subsection Support\n  set Fixed faces = cut\nend\n")
    result = subprocess.run([sys.argv[1], str(scene), "--validate"], check=False,
                            capture_output=True, text=True)
    if result.returncode != 0:
        yield f"the program: {result.stderr.strip()}"


def check(run, output):
    """All pieces of a run."""
    COLLECTED.clear()
    paths = sorted(output.glob("piece_*.msh"))
    if len(paths) != run.pieces or int(read(output / "statistics.csv")[-1]["pieces"]
                                       ) != run.pieces:
        yield f"{len(paths)} pieces"
    for path in paths:
        try:
            problems = list(vtu_problems(run, path.with_suffix(".vtu")))
        except ReadError as error:
            yield str(error)
            continue
        if COLLECTED:
            problems += gmsh_problems(run, path, COLLECTED[-1])
        problems += [*meshio_problems(run, path), *program_problems(run, path)]
        yield from (f"{path.stem}: {problem}" for problem in problems)
    if len(COLLECTED) != run.pieces:
        return
    volume = sum(piece["volume"] for piece in COLLECTED)
    if abs(volume / run.volume - 1) > run.tolerance:
        yield f"the pieces' volumes are {volume} together"
    points = [point for piece in COLLECTED for point in piece["points"]]
    length = max(max(map(abs, corner)) for corner in run.box)
    yield from bounds_problems(points, run.box, 1e-12 * length)
    elements = [element for piece in COLLECTED for element in piece.get("elements", [])]
    if len(elements) != len(set(elements)):
        yield "an element is in two pieces"


COLLECTED = []
RUNS = [
    cube("serendipity"),
    cube("linear", LINEAR),
    cube("quadratic", QUADRATIC),
    cube("refined", {"Cut/Refinement near cut": "1"}),
    cube("crossing cuts", CROSSED, pieces=4),
    cube("far away", FAR, shift=(500000, 5000000, 0)),
    square("square"),
    square("linear square", LINEAR),
    square("quadratic square", QUADRATIC),
    Run("two materials", CASES / "opencascade" / "scene_cut.prm", 8,
        ((0, 0, 0), (2, 2, 2))),
    Run("a beam whose end is dropped", CASES / "last_slice_falls" / "scene_drop.prm", 4,
        ((0, 0, 0), (4, 1, 1))),
    Run("a cylinder", BODIES / "cylinder.prm", 200 * math.pi, ((-5, -5, 0), (5, 5, 8)),
        tolerance=0.03),
]

if __name__ == "__main__":
    try:
        from vtk_files import Grid, ReadError, bounds_problems, expected_arrays
    except ImportError:
        pass
    main(check, RUNS, ("vtkmodules", "meshio", "gmsh"))
