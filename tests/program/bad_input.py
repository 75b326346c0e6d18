# SPDX-License-Identifier: LGPL-2.1-or-later
"""Scenes with one thing wrong: the program says in one line what and where, and
writes nothing.

usage: bad_input.py PROGRAM GROUP
"""

import sys

from program_cases import PLANE_SCENE, SCENE, Case, run_cases, scene_text
from program_cases import wrong_text, wrong_value
from wrong_values import BLADE_ON_BOARD, INSIDE, ON_BOARD, TRAVEL, WEDGED
from wrong_values import WRONG_BOARD, WRONG_IN_SPACE, WRONG_SLICE, WRONG_TRAVEL
from wrong_values import WRONG_VALUES, WRONG_WEDGED

GOOD_TEXT, LINES = scene_text(SCENE)
N_LINES = len(GOOD_TEXT.splitlines())


def wrong_line(line, *pieces):
    """A line behind the good scene."""
    text = GOOD_TEXT + line + "\n"
    return wrong_text(f"line '{line}'", text, f"scene.prm:{N_LINES + 1}:", *pieces)


def wrong_option(*arguments, pieces, files=None):
    return Case(
        " ".join(arguments),
        ["scene.prm", *arguments],
        {"scene.prm": GOOD_TEXT, **(files or {})},
        1,
        pieces,
    )


def no_scene(name, *pieces, files=None):
    return Case(name, [name], files or {}, 1, pieces)


def syntax():
    subsection = "subsection Body\n"
    yield wrong_line("set Nonsense = 1", "no parameter 'Nonsense'")
    yield wrong_line("set size = 1", "no parameter 'size'")
    yield wrong_text(
        "unknown name",
        GOOD_TEXT + subsection + "  set Sise = 1, 1, 1\nend\n",
        f"scene.prm:{N_LINES + 2}: ",
        "no parameter subsection Body, 'Sise'",
    )
    for path in ("Bodies", "body", "Body/Inner"):
        yield wrong_text(
            "subsection " + path,
            scene_text({path + "/Size": "1, 1, 1", **SCENE})[0],
            "scene.prm:2: there is no subsection '" + path + "'",
        )
    for line in ("sett Dimension = 3", "Dimension = 3", "set Dimension"):
        yield wrong_line(line, f"'{line}' is not understood")
    for line in ("set = 3", "subsection", "end", "include", "<xml>"):
        yield wrong_line(line, f"'{line}' is not understood")
    yield wrong_line("set Dimension = \0", "a character of code 0")
    # Control characters are not quoted as such.
    yield wrong_line("set Dimension = \x1b[2J", "'Dimension' is '?[2J'")
    yield wrong_line("set Dimension = \u2212" + "3", ":17: ", "U+2212", "write -")
    yield wrong_text(
        "missing end", GOOD_TEXT + subsection, "scene.prm:", "'Body' has no 'end'"
    )
    yield wrong_text(
        "end with a name", subsection + "end Body\n", "scene.prm:2: 'end Body'"
    )


def files():
    yield wrong_line("include scene.prm", "includes itself")
    yield wrong_line("include missing.prm", "'missing.prm' cannot be read")
    yield wrong_line("include .", "cannot be read")
    yield wrong_text(
        "error in an included file",
        "# first\ninclude parts/part.prm\n",
        "parts/part.prm:2: 'garbage' is not understood",
        files={"parts/part.prm": "# first\ngarbage\n"},
    )
    yield no_scene("missing.prm", "'missing.prm' cannot be read")
    yield no_scene("folder", "'folder' cannot be read", files={"folder/file": ""})


def options():
    yield wrong_option("--set", "Body/Elements", pieces=["--set", "'Body/Elements'"])
    yield wrong_option("--set", "=3", pieces=["--set", "'=3'"])
    yield wrong_option("--set", "Body/=3", pieces=["--set: "])
    yield wrong_option("--set", "Bodi/Size=1", pieces=["--set: ", "subsection 'Bodi'"])
    yield wrong_option("--set", "Body/Sise=1", pieces=["--set: ", "Body, 'Sise'"])
    yield wrong_option(
        "--set", "Body/Size=1,1", pieces=["--set: subsection Body, 'Size' is '1,1'"]
    )
    yield wrong_option("--set", "Dimension=4", pieces=["--set: 'Dimension' is '4'"])
    for value in ("a #b", "#b", "a\\"):
        yield wrong_option("--output", value, pieces=["that a scene file can hold"])
    yield wrong_option("--output", "a\u00a0b", pieces=["--output:2: ", "U+00A0"])


def output():
    unwritable = ["cannot be written", "Not a directory", "Output/Directory"]
    for directory in ("scene.prm/below", "scene.prm"):
        yield wrong_text(
            "Directory = " + directory,
            scene_text({**SCENE, "Output/Directory": directory})[0],
            f"'{directory}'",
            *unwritable,
        )
        yield wrong_option(
            "--output", directory, pieces=[f"'{directory}'", *unwritable]
        )
    yield wrong_option("--output", "", pieces=["--output: ", "'Directory' is ''"])
    # Somebody's files, and those that the run reads, are not replaced.
    for name in ("statistics.csv", "parameters.prm", "piece_3.msh"):
        yield wrong_option("--output", ".", files={name: "mine"},
                           pieces=[f"it holds '{name}' of names that a run writes"])
    signed = {"run/parameters.prm": "# Written by setsudan\n" + GOOD_TEXT}
    yield wrong_option("--output", "run", "--set", "Output/Frames=none",
                       pieces=["the run reads 'run/parameters.prm' in it"],
                       files=signed)._replace(
        name="a scene in its own output", arguments=["run/parameters.prm", "--output",
                                                     "run"])


def support():
    values = {k: v for k, v in SCENE.items() if not k.startswith("Support")}
    yield wrong_text(
        "no support at all",
        scene_text(values)[0],
        "scene.prm (default value): subsection Support, 'Fixed faces' is ''",
        "free to move rigidly in 6 ways",
    )
    yield wrong_text(
        "some components only",
        scene_text({**values, "Support/Fixed components": "bottom : yz"})[0],
        "subsection Support",
        "free to move rigidly in 1 way.",
    )


def travel():
    for base in (SCENE, PLANE_SCENE):
        for path, value, allowed, *also in WRONG_TRAVEL:
            yield wrong_value(path, value, allowed, {**base, **TRAVEL}, *also)
        for path, value, allowed, *also in WRONG_WEDGED:
            yield wrong_value(path, value, allowed, {**base, **WEDGED}, *also)
    for dimension, base, plane in ((3, SCENE, "0, 0, 0; 0, 0, 1"),
                                   (2, PLANE_SCENE, "0, 0; 0, 1")):
        path, value, allowed, also = INSIDE[dimension]
        yield wrong_value(path, value, allowed, {**base, **TRAVEL}, also)
        for path, value, allowed in BLADE_ON_BOARD:
            yield wrong_value(path, value, allowed,
                              {**base, **TRAVEL, "Board/Plane": plane})
    for path, value, allowed, *also in WRONG_IN_SPACE:
        yield wrong_value(path, value, allowed, {**SCENE, **TRAVEL}, *also)
    for path, value, allowed in WRONG_SLICE:
        yield wrong_value(path, value, allowed,
                          {**SCENE, **TRAVEL, "Blade/Slice-push ratio": "1"})
    # What nothing holds the blade would push away; results have begun by then.
    yield Case(
        "a side that nothing holds",
        ["scene.prm"],
        {"scene.prm": scene_text({**SCENE, **TRAVEL, "Support/Fixed faces": "front"})[0]},
        1,
        ["frees a part that nothing holds", "Support"],
        checks=[lambda *_: []],
    )


def board():
    for path, value, allowed, *also in WRONG_BOARD:
        yield wrong_value(path, value, allowed, {**SCENE, **ON_BOARD}, *also)
    # What the board cannot keep; results have begun by then.
    for name, settings in (
            ("a body that is lifted off its board", {"Load/Body force": "0, 0, 1"}),
            ("a body that tips over on its board",
             {"Load/Body force": "0, 0, -1", "Board/Plane": "0, 0, 0; 0, 1, 1"})):
        yield Case(
            name, ["scene.prm"],
            {"scene.prm": scene_text({**SCENE, **ON_BOARD, **settings})[0]},
            1, ["does not stay on the board", "Support"], checks=[lambda *_: []])


def cases(group):
    for dimension, base in ((3, SCENE), (2, PLANE_SCENE)):
        for path, value, allowed, *also in WRONG_VALUES.get((group, dimension), []):
            yield wrong_value(path, value, allowed, base, *also)
    special = {
        "syntax": syntax,
        "files": files,
        "options": options,
        "support": support,
        "output": output,
        "travel": travel,
        "board": board,
    }
    yield from special.get(group, lambda: [])()


if __name__ == "__main__":
    sys.exit(run_cases(sys.argv[1], list(cases(sys.argv[2]))))
