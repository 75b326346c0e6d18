"""The files of a run: whether they are whole, and whether two runs made the same.
"""

import csv
import pathlib
import re

# What a run may say anew each time: the time it took, and the date in a frame.
SECONDS = "seconds"
COMMENT = re.compile(rb"<!--.*?-->", re.DOTALL)
# The last line of each kind of file.
ENDINGS = {".vtu": b"</VTKFile>", ".pvtu": b"</VTKFile>", ".pvd": b"</VTKFile>",
           ".msh": b"$EndElements"}
TEMPORARY = ".writing-"


def results(directory):
    """All files but those that a killed writer has left under another name."""
    return sorted(
        path
        for path in pathlib.Path(directory).iterdir()
        if not path.name.startswith(TEMPORARY)
    )


def rows(path):
    with open(path, newline="") as table:
        return list(csv.reader(table))


def broken_files(directory):
    """Files that are not there as a whole."""
    for path in results(directory):
        content = path.read_bytes()
        if path.suffix in ENDINGS and ENDINGS[path.suffix] not in content[-40:]:
            yield f"{path.name} does not end"
        if path.suffix == ".csv":
            lengths = {len(row) for row in rows(path)}
            if len(lengths) != 1 or not content.endswith(b"\n"):
                yield f"{path.name} is cut off"


def statistics(path):
    """The table without the time that the events took."""
    table = rows(path)
    column = table[0].index(SECONDS)
    return [row[:column] + row[column + 1 :] for row in table]


def content(path):
    if path.name == "statistics.csv":
        return statistics(path)
    if path.name == "parameters.prm":
        return re.sub(rb"set Directory .*", b"", path.read_bytes())
    return COMMENT.sub(b"", path.read_bytes())


def differences(directory, expected):
    """What differs between the files of two runs that have ended."""
    names = [path.name for path in pathlib.Path(directory).iterdir()]
    others = [path.name for path in pathlib.Path(expected).iterdir()]
    for name in sorted(set(names) ^ set(others)):
        yield f"{name} is in one directory only"
    for name in sorted(set(names) & set(others)):
        if content(pathlib.Path(directory) / name) != content(
            pathlib.Path(expected) / name
        ):
            yield f"{name} differs"
