# SPDX-License-Identifier: LGPL-2.1-or-later
"""J. A body far from the origin, as in map coordinates, has the forces, energies and
displacements that it has at the origin; tests/readers looks at its frames.

usage: far.py PROGRAM [MPIEXEC]
"""

from cases import changed, folder, main
from program_cases import scene_text
from stories import ends_well, same_columns

FOLDER = folder("far_from_the_origin")
COLUMNS = ("depth", "cutting_stress", "strain_energy", "max_displacement", "max_strain",
           "reaction_z", "blade_force")
SHEET = {
    "Dimension": "2",
    "Body/Size": "0.2, 0.2",
    "Body/Elements": "4, 2",
    "Material/Shear limit": "0.001",
    "Support/Fixed faces": "bottom",
    "Blade/Thickness": "0.004",
    "Blade/Direction": "0, -1",
    "Blade/Edge loads": "0:0.001",
    "Cut/Surfaces": "x:2",
}
FAR = {"Body/Translate": "-400000, 5000000"}


def compare(place, first, second):
    """Two scenes have the same rows."""
    for scene in (first, second):
        yield from ends_well(place.start(scene, "--output", f"of_{scene}"))
    yield from same_columns(place.table(f"of_{first}"), place.table(f"of_{second}"),
                            COLUMNS, 1e-6)


def in_map_coordinates(place):
    """A body at 500 000 and 5 000 000."""
    yield from compare(place, "scene.prm", "scene_far.prm")


def refined(place):
    """The same, refined."""
    for scene in ("scene.prm", "scene_far.prm"):
        text = (place.directory / scene).read_text()
        place.write(scene, text.replace("= 4, 2, 2", "= 4, 2, 2\n  set Refinement = 1"))
    yield from compare(place, "scene.prm", "scene_far.prm")


def in_the_plane(place):
    """A sheet at -400 000 and 5 000 000."""
    yield from compare(place, "sheet.prm", "sheet_far.prm")


def by_a_plane(place):
    """The body at map coordinates, cut by a plane there."""
    yield from compare(place, "scene.prm", "by_plane.prm")


def on_two_processes(place):
    """The body at map coordinates on 2 processes."""
    yield from ends_well(place.start("scene.prm", "--output", "one"))
    yield from ends_well(place.start("scene_far.prm", "--output", "two", processes=2))
    yield from same_columns(place.table("one"), place.table("two"), COLUMNS, 1e-6)


def a_piece(place):
    """A piece of the far body, brought back to the origin."""
    yield from ends_well(place.start("scene_far.prm", "--output", "cut"))
    yield from ends_well(place.start("back.prm", "--output", "back"))
    place.write("near.prm", scene_text({
        "Body/Size": "0.2, 0.1, 0.2", "Body/Elements": "4, 1, 2",
        "Support/Fixed faces": "bottom", "Load/Body force": "0, 0, -0.1"})[0])
    yield from ends_well(place.start("near.prm", "--output", "near"))
    yield from same_columns(place.table("near"), place.table("back"),
                            ("strain_energy", "max_displacement", "reaction_z"), 1e-6)


FILES = {
    **FOLDER,
    "sheet.prm": scene_text(SHEET)[0],
    "sheet_far.prm": scene_text({**SHEET, **FAR,
                                 "Blade/Edge loads": "0:0.001"})[0],
    "by_plane.prm": changed(FOLDER, "scene_far.prm", (
        "y:1", "plane : 0, 5000000.1, 0; 0, 1, 0"))["scene_far.prm"],
    "back.prm": scene_text({
        "Body/Shape": "file", "Body/File": "cut/piece_0.msh",
        "Body/Translate": "-500000, -5000000, 0",
        "Support/Fixed boxes": "-1, -1, 0, 1, 1, 0 : xyz",
        "Load/Body force": "0, 0, -0.1"})[0],
}

if __name__ == "__main__":
    main(stories=[(story, FILES) for story in (
        in_map_coordinates, refined, in_the_plane, by_a_plane, on_two_processes,
        a_piece)])
