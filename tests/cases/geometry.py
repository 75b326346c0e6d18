# SPDX-License-Identifier: LGPL-2.1-or-later
"""A. A geometry is a program: what ends gmsh, starts other programs, writes files or
never ends is refused by its command or by the time that it takes; nothing of it is
done, with --validate and on two processes neither.

usage: geometry.py PROGRAM [MPIEXEC]
"""

from cases import BLOCK, block, changed, folder, main, refused, right
from checks import event

LIFTED = event("deform", max_displacement=0.2)
# What a body has that is read out of another file.
INCLUDE = 'Include "other.geo";\n'
ENDLESS = "Macro again\n  n = 1;\n  Call again;\nReturn\nn = 0;\nCall again;\n"
LOOP = "For i In {0:1e12}\n  n = i;\nEndFor\n"
SHORT = {"Body/Meshing time": "2"}
TIME = ("Body/Meshing time", "2 s")


def command(name, line, word, **more):
    """A line that is behind the block's geometry, and what the message names."""
    return refused(name, block(geometry=BLOCK + line + "\n"), "body.geo", word, **more)


def included(name, line, word):
    files = {**block(geometry=BLOCK + INCLUDE), "other.geo": line + "\n"}
    return refused(name, files, word)


def endless(name, text, **more):
    return refused(name, block(SHORT, BLOCK + text), *TIME, seconds=20, **more)


def harmless(name, text):
    """What looks like a command and is none, or does no harm."""
    return right(name, block(geometry=text), LIFTED)


TWO = {"launcher": ["mpirun", "-np", "2"]}
CASES = [
    refused("Exit", folder("exit_in_geometry"), "body.geo", "Exit"),
    refused("Exit on 2 processes", folder("exit_in_geometry"), "Exit", **TWO),
    refused("SystemCall", folder("shell_in_geometry"), "body.geo", "SystemCall"),
    refused("SystemCall on 2 processes", folder("shell_in_geometry"), "SystemCall",
            **TWO),
    refused("Exit in front", changed(folder("exit_in_geometry"), "body.geo",
                                     ("Point(1)", "Exit;\nPoint(1)")), "Exit"),
    command("Exit behind a condition", "If (1)\n  Exit;\nEndIf", "Exit"),
    command("System", 'System "echo ran > it_ran";', "System"),
    command("NonBlockingSystemCall", 'NonBlockingSystemCall "echo ran > it_ran";',
            "SystemCall"),
    command("SystemCall without a blank", 'SystemCall"echo ran > it_ran";',
            "SystemCall"),
    command("SystemCall behind a comment", '/* x */ SystemCall "echo ran > it_ran";',
            "SystemCall"),
    command("OnelabRun", 'OnelabRun("echo", "/bin/touch it_ran");', "OnelabRun"),
    command("Save", 'Save "saved.msh";', "Save"),
    command("Print", 'Print "picture.png";', "picture.png"),
    command("Printf to a file", 'Printf("%g", 1) > "printed.txt";', "Printf"),
    command("Printf behind a file", 'Printf("%g", 1) >> "printed.txt";', "Printf"),
    command("CreateDir", 'CreateDir "folder";', "CreateDir"),
    included("Exit in an included file", "Exit;", "Exit"),
    included("SystemCall in an included file", 'SystemCall "echo ran > it_ran";',
             "SystemCall"),
    included("Save in an included file", 'Save "saved.msh";', "Save"),
    endless("an endless macro", ENDLESS),
    endless("an endless macro on 2 processes", ENDLESS, **TWO),
    endless("a loop without an end", LOOP),
    endless("Sleep", "Sleep 1000;\n"),
    # What is right.
    harmless("a comment", "// Exit; SystemCall \"echo\";\n/* Exit;\nSave \"x\"; */\n"
             + BLOCK),
    harmless("a group whose name is a command",
             BLOCK + 'Physical Curve("Exit") = {1};\n'
             + 'Physical Point("SystemCall") = {1};\n'),
    harmless("a variable that begins as a command", BLOCK + "Exit_width = 1;\n"),
    harmless("Printf to the screen", BLOCK + 'Printf("%g > 1", 2);\n'),
    harmless("Mesh", BLOCK + "Mesh 3;\n"),
    harmless("Abort behind the model", BLOCK + "Abort;\n"),
    right("an included file", {**block(geometry=INCLUDE), "other.geo": BLOCK}, LIFTED),
    right("a time that suffices", block({"Body/Meshing time": "30"}), LIFTED),
    right("the block on 2 processes", block(), LIFTED, **TWO),
]

if __name__ == "__main__":
    main(CASES)
