# SPDX-License-Identifier: LGPL-2.1-or-later
"""What the tests of scripts/study share."""

import pathlib
import re
import subprocess
import sys

SKIPPED = 77
STUDIES = pathlib.Path(__file__).resolve().parents[2] / "scripts" / "studies.d"
sys.path[:0] = [str(STUDIES), str(STUDIES.parent / "render.d")]

# A wedge with friction through a block of gel, in units of mm and mN.
SCENE = """
set Dimension   = 2
set Length unit = mm
set Force unit  = mN
subsection Body
  set Size     = 10, 10
  set Elements = 2, 16
end
subsection Material
  set Young's modulus = 20
  set Poisson's ratio = 0.3
  set Toughness       = 1
end
subsection Support
  set Fixed faces = bottom
end
subsection Blade
  set Drive           = travel
  set Shape           = wedge
  set Wedge angle     = 30
  set Thickness       = 1
  set Shoulder radius = 1
  set Friction        = 0.2
  set Sharpness       = 0
end
subsection Cut
  set Surfaces = x:1
end
subsection Yield
  set Criterion = energy release
end
subsection Division
  set Release = element row
end
subsection Output
  set Frames = none
end
"""


class Failure(Exception):
    """What a script did that it must not."""


def start(script, program, *arguments, folder, status=0):
    """What a script said; it must end with a status."""
    done = subprocess.run(
        [sys.executable, "-B", str(STUDIES / f"{script}.py"), "--program", program,
         *arguments], cwd=folder, capture_output=True, text=True, check=False)
    if done.returncode != status:
        raise Failure(f"{script} {arguments} ends with {done.returncode}: {done.stderr}")
    return done.stderr if status else done.stdout


def refuses(script, program, *arguments, folder, pieces):
    """It ends with a sentence that has some pieces, and nothing is written."""
    before = sorted(folder.rglob("*"))
    message = start(script, program, *arguments, folder=folder, status=1)
    if len(message.splitlines()) != 1 or not message.endswith(".\n") or \
            not message.startswith(f"scripts/{script}: ") or \
            not all(re.search(piece, message) for piece in pieces):
        raise Failure(f"{script} {arguments} says '{message}'")
    if sorted(folder.rglob("*")) != before:
        raise Failure(f"{script} {arguments} has written something")


def needs(*modules):
    """Skip the test where one is not installed."""
    for module in modules:
        try:
            __import__(module)
        except ImportError as error:
            print(f"skipped: {error}")
            sys.exit(SKIPPED)
