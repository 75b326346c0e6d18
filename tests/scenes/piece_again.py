#!/usr/bin/env python3
# SPDX-License-Identifier: LGPL-2.1-or-later
"""A piece of one scene is the body of the next: a cube is cut, its second half
is turned, stood on the cut's face, and cut again.

Written as it was at rest the piece behaves as a box of its size does; in its
deformed shape it is another body, which is cut as well.
"""

import argparse
import pathlib
import subprocess
import sys
import tempfile

import tables

FIRST = """
subsection Body
  set Size     = 4, 4, 4
  set Elements = 2, 4, 2
end
subsection Support
  set Fixed faces = bottom
end
subsection Load
  set Body force = 0, 0, -0.05
end
subsection Blade
  set Edge loads = 1:1, 3:1
  set Thickness  = 0.1
end
subsection Material
  set Shear limit = 0.01
end
subsection Cut
  set Surfaces = y:2
end
subsection Output
  set Frames = none
  set Piece shape = {shape}
end
"""

# The half lies on the cut: what was behind it is above.
SECOND = """
subsection Body
  set Shape     = file
  set File      = first/piece_1.msh
  set Rotate    = x: 90
  set Translate = 0, 4, -2
end
subsection Support
  set Fixed faces = cut
end
subsection Blade
  set Direction  = 0, 0, -1
  set Edge loads = 1:1, 3:1
  set Thickness  = 0.1
end
subsection Material
  set Shear limit = 0.01
end
subsection Cut
  set Surfaces = plane: 2, 0, 0; 1, 0, 0
end
subsection Output
  set Frames = none
end
"""

BOX = SECOND.replace("""  set Shape     = file
  set File      = first/piece_1.msh
  set Rotate    = x: 90
  set Translate = 0, 4, -2
""", """  set Size     = 4, 4, 2
  set Elements = 2, 2, 2
""").replace("= cut", "= bottom").replace("plane: 2, 0, 0; 1, 0, 0", "x:1")


def run(program, directory, name, scene):
    (directory / f"{name}.prm").write_text(scene)
    result = subprocess.run([program, str(directory / f"{name}.prm"), "--output",
                             str(directory / name)], capture_output=True, text=True)
    if result.returncode != 0:
        sys.exit(f"{name}: {result.stderr}")
    return tables.read(directory / name / "statistics.csv")


def main():
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("--program", required=True)
    program = parser.parse_args().program
    with tempfile.TemporaryDirectory() as temporary:
        directory = pathlib.Path(temporary)
        run(program, directory, "first", FIRST.format(shape="rest"))
        again = run(program, directory, "again", SECOND)
        box = run(program, directory, "box", BOX)
        if [line["event"] for line in again] != [line["event"] for line in box]:
            sys.exit("the events of the piece differ from those of a box")
        for column in ("depth", "strain_energy", "cutting_stress", "max_displacement"):
            scale = max(abs(float(line[column])) for line in box)
            error = max(tables.relative_error(float(a[column]), float(b[column]), scale)
                        for a, b in zip(again, box))
            print(f"{column}: {error:.1e}")
            if not error <= 1e-9:
                sys.exit(f"{column} of the piece is not that of a box")

        run(program, directory, "first", FIRST.format(shape="deformed"))
        deformed = run(program, directory, "again", SECOND)
        if deformed[-1]["event"] != "divide" or deformed[-1]["pieces"] != "2":
            sys.exit("the deformed piece is not divided")
        change = abs(float(deformed[1]["strain_energy"]) /
                     float(box[1]["strain_energy"]) - 1)
        print(f"its shape changes the first strain energy by {change:.1e}")
        if not 1e-6 < change < 0.2:
            sys.exit("the deformed piece has not the deformed shape")


main()
