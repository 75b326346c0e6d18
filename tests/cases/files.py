# SPDX-License-Identifier: LGPL-2.1-or-later
"""K. Files: a run replaces what a run of this program has written, and nothing else; it
never removes what it reads. Names with blanks, kanji and '#' are what they are.

usage: files.py PROGRAM
"""

import re

from cases import BLOCK, BLOCK_SCENE, box, changed, folder, main, refused, right
from checks import pieces
from program_cases import scene_text
from stories import ends_well, fails, same_columns

PIECES = folder("body_in_the_output_directory")
BLADE = {
    "Body/Size": "2, 2, 1",
    "Body/Elements": "2, 2, 1",
    "Support/Fixed faces": "bottom",
    "Blade/Sharpness": "1",
    "Cut/Surfaces": "y:1",
}
CUT = scene_text(BLADE)[0]
# Files of the user, whose names are those of results.
OWN = {name: f"{name} is mine\n" for name in (
    "statistics.csv", "nodes_0001.csv", "frame_0003.vtu", "cut.pvd", "piece_7.msh",
    "stage_0002.inp", "notes.txt")}
NAMES = ["body 1.geo", "体.geo", "sub dir/体 ü.geo", "body#1.geo", "sub dir/#.geo", "a#b#c.geo"]


def body_of(name):
    return scene_text({**BLOCK_SCENE, "Body/File": name})[0]


def kept(place, before, *names):
    """Problems where files are not as they were before."""
    after = place.contents()
    for name in names or before:
        if after.get(name) != before[name]:
            yield f"{name} is {'changed' if name in after else 'gone'}"


def a_body_in_the_output(place):
    """A piece of a run is cut in the directory of that run: its file stays."""
    yield from ends_well(place.start("a.prm"))
    before = place.contents()
    result = place.start("b.prm")
    yield from fails(result, "out/piece_0.msh")
    yield from kept(place, before)
    yield from ends_well(place.start("b.prm", "--output", "elsewhere"))
    yield from kept(place, before)
    yield from ends_well(place.start("out/parameters.prm", "--validate"))


def a_scene_in_the_output(place):
    """The scene, or a file that it includes, is in the directory of the output."""
    place.write("out/statistics.csv", "include ../a.prm\n")
    before = place.contents()
    yield from fails(place.start("out/statistics.csv", "--output", "out"), "out")
    place.write("scene.prm", "include out/statistics.csv\n")
    yield from fails(place.start("scene.prm", "--output", "out"), "out")
    yield from kept(place, before)


def files_of_the_user(place):
    """--output . does not replace files of the user."""
    for name, content in OWN.items():
        place.write(name, content)
    before = place.contents()
    yield from fails(place.start("a.prm", "--output", "."), "statistics.csv|cut.pvd|nodes")
    yield from kept(place, before)
    yield from fails(place.start("a.prm", "--output", ".", "--resume"), "")
    yield from kept(place, before)


def one_file_of_the_user(place):
    """One file of the user, of whatever name, stays where no run has been."""
    for name in OWN:
        place.write(f"{name}.d/{name}", OWN[name])
        before = place.contents()
        result = place.start("a.prm", "--output", f"{name}.d")
        yield from ends_well(result) if result.returncode == 0 else fails(result, name)
        yield from kept(place, before)


def other_files_stay(place):
    """Other files in the directory of a run stay, and the run is replaced."""
    yield from ends_well(place.start("a.prm"))
    place.write("out/notes.txt", OWN["notes.txt"])
    place.write("out/frame_list.txt", "mine\n")
    before = place.contents()
    yield from ends_well(place.start("a.prm", "--set", "Output/Frames=none"))
    yield from kept(place, before, "out/notes.txt", "out/frame_list.txt")
    if (place.directory / "out/frame_0000.vtu").exists():
        yield "the frames of the earlier run are still there"


def a_run_again(place):
    """The same run twice in one place."""
    for _ in range(2):
        yield from ends_well(place.start("a.prm"))
    yield from same_columns(place.table("out"), place.table("out"), ("depth",))


def names(place):
    """Bodies with blanks, kanji and '#' in their names, also from parameters.prm."""
    for i, name in enumerate(NAMES):
        place.write(name, BLOCK)
        place.write("a b.prm", body_of(name))
        place.write("include.prm", "include a b.prm\n")
        for scene in ("a b.prm", "include.prm"):
            output = f"out ü {i} {scene}"
            result = place.start(scene, "--output", output)
            yield from (f"{name}: {problem}" for problem in ends_well(result))
            for line in place.table(output)[-1:]:
                if abs(float(line["max_displacement"]) - 0.2) > 1e-8:
                    yield f"{name}: {line['max_displacement']}"
        again = place.start(f"{output}/parameters.prm", "--output", "again")
        yield from (f"{name}, parameters.prm: {p}" for p in ends_well(again))


def a_comment_in_a_name(place):
    """A name with ' #' ends there, and is refused."""
    place.write("body #1.geo", BLOCK)
    place.write("scene.prm", body_of("body #1.geo"))
    yield from fails(place.start("scene.prm"), "File")
    yield from fails(place.start("a.prm", "--output", "run #2"), "#")
    if (place.directory / "run").exists() or (place.directory / "run #2").exists():
        yield "there is a directory 'run'"


def output_with_a_sign(place):
    """'run' and 'run#2' are two directories, and stay so from parameters.prm."""
    yield from ends_well(place.start("a.prm", "--output", "run"))
    before = place.contents()
    yield from ends_well(place.start("a.prm", "--output", "run#2"))
    yield from ends_well(place.start("a.prm", "--output", "run#2", "--resume"))
    printed = place.start("run#2/parameters.prm", "--print-parameters").stdout
    if not re.search(r"set Directory\s*= run#2\s", printed):
        yield "parameters.prm has another directory"
    # A scene is not replaced by its own results.
    whole = place.contents()
    yield from fails(place.start("run#2/parameters.prm"), "run#2/parameters.prm")
    yield from kept(place, whole)
    yield from ends_well(place.start("run#2/parameters.prm", "--output", "run#3"))
    yield from kept(place, before)


def quoted(place):
    """Quotes belong to a name, and the message shows it as it is."""
    place.write("body 1.geo", BLOCK)
    place.write("scene.prm", body_of('"body 1.geo"'))
    result = place.start("scene.prm")
    if result.returncode != 0:
        yield from fails(result, '"body 1.geo"')


COMMENTS = ("# first", "   # second", "set Length unit = mm # third",
            "set Force unit = kN\t# fourth", "#fifth", "subsection Load # sixth", "end # seventh")
CASES = [
    right("comments at the beginning and behind blanks", {"scene.prm": "\n".join(COMMENTS) + "\n" + CUT},
          pieces(2, 2)),
    refused("'#' behind a word", {"scene.prm": CUT.replace("end", "end#", 1)},
            "scene.prm:", "'end#'"),
    right("'#' in a label", changed(box(BLADE), "scene.prm", (
        "subsection Cut", "set Length unit = m#1\nsubsection Cut")),
          pieces(2, 2), says=["m#1"]),
]
STORIES = [(story, PIECES) for story in (
    a_body_in_the_output, a_scene_in_the_output, files_of_the_user, one_file_of_the_user,
    other_files_stay, a_run_again, names, a_comment_in_a_name, output_with_a_sign,
    quoted)]

if __name__ == "__main__":
    main(CASES, STORIES)
