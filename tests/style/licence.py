# SPDX-License-Identifier: LGPL-2.1-or-later
"""Every source file begins with the licence line: behind `#!` in scripts.

usage: licence.py DIRECTORY [--write]   (with it, files that have none get one)
"""

import pathlib
import sys

LINE = "SPDX-License-Identifier: LGPL-2.1-or-later"
FOLDERS = ("include", "source", "tests", "benchmarks", "scripts", "cmake", ".ci")
COMMENTS = {".h": "//", ".cc": "//", ".py": "#", ".sh": "#", ".cmake": "#"}


def comment_of(path):
    """How a source file begins a comment; None of what is no source file."""
    if path.name == "CMakeLists.txt":
        return "#"
    if path.suffix or not path.is_file():
        return COMMENTS.get(path.suffix) if path.is_file() else None
    with open(path, "rb") as file:
        return "#" if file.read(2) == b"#!" else None


def source_files(root):
    paths = [root / "CMakeLists.txt"]
    for folder in FOLDERS:
        paths += sorted((root / folder).rglob("*"))
    return [(path, comment_of(path)) for path in paths if comment_of(path)]


def lines_of(path):
    """What stands in front of the licence line, and the rest."""
    lines = path.read_text().splitlines(keepends=True)
    n_before = 1 if lines[:1] and lines[0].startswith("#!") else 0
    return lines[:n_before], lines[n_before:]


def main(directory, *options):
    files = source_files(pathlib.Path(directory))
    n_missing = 0
    for path, comment in files:
        before, rest = lines_of(path)
        line = f"{comment} {LINE}\n"
        if rest[:1] == [line]:
            continue
        if options == ("--write",):
            path.write_text("".join([*before, line, *rest]))
        else:
            n_missing += 1
            print(f"{path}: no '{line.strip()}'")
    print(f"{len(files)} files, {n_missing} without a licence line")
    return 1 if n_missing or not files else 0


if __name__ == "__main__":
    sys.exit(main(*sys.argv[1:]))
