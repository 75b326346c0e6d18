# SPDX-License-Identifier: LGPL-2.1-or-later
"""The files of a run: whether they are whole, and whether two runs made the same, up
to the tolerance of their solvers.
"""

import csv
import json
import pathlib
import re
import struct
import zlib

TOLERANCE = 1e-10
# What a run may say anew each time: the time it took, what its solver left over, and
# the date in a frame.
NOT_COMPARED = ("seconds", "force_residual", "moment_residual")
COMPONENT = re.compile(r"_[xyz]$|(?<=^u)[xyz]$|(?<=^s)[xyz]{2}$")
# An array of numbers in a frame: its type, and where it begins.
ARRAY = re.compile(rb'<DataArray type="(\w+)"[^>]*format="appended" offset="(\d+)"/>')
FORMATS = {b"Float32": ("f", 4), b"Float64": ("d", 8), b"Int32": ("i", 4),
           b"Int64": ("q", 8), b"UInt8": ("B", 1)}
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


def is_close(values, others):
    """Whether lists of numbers agree, relative to the largest of them."""
    scale = max([abs(value) for value in others], default=0)
    return len(values) == len(others) and all(
        abs(a - b) <= TOLERANCE * scale for a, b in zip(values, others))


def numbers_or_none(texts):
    try:
        return [float(text) for text in texts]
    except ValueError:
        return None


def same_tables(path, other):
    """Texts are the same, and numbers close; of the components of a vector,
    relative to the largest of all."""
    table, expected = rows(path), rows(other)
    if [len(row) for row in table] != [len(row) for row in expected] or \
            table[0] != expected[0]:
        return False
    groups = {}
    for column, name in enumerate(table[0]):
        if name not in NOT_COMPARED:
            groups.setdefault(COMPONENT.sub("", name), []).append(column)
    for columns in groups.values():
        texts, others = ([row[c] for row in lines[1:] for c in columns]
                         for lines in (table, expected))
        values, theirs = numbers_or_none(texts), numbers_or_none(others)
        if values is None or theirs is None:
            if texts != others:
                return False
        elif not is_close(values, theirs):
            return False
    return True


def appended_arrays(data):
    """The arrays of a VTU file, each with its type, its offset and its bytes."""
    head, _, appended = data.partition(b'<AppendedData encoding="raw">\n_')
    for match in ARRAY.finditer(head):
        kind, begin = match[1], int(match[2])
        n_blocks, = struct.unpack_from("I", appended, begin)
        sizes = struct.unpack_from(f"{n_blocks}I", appended, begin + 12)
        at = begin + 12 + 4 * n_blocks
        content = b""
        for size in sizes:
            content += zlib.decompress(appended[at:at + size])
            at += size
        yield kind, begin, content


def arrays_of(data):
    """The numbers of a VTU file, and what else is in it."""
    head, _, _ = data.partition(b'<AppendedData encoding="raw">\n_')
    arrays = []
    for kind, _, content in appended_arrays(data):
        code, width = FORMATS[kind]
        arrays.append(struct.unpack(f"{len(content) // width}{code}", content))
    return re.sub(rb' offset="\d+"', b"", COMMENT.sub(b"", head)), arrays


def same_frames(path, other):
    (head, arrays), (expected, others) = (
        arrays_of(file.read_bytes()) for file in (path, other))
    return head == expected and len(arrays) == len(others) and all(
        is_close(*pair) for pair in zip(arrays, others))


def same_summaries(path, other):
    summary, expected = (json.loads(file.read_text()) for file in (path, other))
    return list(summary) == list(expected) and all(
        summary[name] == expected[name] or
        None not in (summary[name], expected[name]) and
        is_close([summary[name]], [expected[name]])
        for name in summary if name not in NOT_COMPARED)


def content(path):
    if path.name == "parameters.prm":
        return re.sub(rb"set Directory .*", b"", path.read_bytes())
    return COMMENT.sub(b"", path.read_bytes())


def are_same(path, other):
    if path.suffix == ".csv":
        return same_tables(path, other)
    if path.suffix == ".json":
        return same_summaries(path, other)
    if path.suffix == ".vtu":
        return same_frames(path, other)
    return content(path) == content(other)


def differences(directory, expected):
    """What differs between the files of two runs that have ended."""
    names = [path.name for path in pathlib.Path(directory).iterdir()]
    others = [path.name for path in pathlib.Path(expected).iterdir()]
    for name in sorted(set(names) ^ set(others)):
        yield f"{name} is in one directory only"
    for name in sorted(set(names) & set(others)):
        if not are_same(pathlib.Path(directory) / name,
                        pathlib.Path(expected) / name):
            yield f"{name} differs"
