# SPDX-License-Identifier: LGPL-2.1-or-later
"""M. Bytes: byte order marks and all line ends are read; characters that look like
others, and files that are no text in UTF-8, are refused with their place.

usage: characters.py PROGRAM
"""

import re

from cases import block, box, changed, folder, main, refused, right
from checks import event, pieces
from stories import ends_well, same_columns

MARK = "\ufeff"
TYPOGRAPHIC = folder("typographic_characters")
LINE_ENDS = folder("line_ends")
BYTE_ORDER = folder("byte_order_mark")
PLAIN = LINE_ENDS["scene_no_last.prm"].decode() + "\n"
HALVES = pieces(1, 1)
# The 8-node cube of two elements, with its numbers as a German spreadsheet or a
# FORTRAN program writes them.
MESH = folder("sparse_numbers")


def plain(text, **files):
    return {"scene.prm": text, **files}


def look_alike(name, line, code, column=None):
    """A line of the paper's scene with a character that looks like another."""
    text = PLAIN + line + "\n"
    place = rf"scene\.prm:{text.count(chr(10))}:{column or '[0-9]+'}: "
    return refused(name, plain(text), re.compile(place), f"U+{code}")


def of_folder(name, line, code):
    scene = f"scene_{name}.prm"
    return refused(name, TYPOGRAPHIC, re.compile(rf"{scene}:{line}:\d+: "), f"U+{code}",
                   scene=scene)


def no_text(name, content):
    return refused(name, plain(content), "scene.prm", "UTF-16")


def mesh_line(name, old, new, line, column):
    """A line of the mesh that gmsh would read wrongly."""
    return refused(name, changed(MESH, "body.msh", (old, new)),
                   re.compile(rf"body\.msh:{line}:{column}\b"))


def read_alike(place):
    """Line ends and byte order marks do not change a digit."""
    variants = {
        "plain": PLAIN, "crlf": PLAIN.replace("\n", "\r\n"),
        "cr": PLAIN.replace("\n", "\r"), "no_last": PLAIN.rstrip("\n"),
        "mark": MARK + PLAIN, "mark_crlf": MARK + PLAIN.replace("\n", "\r\n"),
        "mark_cr": MARK + PLAIN.replace("\n", "\r"),
        "mixed": PLAIN.replace("\n", "\r\n", 3).replace("  set", "\r  set"),
    }
    for name, text in variants.items():
        place.write(f"{name}.prm", text)
        yield from ends_well(place.start(f"{name}.prm", "--output", name))
        yield from same_columns(place.table("plain"), place.table(name), (
            "depth", "cutting_stress", "strain_energy", "max_displacement"), 0)


def included_alike(place):
    """An included file has its own mark and line ends, and is not skipped."""
    material = "# of old\nsubsection Material\n  set Young's modulus = 100\nend\n"
    for i, text in enumerate((material, material.replace("\n", "\r"), MARK + material,
                              MARK + material.replace("\n", "\r\n"))):
        place.write("material.prm", text)
        place.write("scene.prm", PLAIN + "include material.prm\n")
        printed = place.start("scene.prm", "--print-parameters").stdout
        if not re.search(r"Young's modulus\s*= 100\b", printed):
            yield f"file {i} is skipped"


CASES = [
    right("a byte order mark", BYTE_ORDER, HALVES),
    refused("UTF-16", BYTE_ORDER, "scene_utf16.prm", "UTF-16", scene="scene_utf16.prm"),
    no_text("UTF-16 of the other order", PLAIN.encode("utf-16-be").join(
        [b"\xfe\xff", b""])),
    no_text("UTF-16 without a mark", PLAIN.encode("utf-16-le")),
    right("Latin 1 in a comment", plain(b"# \xe4\xf6\xfc\n" + PLAIN.encode()), HALVES),
    refused("Latin 1 in a value", plain(PLAIN.encode() + b"set Length unit = \xb5m\n"),
            "scene.prm:12:", "UTF-8"),
    right("carriage returns", LINE_ENDS, HALVES, scene="scene_mac.prm"),
    right("some lines as on Windows", LINE_ENDS, HALVES, scene="scene_mixed.prm"),
    right("no end of the last line", LINE_ENDS, HALVES, scene="scene_no_last.prm"),
    refused("the line of an error behind carriage returns",
            plain(PLAIN.replace("\n", "\r") + "set Nonsense = 1\r"), "scene.prm:12: "),
    # Characters that look like others.
    of_folder("apostrophe", 13, "2019"),
    of_folder("fullwidth", 13, "FF0C"),
    of_folder("ideographic_space", 4, "3000"),
    of_folder("minus", 13, "2212"),
    of_folder("nbsp", 4, "00A0"),
    look_alike("an en dash", "set Length unit = 1 – 2", "2013", 21),
    look_alike("quotes", "set Length unit = “cm”", "201C", 19),
    look_alike("a zero width space", "set Length\u200b unit = cm", "200B", 11),
    look_alike("a mark within the text", f"set Length {MARK}unit = cm", "FEFF", 12),
    look_alike("a line separator", "set Length unit = cm\u2028set Force unit = gf",
               "2028"),
    look_alike("a colon", "set Length unit = a：b", "FF1A", 20),
    look_alike("an equals sign", "set Length unit ＝ cm", "FF1D", 17),
    look_alike("a fullwidth digit", "set Dimension = ３", "FF13", 17),
    look_alike("a narrow no-break space", "set Length unit =\u202fcm", "202F", 18),
    refused("in an included file", plain("include part.prm\n", **{
        "part.prm": PLAIN.replace("10, 5", "10,\u00a05")}),
            re.compile(r"part\.prm:7:\d+: "), "U+00A0"),
    [case._replace(arguments=[*case.arguments, "--set", "Load/Body force=0, 0, −1"])
     for case in refused("by --set", plain(PLAIN), "--set", "U+2212")],
    # What is meant as it is: letters, units, comments.
    right("kanji, umlauts and signs of units", plain(
        "# “切断” – a cut, with a no-break\u00a0space −1\nset Length unit = µm\n"
        "set Force unit = 力\n" + PLAIN.replace("set Length unit = cm\n", "")), HALVES,
          says=["µm", "力"]),
    # Meshes.
    mesh_line("a decimal comma", "1.0 1.0 2.0", "1,0 1,0 2,0", 13, "1[23]"),
    mesh_line("an exponent of FORTRAN", "1.0 1.0 2.0", "1.0D+00 1.0 2.0", 13, "1[25]"),
    mesh_line("a typographic minus", "1.0 1.0 2.0", "1.0 1.0 −2.0", 13, 20),
    mesh_line("no number", "1.0 1.0 2.0", "1.0 one 2.0", 13, 16),
    right("a mesh with lines as on Windows", {
        **MESH, "body.msh": MESH["body.msh"].replace(b"\n", b"\r\n")},
          event("deform", max_displacement=0.2)),
    right("a geometry with lines as on Windows", block(
        geometry=block()["body.geo"].replace("\n", "\r\n")),
          event("deform", max_displacement=0.2)),
    refused("a mesh with carriage returns", {
        **MESH, "body.msh": MESH["body.msh"].replace(b"\n", b"\r")}, "body.msh"),
    refused("a mesh in UTF-16", {
        **MESH, "body.msh": MESH["body.msh"].decode().encode("utf-16")}, "body.msh"),
]
FILES = {"plain.prm": PLAIN}

if __name__ == "__main__":
    main(CASES, [(read_alike, FILES), (included_alike, FILES)])
