# SPDX-License-Identifier: LGPL-2.1-or-later
"""A displacement that is chosen, solved by manufactured.cc: the orders with which its
errors fall. The numbers are those of manufactured.output, which is a test of its own."""

import pathlib
import re

from problems import Case, Row

OUTPUT = pathlib.Path(__file__).with_suffix(".output")
LINE = re.compile(r"(.*), refined (\d+): displacement \S+ order (\S+), stress \S+ order "
                  r"(\S+)")


def rows(*_):
    # The last line of each body is that of its finest elements.
    finest = {}
    for line in OUTPUT.read_text().splitlines():
        name, level, displacement, stress = LINE.fullmatch(line).groups()
        finest[name] = (level, float(displacement), float(stress))
    for name, (level, displacement, stress) in finest.items():
        mesh = f"{name}, refined {level} times"
        yield Row("order of the displacement's error", mesh, 3, displacement, .05)
        yield Row("order of the stress's error", mesh, 2, stress, .1)


CASE = Case("manufactured", "Chosen displacement with its body force",
            "closed form; the orders are those of quadratic elements", rows)
