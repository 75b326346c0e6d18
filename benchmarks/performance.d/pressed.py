# SPDX-License-Identifier: LGPL-2.1-or-later
"""The table on contact under finite strain of doc/performance.md."""

import math
import pathlib
import re
import tempfile

import measure
import peers
from measure import number, program, remembered, table

BLOCK = peers.HERE / "finite.prm"
# A board below the block, on which it slides, and a top that is moved down, do the same as
# a plane that is pressed into it.
TOOLS = {
    "plane": {"Load/Tractions": "", "Support/Fixed faces": "",
              "Support/Displacements": "top : 0, 0, -1",
              "Board/Plane": "0, 0, 0; 0, 0, 1", "Board/Friction": 0},
    "wedge": {"Load/Tractions": "", "Cut/Surfaces": "y:5", "Material/Shear limit": 1e6,
              "Blade/Drive": "travel", "Blade/Travel": 1, "Blade/Shape": "wedge",
              "Blade/Wedge angle": 120, "Blade/Thickness": 9}}


def elements(n):
    return {"Body/Elements": f"{n},{n},{n}"}


def press(n, tool):
    """Seconds, and the force."""
    run = program(BLOCK, {**elements(n), **TOOLS[tool]})
    last = run.events[-1]
    return run.seconds, float(last["board_force" if tool == "plane" else "blade_force"])


def body(n, directory):
    """Nodes and elements of the block, by their numbers, as a deck has them."""
    values = {**elements(n), "Deformation/Strain": "small"}
    text = peers.decks(BLOCK, values, directory)[0].read_text()
    blocks = re.findall(r"^\*(NODE, NSET=BODY|ELEMENT)[^\n]*\n([^*]*)", text, re.M)
    numbers = {name[0]: block.replace(",\n", ", ").splitlines() for name, block in blocks}
    nodes = {int(line.split(",")[0]): [float(word) for word in line.split(",")[1:]]
             for line in numbers["N"]}
    return nodes, {int(line.split(",")[0]): [int(word) for word in line.split(",")[1:]]
                   for line in numbers["E"]}


def tool_of(tool, first):
    """Nodes and elements of a tool above the block, from a number on."""
    slope = 1 / math.tan(math.radians(60)) if tool == "wedge" else 0
    across = [1, 5, 9] if tool == "wedge" else [-2, 12]
    points = [(x, y, 10 + slope * abs(y - 5) + z)
              for z in (0, 3) for x in (-2, 12) for y in across]
    k = len(across)
    bricks = [[first + i for i in (a, a + k, a + k + 1, a + 1, a + 2 * k, a + 3 * k,
                                   a + 3 * k + 1, a + 2 * k + 1)] for a in range(k - 1)]
    return {first + i: point for i, point in enumerate(points)}, bricks


DECK = """\
*NSET, NSET=BOTTOM
{bottom}
*SURFACE, NAME=BLOCK
{top}
*SURFACE, NAME=TOOL
{faces}
*MATERIAL, NAME=BLOCK
*HYPERELASTIC, NEO HOOKE
{c10}, {d1}
*MATERIAL, NAME=TOOL
*ELASTIC
5000, 0
*SOLID SECTION, ELSET=BLOCK, MATERIAL=BLOCK
*SOLID SECTION, ELSET=TOOL, MATERIAL=TOOL
*SURFACE INTERACTION, NAME=CONTACT
*SURFACE BEHAVIOR, PRESSURE-OVERCLOSURE=LINEAR
250.
*CONTACT PAIR, INTERACTION=CONTACT, TYPE=SURFACE TO SURFACE
BLOCK, TOOL
*BOUNDARY
BOTTOM, 1, 3
TOOL, 1, 2
*STEP, NLGEOM, INC=200
*STATIC, SOLVER=SPOOLES
0.1, 1.
*BOUNDARY
TOOL, 3, 3, -1
*NODE PRINT, NSET=BOTTOM, TOTALS=ONLY
RF
*END STEP
"""


def lines(rows):
    return "\n".join(", ".join(str(word) for word in row) + "," for row in rows)


def write_deck(n, tool, path, directory):
    """A tool that is pressed into the block, on its surface and not on its nodes: these
    have negative forces at the corners of quadratic faces."""
    nodes, bricks = body(n, directory)
    tool_nodes, tool_bricks = tool_of(tool, 1 + max(nodes))
    first = 1 + max(bricks)
    # In the order of corners, those of the upper face come last.
    top = [number for number, corners in bricks.items()
           if all(nodes[node][2] > 10 - 1e-9 for node in corners[4:8])]
    text = ["*NODE", lines([number, *at] for number, at in nodes.items()),
            "*NODE, NSET=TOOL", lines([number, *at] for number, at in tool_nodes.items()),
            "*ELEMENT, TYPE=C3D20, ELSET=BLOCK",
            lines(row for number, of in bricks.items()
                  for row in ([number, *of[:10]], of[10:])),
            "*ELEMENT, TYPE=C3D8, ELSET=TOOL",
            lines([first + i, *of] for i, of in enumerate(tool_bricks)),
            DECK.format(bottom=lines([number] for number, at in nodes.items() if at[2] == 0),
                        top=lines([number, "S2"] for number in top),
                        faces=lines([first + i, "S1"] for i in range(len(tool_bricks))),
                        c10=5 / 2.4 / 2, d1=2 / (5 / 1.8))]
    path.write_text("\n".join(text))


def press_by_calculix(n, tool):
    """The same, of CalculiX."""
    with tempfile.TemporaryDirectory() as name:
        job = pathlib.Path(name) / "pressed.inp"
        write_deck(n, tool, job, pathlib.Path(name) / "block")
        seconds, _, said = measure.timed(["ccx", job.stem], name,
                                         OMP_NUM_THREADS=str(peers.CORES))
        if "*ERROR" in said:
            raise RuntimeError(said[-2000:])
        totals = re.findall(r"total force[^\n]*\n\s*\n([^\n]*)",
                            job.with_suffix(".dat").read_text())
    return seconds, abs(float(totals[-1].split()[2]))


def contact(n=10):
    """A block of 10^3 elements into which a rigid tool is pressed by a tenth of it,
    without friction: isochoric neo-Hooke, 14 883 unknowns, on one process. CalculiX has the
    same mesh and law, contact from surface to surface with a penalty of 50 times Young's
    modulus over an element's side, steps as it chooses and two threads. Under the plane
    GetFEM finds 56.0949 gf with multipliers; at the edge of a sharp wedge the pressure is
    singular, and on this mesh the forces of methods differ by 7 %."""
    rows = []
    for tool in ("plane", "wedge"):
        own = remembered(f"pressed {tool} {n}, Setsudan", lambda tool=tool: press(n, tool))
        other = remembered(f"pressed {tool} {n}, CalculiX",
                           lambda tool=tool: press_by_calculix(n, tool))
        rows += [[tool, "Setsudan", 1, f"{own[1]:.4f}"],
                 ["", "CalculiX", number(other[0] / own[0]), f"{other[1]:.4f}"]]
    return table(["tool", "", "time", "force [gf]"], rows)
