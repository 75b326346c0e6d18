# SPDX-License-Identifier: LGPL-2.1-or-later
"""E. Bounds of boxes and depths hold to a millionth of an element, so that what a
user writes as 0.3 takes the layer at 3*(1/10); a box that holds nothing is refused.

usage: bounds.py PROGRAM
"""

from cases import box, changed, folder, main, refused, right
from checks import event, pieces

FOLDER = folder("box_beside_the_nodes")
# A bar of 10 layers along z, pulled by 0.1: fixed up to z = h its top rises by
# 0.1 (1 - h).
BAR = {
    "Body/Size": "1, 1, 1",
    "Body/Elements": "1, 1, 10",
    "Material/Young's modulus": "1",
    "Material/Poisson's ratio": "0",
    "Support/Fixed faces": "bottom",
    "Load/Pressures": "top: -0.1",
}
SHEET = {**BAR, "Dimension": "2", "Body/Size": "1, 1", "Body/Elements": "1, 10"}
# A block of 4 x 4 x 4, cut along x in part.
BLOCK = {
    "Body/Size": "4, 4, 4",
    "Body/Elements": "4, 4, 4",
    "Support/Fixed faces": "bottom",
    "Blade/Sharpness": "1",
    "Cut/Surfaces": "x:2",
}


def fixed(bounds, height, scene=None, **more):
    """The bar with a box that is fixed, and how high it reaches."""
    values = {**(scene or BAR), "Support/Fixed boxes": bounds, **more}
    return right(f"Fixed boxes = {bounds}{more or ''}", box(values),
                 event("deform", max_displacement=0.1 * (1 - height)))


def nothing(bounds, scene=None, **more):
    values = {**(scene or BAR), "Support/Fixed boxes": bounds, **more}
    return refused(f"Fixed boxes = {bounds}{more or ''}", box(values),
                   "'Fixed boxes'", "nodes", "none")


def rows(name, number, scale, extent, **more):
    """How many rows of the block are cut, of whatever size it is."""
    size = repr(4 * scale)
    bounds = ", ".join(repr(float(value) * scale) for value in extent)
    values = {**BLOCK, "Body/Size": f"{size}, {size}, {size}",
              "Cut/Extent": f"{name} : {bounds}", **more}
    return right(f"{name} : {bounds}", box(values), event(
        "release", released_rows=number), pieces(64))


def empty(extent, scene=None, **more):
    values = {**(scene or BLOCK), "Cut/Extent": extent, **more}
    return refused(f"Extent = {extent}", box(values), "Cut, 'Extent'", "no element face")


SCALES = (1, 0.1, 0.3, 0.7, 1e-6, 1e6)
# Half of the block's cut, bounded by centers of faces.
HALF = (0, 0, 2.5, 4, 4, 4)
CASES = [
    right("the layer at 2*(0.3/3)", FOLDER, event("deform", max_displacement=0.01)),
    refused("a box beside the body", FOLDER, "'Fixed boxes'", "nodes", "none",
            scene="scene_nowhere.prm"),
    refused("a box between the layers", changed(
        FOLDER, "scene.prm", ("0.2, 0.3, 0.3, 0.2", "0.21, 0.3, 0.3, 0.24")),
            "'Fixed boxes'", "nodes", "none"),
    fixed("0, 0, 0, 1, 1, 0.3 : xyz", 0.3),
    fixed("0, 0, 0.3, 1, 1, 0.3 : xyz", 0.3),
    fixed("0, 0, 0.6, 1, 1, 0.7 : xyz", 0.7),
    fixed("0, 0, 0, 1, 1, 0.24 : xyz", 0.2),
    fixed("0, 0, 0, 1, 1, 0.34 : xyz", 0.3),
    fixed("0, 0, 0.3, 1, 1, 0.3 : z", 0.3),
    fixed("0, 0, 0.1, 1, 1, 0.1 : xyz; 0, 0, 0.3, 1, 1, 0.3 : xyz", 0.3),
    fixed("0, 0.3, 1, 0.3 : xy", 0.3, SHEET),
    fixed("-9, -9, 1.2, 9, 9, 1.2 : xyz", 0.3,
          **{"Body/Translate": "0.1, 0.2, 0.9", "Support/Fixed faces": "bottom"}),
    fixed("-1, -0.3, -1, 0, -0.3, 0 : xyz", 0.3, **{"Body/Rotate": "x: -90; z: 180"}),
    fixed("0, 0, 0.09, 0.3, 0.3, 0.09 : xyz", 0.3, **{
        "Body/Scale": "0.3", "Load/Pressures": "top: -0.33333333333333333"}),
    nothing("20, 20, 20, 30, 30, 30 : xyz"),
    nothing("0, 0, 0.31, 1, 1, 0.34 : xyz"),
    nothing("0, 0, 0.301, 1, 1, 0.349 : z"),
    nothing("0, 0, 0, 1, 1, 0.3 : xyz; 2, 2, 2, 3, 3, 3 : x"),
    nothing("0, 0.31, 1, 0.34 : xy", SHEET),
    nothing("0, 0, 1000.3, 1, 1, 1000.3 : xyz"),
    # Faces are cut whose centers lie within.
    *(rows("box", 4, scale, HALF) for scale in SCALES),
    *(rows("depth", 4, scale, (1.5,)) for scale in SCALES),
    rows("depth", 2, 1, (1.4999,)),
    rows("box", 4, 1, (1.5, 0, 2.4, 2.5, 4, 9)),
    empty("box : 0, 0, 2.6, 4, 4, 3.4"),
    empty("box : 20, 20, 20, 30, 30, 30"),
    empty("depth : 0.4"),
    empty("box : 0, 2.6, 4, 3.4", {**BLOCK, "Dimension": "2", "Body/Size": "4, 4",
                                   "Body/Elements": "4, 4",
                                   "Blade/Direction": "0, -1"}),
]

if __name__ == "__main__":
    main(CASES)
