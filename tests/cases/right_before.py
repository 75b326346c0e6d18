# SPDX-License-Identifier: LGPL-2.1-or-later
"""P. Reports of faults that this program has not: groups turned round, bodies of
OpenCASCADE, slits of double nodes, slices that fall, units off by 1000, decimal
commas of the environment, sparse numbers, fronts on the borders of processes.

usage: right_before.py PROGRAM [MPIEXEC]
"""

import os
import re
import subprocess

from cases import changed, folder, main, refused_later, right
from checks import event, group_size, pieces, read, results_of, warns
from stories import ends_well, same_columns

TURNED = folder("group_turned_round")
OCC = folder("opencascade")
SLIT = folder("slit_of_double_nodes")
BEAM = folder("last_slice_falls")
SPARSE = folder("sparse_numbers")
PROCESSES = folder("processes")
GERMAN = folder("german_locale")
COMPARED = ("cutting_stress", "strain_energy", "max_displacement", "max_strain")
MESHES = ("import sys, gmsh; gmsh.initialize(); "
          "gmsh.option.setNumber('General.Terminal', 0); gmsh.open('body.geo'); "
          "gmsh.model.mesh.generate(3); "
          "gmsh.option.setNumber('Mesh.MshFileVersion', float(sys.argv[1])); "
          "gmsh.write('body.msh')")


def frames_exist(directory, _):
    """Each frame that cut.pvd names is there, and the rows before the last are in the
    table with the weight of the beam."""
    output = results_of(directory)
    for name in re.findall('file="([^"]*)"', (output / "cut.pvd").read_text()):
        if not (output / name).exists():
            yield f"{name} is missing"
    for line in read(output / "statistics.csv"):
        if line["event"] != "rest" and abs(float(line["reaction_z"]) - 0.4) > 1e-8:
            yield f"reaction_z is {line['reaction_z']} in row {line['row']}"


def displacement_of_lid(expected):
    """All nodes of the lid, at z = 2, move by this along z."""
    def check(directory, _):
        for row in read(results_of(directory) / "nodes_0001.csv"):
            if float(row["z"]) == 2 and abs(float(row["uz"]) - expected) > 1e-8:
                yield f"node {row['number']} moves by {row['uz']}"

    return check


def slit(place):
    """A slit in the file is the same as its rows split by a cut."""
    for scene in ("scene", "scene_whole"):
        result = place.start(f"{scene}.prm", "--output", scene)
        yield from ends_well(result)
    whole = [line for line in place.table("scene_whole") if line["event"] == "release"]
    made = [line for line in place.table("scene")
            if line["event"] in ("deform", "release")]
    made = [line for line in made if line["event"] == "release" or line["row"] == "0"]
    yield from same_columns(whole[1:], made, COMPARED, 1e-9)
    for name, faces in (("scene", 3), ("scene_whole", 4)):
        found = group_size(place.directory / name / "piece_0.msh", 2, "cut")
        if found != faces:
            yield f"{name}: the group 'cut' has {found} faces instead of {faces}"


def turned_in_a_file(place):
    """A group that is turned round, in files of gmsh of both versions."""
    python = "/usr/bin/python3"
    for version in ("2.2", "4.1"):
        made = subprocess.run([python, "-c", MESHES, version], cwd=place.directory,
                              capture_output=True, check=False)
        if made.returncode != 0:
            print("skipped: python3-gmsh is missing")
            return
        place.write("scene.prm", changed(TURNED, "scene.prm", ("body.geo", "body.msh"))[
            "scene.prm"])
        yield from ends_well(place.start("scene.prm"))
        yield from displacement_of_lid(-0.2)(place.directory, None)


def german(place):
    """A locale with decimal commas changes no byte."""
    (place.directory / "locales").mkdir()
    locale = str(place.directory / "locales" / "de_DE.UTF-8")
    if subprocess.run(["localedef", "-i", "de_DE", "-f", "UTF-8", locale],
                      stderr=subprocess.DEVNULL, check=False).returncode > 1:
        print("skipped: the sources of locales are missing")
        return
    yield from ends_well(place.start("scene.prm", "--output", "c"))
    before = dict(os.environ)
    os.environ.update(LOCPATH=str(place.directory / "locales"), LC_ALL="de_DE.UTF-8",
                      LANG="de_DE.UTF-8")
    try:
        yield from ends_well(place.start("scene.prm", "--output", "de"))
    finally:
        os.environ.clear()
        os.environ.update(before)
    contents = place.contents()
    for name, content in contents.items():
        if re.fullmatch(r"c/(stage_.*|nodes_.*|piece_.*\.msh)", name):
            if contents.get("de" + name[1:]) != content:
                yield f"{name} differs"
    yield from same_columns(place.table("c"), place.table("de"), COMPARED, 0)


def sparse_pieces(place):
    """Pieces of a body with sparse numbers are numbered from 1, and are bodies."""
    yield from ends_well(place.start("scene_serendipity.prm", "--output", "out"))
    place.write("again.prm", "subsection Body\n  set Shape = file\n  set File = "
                "out/piece_0.msh\nend\nsubsection Support\n  set Fixed faces = cut\nend\n")
    yield from ends_well(place.start("again.prm", "--output", "again"))
    nodes = (place.directory / "out/piece_0.msh").read_text().partition("$Nodes\n")[2]
    if nodes.split()[1:4] != ["20", "1", "20"]:
        yield f"the nodes are {nodes.split()[1:4]}"


def on_processes(place):
    """Cuts that cross, on 1, 2 and 3 processes: the same events, and pieces."""
    options = ["scene.prm", "--set", "Division/Solve=every row anew", "--output"]
    for n in (1, 2, 3):
        yield from ends_well(place.start(*options, str(n), processes=n))
        yield from same_columns(place.table("1"), place.table(str(n)), COMPARED, 1e-6)
        if [(line["event"], line["row"]) for line in place.table("1")] != [
                (line["event"], line["row"]) for line in place.table(str(n))]:
            yield f"other events on {n} processes"
    contents = place.contents()
    for i in range(4):
        if len({contents[f"{n}/piece_{i}.msh"] for n in (1, 2, 3)}) != 1:
            yield f"piece_{i}.msh differs"


CASES = [
    right("a group turned round", TURNED, displacement_of_lid(-0.2)),
    right("a pull on it", changed(TURNED, "scene.prm", ("lid: 0.1", "lid: -0.1")),
          displacement_of_lid(0.2)),
    right("one of two faces turned round", changed(TURNED, "body.geo", (
        "{-s[1]}", "{s[1]}")), displacement_of_lid(-0.2)),
    right("a body of OpenCASCADE", OCC, event("deform", max_displacement=0.15)),
    right("its interface as a cut", OCC, pieces(8, 8), scene="scene_cut.prm"),
    refused_later("a slice that falls", BEAM, "Piece 1 ", "Loose pieces",
                  checks=[frames_exist]),
    right("a slice that is dropped", BEAM, event("divide", reaction_z=0.3), pieces(3, 1),
          scene="scene_drop.prm"),
    right("a slice that nothing loads", BEAM, event(
        "divide", max_strain=0, force_residual=0), scene="scene_still.prm"),
    right("units off by 1000", folder("units_off_by_1000"), warns("Linear range"),
          warns("overlaps itself")),
    right("sparse numbers", SPARSE, event("deform", max_displacement=0.2,
                                          reaction_z=-0.1)),
]
STORIES = [(slit, SLIT), (turned_in_a_file, TURNED), (german, GERMAN),
           (sparse_pieces, SPARSE), (on_processes, PROCESSES)]

if __name__ == "__main__":
    main(CASES, STORIES)
