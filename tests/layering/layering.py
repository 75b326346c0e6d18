# SPDX-License-Identifier: LGPL-2.1-or-later
"""The rooms of the house are in an order, and a file may include only files of
its own room and of rooms before it; a folder within a room may include the
room's own files as well. No file includes itself, by whatever way.

doc/development.md lists the rooms in this order, with the rooms that each
includes; --write brings the list up to date, but for what a new room holds.

usage: layering.py DIRECTORY [--write]   (with include/setsudan, source and doc)
"""

import pathlib
import re
import sys

ROOMS = [
    "parameters",
    "element",
    "kernel",
    "mesh",
    "body/gmsh",
    "body",
    "space",
    "material",
    "mechanics/stress",
    "mechanics/pieces",
    "mechanics",
    "solver/linear",
    "solver/multigrid",
    "solver/condensed",
    "solver",
    "blade",
    "cut/surface",
    "cut/seam",
    "cut/yield",
    "contact",
    "output/frames",
    "output/tables",
    "output/pieces",
    "output",
    "simulation/accuracy",
    "simulation/record",
    "simulation",
]

# What source/main.cc may include, which belongs to no room.
ROOMS_OF_MAIN = ["parameters", "kernel", "material", "simulation", "simulation/record"]

INCLUDE = re.compile(r'^\s*#\s*include\s*([<"])([^>"]+)[>"]', re.MULTILINE)

DOCUMENT = "doc/development.md"
TABLE = re.compile(r"(?<=<!-- rooms -->\n\n).*?(?=\n<!-- end -->)", re.DOTALL)
LINE = re.compile(r"^\| `([^`]+)` \| ([^|]*) \|", re.MULTILINE)


def source_files(root):
    """Name below root and text of all files: headers, then sources."""
    for folder in ("include/setsudan", "source"):
        for path in sorted((root / folder).rglob("*")):
            if path.is_file():
                yield str(path.relative_to(root)), path.read_text()


def room_of(name):
    """The room of a file, or None for main.cc and for strangers."""
    for folder in ("include/setsudan/", "source/"):
        if name.startswith(folder):
            room = str(pathlib.PurePosixPath(name[len(folder) :]).parent)
            return room if room in ROOMS else None
    return None


def allowed_rooms(name):
    if name == "source/main.cc":
        return ROOMS_OF_MAIN
    room = room_of(name)
    if not room:
        return []
    parent = str(pathlib.PurePosixPath(room).parent)
    return ROOMS[: ROOMS.index(room) + 1] + [parent]


def included_headers(name, text, problems):
    """The names of our own headers that a file includes."""
    headers = []
    for bracket, target in INCLUDE.findall(text):
        if bracket == '"':
            problems.append(f'{name} includes "{target}": write <setsudan/room/file.h>')
        elif target.startswith("setsudan/"):
            headers.append("include/" + target)
    return headers


def check_file(name, headers, known, problems):
    if not room_of(name) and name != "source/main.cc":
        problems.append(f"{name} is in no room; rooms are {', '.join(ROOMS)}")
    for header in headers:
        if header not in known:
            problems.append(f"{name} includes {header}, which does not exist")
        elif room_of(header) not in allowed_rooms(name):
            problems.append(f"{name} includes {header}, of a room it must not know")


def find_cycle(graph):
    """A list of files each of which includes the next, and the last the first."""
    finished = set()

    def visit(name, path):
        if name in path:
            return path[path.index(name) :]
        if name in finished:
            return None
        for header in graph.get(name, []):
            cycle = visit(header, path + [name])
            if cycle:
                return cycle
        finished.add(name)
        return None

    for name in graph:
        cycle = visit(name, [])
        if cycle:
            return cycle
    return None


def table_of_rooms(table, graph):
    """The table of DOCUMENT as it must be; what a room holds is taken from it."""
    holds = dict(LINE.findall(table))
    lines = ["| room | holds | includes |", "|---|---|---|"]
    for room in ROOMS:
        included = {room_of(header) for name in graph if room_of(name) == room
                    for header in graph[name]}
        names = [f"`{other}`" for other in ROOMS if other in included - {room}]
        text = holds.get(room, "")
        lines.append(f"| `{room}` | {text} | {', '.join(names) or '-'} |")
    return "\n".join(lines) + "\n"


def check_table(root, graph, problems):
    table = TABLE.search((root / DOCUMENT).read_text())
    if not table or table[0] != table_of_rooms(table[0], graph):
        problems.append(f"{DOCUMENT}: the rooms are not those of ROOMS and of the "
                        "files' includes; layering.py --write makes them so")
    holds = dict(LINE.findall(table[0])) if table else {}
    problems += [f"{DOCUMENT}: it does not say what room {room} holds"
                 for room in ROOMS if not holds.get(room, "").strip()]


def write_table(root):
    path = root / DOCUMENT
    graph = read_includes(root, [])
    path.write_text(
        TABLE.sub(lambda table: table_of_rooms(table[0], graph), path.read_text()))


def read_includes(root, problems):
    """The names of our own headers that each file includes."""
    return {
        name: included_headers(name, text, problems)
        for name, text in source_files(root)
    }


def find_problems(root):
    """Everything that is wrong with the files below a directory."""
    problems = []
    graph = read_includes(root, problems)
    for name, headers in graph.items():
        check_file(name, headers, graph, problems)
    cycle = find_cycle(graph)
    if cycle:
        problems.append("files include each other: " + " -> ".join(cycle))
    for room in ROOMS:
        if not any(room_of(name) == room for name in graph):
            problems.append(f"room {room} is empty")
    check_table(root, graph, problems)
    return problems


if __name__ == "__main__":
    if sys.argv[2:] == ["--write"]:
        write_table(pathlib.Path(sys.argv[1]))
    PROBLEMS = find_problems(pathlib.Path(sys.argv[1]))
    for problem in PROBLEMS:
        print(problem)
    print(f"{len(PROBLEMS)} problems")
    sys.exit(1 if PROBLEMS else 0)
