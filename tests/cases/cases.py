# SPDX-License-Identifier: LGPL-2.1-or-later
"""Small cases out of what people have reported about programs that mesh bodies, cut
them and look at results, each with its right value or its refusal.

A folder holds the files of one report, as README.md tells; what is like it is made
of the same files, or of a scene as a dictionary. A test is a list of cases by
right() and refused(), and of stories, where more than one run is needed.
"""

import pathlib
import re
import sys
import tempfile

HERE = pathlib.Path(__file__).resolve().parent
sys.path += [str(HERE.parent / "program"), str(HERE.parent / "scenes")]
from checks import no_message
from program_cases import Case, run_cases, scene_text
from stories import Place

# A block of 2 x 2 x 2 elements that is pulled by 0.1: its lid rises by 0.2.
BLOCK = (HERE / "names_of_files" / "body.geo").read_text()
BLOCK_SCENE = {
    "Body/Shape": "file",
    "Body/File": "body.geo",
    "Material/Young's modulus": "1",
    "Material/Poisson's ratio": "0",
    "Support/Fixed faces": "ground",
    "Load/Pressures": "lid: -0.1",
    "Output/Node tables": "true",
}

VALIDATED = ", --validate"


def folder(name):
    """The files of a folder."""
    return {path.name: path.read_bytes() for path in (HERE / name).iterdir()}


def changed(files, name, *changes):
    """The files, with each (old, new) text of one of them replaced."""
    content = files[name]
    text = content if isinstance(content, str) else content.decode()
    for old, new in changes:
        if old not in text:
            raise ValueError(f"there is no '{old}' in {name}")
        text = text.replace(old, new)
    return {**files, name: text.encode()}


def block(values=None, geometry=BLOCK):
    """The block's scene with other values, and its geometry."""
    return {"scene.prm": scene_text({**BLOCK_SCENE, **(values or {})})[0],
            "body.geo": geometry}


def box(values):
    """A scene of a box."""
    return {"scene.prm": scene_text(values)[0]}


def both_ways(name, files, scene, status, pieces, **more):
    """The case as a run, and with --validate."""
    case = Case(name, [scene], files, status, pieces, **more)
    return [case, case._replace(name=name + VALIDATED, checks=(),
                                arguments=[scene, "--validate"])]


def refused(name, files, *pieces, scene="scene.prm", **more):
    """A sentence that has these pieces; nothing is written, with --validate too."""
    return both_ways(name, files, scene, 1, pieces, **more)


def refused_later(name, files, *pieces, scene="scene.prm", checks=()):
    """A sentence in the midst of a run, which --validate cannot know."""
    def sentence(_, result):
        lines = result.stderr.splitlines()
        if len(lines) != 1 or not re.fullmatch(r"setsudan: .*\.", lines[0]):
            yield "no sentence on standard error"
        yield from (f"not in the message: {piece}" for piece in pieces
                    if piece not in result.stderr)

    return [Case(name, [scene], files, 1, (), checks=(sentence, *checks))]


def right(name, files, *checks, scene="scene.prm", says=(), **more):
    """A run that ends well and says this; --validate takes the scene, too, which
    is tried of every third: see fewer_validations()."""
    run, validation = both_ways(name, files, scene, 0, says,
                                checks=(no_message, *checks), **more)
    return [run, validation._replace(pieces=["valid"])]


def fewer_validations(cases):
    """A run checks its scene as --validate does: of scenes that run every third is
    validated, and of those that are refused each."""
    names = {case.name for case in cases}
    doubled = [case for case in cases if case.status == 0
               and case.name.endswith(VALIDATED)
               and case.name[:-len(VALIDATED)] in names]
    left_out = {case.name for case in doubled} - {case.name for case in doubled[::3]}
    return [case for case in cases if case.name not in left_out]


def main(cases=(), stories=()):
    """Run a test: PROGRAM [MPIEXEC]; stories are functions of a Place, each with the
    files that it begins with."""
    program, mpiexec = sys.argv[1], (sys.argv + ["mpirun"])[2]
    cases = fewer_validations([case for group in cases for case in group])
    launched = [case._replace(launcher=[mpiexec if word == "mpirun" else word
                                        for word in case.launcher]) for case in cases]
    status = run_cases(program, launched) if cases else 0
    for story, files in stories:
        with tempfile.TemporaryDirectory() as name:
            place = Place(program, mpiexec, pathlib.Path(name), files)
            problems = list(story(place))
        print(f"{'FAILED' if problems else 'passed'}: {story.__doc__}")
        print("".join(f"  {problem}\n" for problem in problems), end="")
        status = 1 if problems else status
    sys.exit(status)
