# SPDX-License-Identifier: LGPL-2.1-or-later
"""C. 'where : expression' is one expression that is 0 on the cut: lists, assignments
and comparisons are refused, though muParser takes them; commas and comparisons
within an expression are right.

usage: expressions.py PROGRAM
"""

import re

from cases import box, changed, folder, main, refused, right
from checks import lacks, pieces

FOLDER = folder("comma_in_expression")
PLATE = {
    "Body/Size": "4, 4, 1",
    "Body/Elements": "4, 4, 1",
    "Support/Fixed faces": "bottom",
    "Blade/Sharpness": "1",
}
PLANE = {**PLATE, "Dimension": "2", "Body/Size": "4, 4", "Body/Elements": "4, 4",
         "Support/Fixed faces": "left", "Blade/Direction": "0, -1"}
HINT = "that is 0 on the cut"
COMMA = re.compile(r"comma|','")


def cut(expression, scene=None, **more):
    return {"name": f"where : {expression}",
            "files": box({**(scene or PLATE), "Cut/Surfaces": f"where : {expression}",
                          **more})}


def wrong(expression, *words, scene=None):
    return refused(*cut(expression, scene).values(), "Cut, 'Surfaces'", expression,
                   lacks(r"\.\.$"), *words)


def comma(expression, scene=None):
    return wrong(expression, COMMA, scene=scene)


def equation(expression, scene=None):
    return wrong(expression, HINT, scene=scene)


def fine(expression, *expected, scene=None, **more):
    return right(*cut(expression, scene, **more).values(), pieces(*expected))


CASES = [
    refused("a decimal comma", FOLDER, "scene.prm:12: subsection Cut, 'Surfaces'", COMMA),
    right("a decimal point", FOLDER, pieces(9, 7), scene="scene_point.prm"),
    refused("an equation", FOLDER, "scene_equation.prm:12: ", HINT,
            scene="scene_equation.prm"),
    refused("a decimal comma in the second of two surfaces",
            changed(FOLDER, "scene_point.prm",
                    ("- 2.2", "- 2.2; where : y - 2,5")), COMMA, "y - 2,5",
            scene="scene_point.prm"),
    # Lists.
    comma("0,5*x"),
    comma("x - 2, y - 2"),
    comma("y - 2,0"),
    comma("y - 2 ,"),
    comma(", y - 2"),
    wrong("(x - 1, y - 2)"),
    comma("0,5*x - 1", scene=PLANE),
    # Assignments and comparisons.
    equation("x = 2, y - 1"),
    equation("y = 2"),
    equation("(y = 2)"),
    equation("x = y"),
    equation("y == 2"),
    equation("y > 2"),
    equation("y >= 2"),
    equation("y < 2"),
    equation("y != 2"),
    equation("x > 1 && y > 2"),
    equation("x > 1 || y > 2"),
    equation("x += 2"),
    equation("y == 2", scene=PLANE),
    equation("x = 2", scene=PLANE),
    # What is no expression at all.
    wrong("y -"),
    wrong("2y - 4"),
    wrong("y - 2 = 0"),
    wrong("x > 2 and y > 2"),
    refused(*cut("y − 2").values(), "scene.prm:14:26: ", "U+2212"),
    wrong("sqrt(y - 2"),
    wrong("max()"),
    # What is right.
    fine("y - 2", 8, 8),
    fine("min(x, y) - 1", 9, 7),
    fine("max(x, y) - 3", 9, 7),
    fine("min(x - 1, y - 1, 5)", 9, 7),
    fine("x < 1 ? y - 2 : y - 2", 8, 8),
    fine("(x < 2) ? (y - 1) : (y - 1)", 4, 12),
    fine("y - (x > 9 ? 1 : 2)", 8, 8),
    fine("abs(y - 2) - 1", 4, 8, 4),
    fine("y - 2.", 8, 8),
    fine("2e0 - y", 8, 8),
    fine("(y - 2)*(1 + x^2)", 8, 8),
    fine("min(x, y) - 1", 9, 7, scene=PLANE),
    fine("x < 1 ? x - 2 : x - 2", 8, 8, scene=PLANE),
    fine("y < 1 ? x - 1 : x - 2", 7, 9, scene=PLANE),
    fine("x < 1 ? y - 1 : y - 2", 7, 9, **{"Blade/Direction": "0, 0, -1"}),
]

if __name__ == "__main__":
    main(CASES)
