# SPDX-License-Identifier: LGPL-2.1-or-later
"""Blades that travel through a block, and open a double cantilever."""

import math

from plane_cut import PLANE, Cut, block, energies, number
from problems import Case, Row, material, run_table

# Elements along the cut, and the mean force over the toughness of the prototype.
THIN = {1e-3: {8: 1.0092, 16: 1.0060, 32: 1.0040}, 1e-2: {16: 1.0193, 32: 1.0124}}


def thin_rows(options, long):
    """A blade without a body: its force is the toughness, and what is stored."""
    for toughness, meshes in THIN.items():
        for n, mean in meshes.items():
            mesh = f"R = {toughness} E H, {n} along the cut"
            cut = block(options, n, {"Material/Toughness": toughness})
            yield from energies(cut, mesh)
            yield Row("mean force over toughness", mesh, 1, cut.mean_force(), 3e-4,
                      expected=mean)
            if toughness == 1e-3:
                # The edge leaves the front after each release, and begins anew.
                line = cut.begin
                indentation = number(line, "travel") - number(line, "depth")
                yield Row("force × indentation / 2 over toughness × row", mesh,
                          toughness / n, number(line, "blade_force") * indentation / 2,
                          1e-8)
    if long:
        cut = block(options, 64, {"Material/Toughness": 1e-2})
        mesh = "R = 0.01 E H, 64 along the cut"
        yield Row("first force over toughness", mesh, 1,
                  number(cut.yields[0], "blade_force") / 1e-2, .01, expected=1.50)
        yield Row("rows that split first", mesh, 2, number(
            next(line for line in cut.lines if line["event"] == "release"),
            "released_rows"), 0)


def wedge_rows(options, long):
    """A slender block, far from its ends."""
    wedge = {"Blade/Shape": "wedge", "Blade/Wedge angle": 40, "Blade/Thickness": .1,
             "Blade/Shoulder radius": .05, "Material/Toughness": 1e-3}
    for n in (16, 32) if long else (16,):
        mesh = f"40 degrees, {n} over 1"
        cut = Cut(options, n // 2, 2 * n, (.5, 2), wedge, (.8, 1.3))
        yield from energies(cut, mesh)
        yield Row("mean force over toughness", mesh, 1, cut.mean_force(), .006)
    for release, n_ahead in (("node row", 2), ("element row", 1)):
        cut = Cut(options, 8, 32, (.5, 2), {
            **wedge, "Division/Release": release, "Division/Look-ahead": n_ahead},
            (.8, 1.3))
        yield Row(f"mean force over toughness, {release}, look-ahead {n_ahead}",
                  "40 degrees, 16 over 1", 1, cut.mean_force(), .006)


def wire_rows(options, _):
    """The same block and a wire, behind which the walls close again."""
    for friction in (0, .1):
        mesh = f"wire 0.15, friction {friction}, 16 over 1"
        cut = Cut(options, 8, 32, (.5, 2), {
            "Blade/Shape": "wire", "Blade/Thickness": .15,
            "Blade/Friction": friction, "Material/Toughness": 1e-3}, (.8, 1.3))
        yield from energies(cut, mesh)
        # What is stored behind it is given back.
        yield Row("1 + energy that is stored over work", mesh, 1,
                  1 + cut.change("strain_energy") / cut.change("work"), 1e-3)
        if friction == 0:
            yield Row("mean force over toughness", mesh, 1, cut.mean_force(), 1e-3)


def height_rows(options, _):
    """The slender block and a wedge that ends inside it, behind which the walls close
    again and give back what they had stored, and one that does not end there."""
    wedge = {"Blade/Shape": "wedge", "Blade/Wedge angle": 40, "Blade/Thickness": .1,
             "Blade/Shoulder radius": .05, "Material/Toughness": 1e-3}
    cuts = {height: Cut(options, 8, 32, (.5, 2), {**wedge, "Blade/Height": height},
                        (.8, 1.3)) for height in (0, .4, 3)}
    yield from energies(cuts[.4], "40 degrees, 0.4 high, 16 over 1")
    yield Row("mean force over toughness", "40 degrees, 0.4 high, 16 over 1", 1,
              cuts[.4].mean_force(), .02)
    for column in ("travel", "blade_force", "strain_energy"):
        yield Row(f"{column}, higher than the body over endless", "16 over 1",
                  number(cuts[0].end, column), number(cuts[3].end, column), 1e-12)


def blunt_rows(options, _):
    """An edge whose radius takes two fifths of the work, and friction around it."""
    for friction in (0, .25):
        blunt = block(options, 16, {
            "Material/Toughness": 6e-4, "Material/Shear limit": .01,
            "Blade/Edge radius": .01 / (1 + friction), "Blade/Friction": friction})
        sharp = block(options, 16, {"Material/Toughness": 1e-3,
                                    "Blade/Friction": friction})
        for column in ("travel", "blade_force", "surface_energy"):
            yield Row(f"{column}, blunt edge over larger toughness",
                      f"friction {friction}, 16 along the cut",
                      number(sharp.end, column), number(blunt.end, column), 1e-9)


def profile_rows(options, _):
    """A wedge whose flanks and shank are given as a profile."""
    shapes = [{"Blade/Shape": "wedge", "Blade/Wedge angle": 90, "Blade/Thickness": .1},
              {"Blade/Shape": "profile", "Blade/Profile": "0 : 0, 0.05 : 0.05"}]
    wedge, profile = (block(options, 8, {**shape, "Material/Toughness": 1e-3})
                      for shape in shapes)
    for column in ("travel", "blade_force", "work"):
        yield Row(f"{column}, profile over wedge", "8 along the cut",
                  number(wedge.end, column), number(profile.end, column), 1e-9)


ARM, HALF_THICKNESS, TOUGHNESS = .05, .01, 4e-7


def cantilever_rows(options, long):
    """Two arms that a wedge with a sharp shoulder opens, and friction there."""
    plane = 1 / (1 - .3 ** 2)
    inertia = ARM ** 3 / 12
    length = (9 * plane * inertia * HALF_THICKNESS ** 2 / TOUGHNESS) ** .25
    normal = 3 * plane * inertia * HALF_THICKNESS / length ** 3
    flank = HALF_THICKNESS / math.tan(math.radians(10))
    for friction in (0, .1, .3):
        mesh = f"friction {friction}, 4 through an arm"
        cut = Cut(options, 8, 160, (2 * ARM, 2), {
            "Blade/Shape": "wedge", "Blade/Wedge angle": 20,
            "Blade/Thickness": 2 * HALF_THICKNESS, "Material/Toughness": TOUGHNESS,
            "Blade/Friction": friction}, (.8, 1.3))
        crack = number(cut.begin, "depth") - (number(cut.begin, "travel") - flank)
        yield Row("length from shoulder to front", mesh, length, crack + .673 * ARM, .015)
        yield Row("mean force", mesh, TOUGHNESS + 2 * friction * normal,
                  cut.mean_force() * TOUGHNESS, .02)
        yield from energies(cut, mesh, 1e-7)


def slab_rows(options, _):
    """A slab of one layer of hexahedra between two walls is in plane strain."""
    wedge = {"Blade/Shape": "wedge", "Blade/Wedge angle": 20, "Blade/Thickness": .1,
             "Blade/Shoulder radius": .05, "Material/Toughness": 1e-3,
             "Blade/Friction": .2}
    plane = block(options, 8, wedge)
    slab = run_table(options, {
        **PLANE, **wedge, "Dimension": 3, "Body/Size": "0.5, 1, 1",
        "Body/Elements": "1, 8, 8", "Cut/Surfaces": "y:4",
        "Support/Fixed components": "left : x; right : x"})
    for column in ("blade_force", "strain_energy", "work"):
        line, of_slab = plane.end, slab[plane.lines.index(plane.end)]
        yield Row(f"{column}, slab over plane strain", "8 x 8", number(line, column),
                  2 * number(of_slab, column), 1e-8)
    yield Row("travel, slab over plane strain", "8 x 8", number(plane.end, "travel"),
              number(slab[plane.lines.index(plane.end)], "travel"), 1e-8)


SLICING_TOUGHNESS = 1e-3


def sliced(options, slice_push, grip=""):
    """The middle of a cut by a thin blade that moves along its edge as it is pushed: what
    changes there, the mean force along its way, and its last line."""
    drag = min(slice_push, grip) if grip else slice_push
    lines = run_table(options, {
        **PLANE, "Dimension": 3, "Body/Size": "1, 1, 1", "Body/Elements": "1, 8, 8",
        "Cut/Surfaces": "y:4", "Blade/Slice-push ratio": slice_push,
        "Blade/Edge grip": grip, "Material/Toughness": SLICING_TOUGHNESS})
    yields = [line for line in lines if line["event"] == "deform"]
    begin, end = (next(line for line in yields if number(line, "depth") >= depth)
                  for depth in (.25, .75))
    change = {name: number(end, name) - number(begin, name)
              for name in ("work", "friction_energy", "travel", "strain_energy",
                           "surface_energy")}
    # The edge's part of the work is F (1 + k ξ) for each travel.
    return change, change["work"] / (1 + drag * slice_push) / change["travel"], end


def slicing_rows(options, _):
    toughness = SLICING_TOUGHNESS
    for slice_push, grip in ((0, ""), (.5, ""), (1, ""), (2, ""), (4, ""), (2, .5)):
        drag = min(slice_push, grip) if grip else slice_push
        change, push, end = sliced(options, slice_push, grip)
        mesh = f"slices {slice_push}, grip {grip or 'perfect'}"
        yield Row("push over toughness × width / (1 + k²)", mesh,
                  toughness / (1 + drag ** 2), push, .02)
        yield Row("work less storage and friction over surface", mesh,
                  change["surface_energy"], change["work"] - change["strain_energy"] -
                  change["friction_energy"], 1e-7)
        if slice_push:
            yield Row("force along the edge over push × k", mesh,
                      drag * number(end, "blade_force"), number(end, "force_along"), 1e-9)


def off_cut(options, layer):
    """The mean force over the toughness with which a wedge without friction cuts a layer
    off a high block that is 8 wide: the bent off-cut stores no more as it gets longer."""
    return Cut(options, 8, 80, (8, 40), {
        "Cut/Surfaces": f"x:{layer}", "Material/Toughness": 1e-3, "Blade/Shape": "wedge",
        "Blade/Wedge angle": 20, "Blade/Thickness": .4, "Blade/Shoulder radius": 1},
        (12, 28)).mean_force()


def off_cut_rows(options, long):
    for layer, expected in ((1, 1.035), (2, 1.018)) if long else ((2, 1.018),):
        yield Row("mean force over toughness of a bent off-cut", f"layer {layer} of 8", 1,
                  off_cut(options, layer), .002, expected=expected)


# Speed over that at which the toughness doubles, and the mean force over the toughness
# at that speed of the prototype.
SPEEDS = {.25: 1.009, 1: 1.011, 4: 1.014}


def rate_rows(options, _):
    """A thin blade through a block whose toughness grows with the root of speed."""
    for speed, mean in SPEEDS.items():
        cut = block(options, 16, {
            "Material/Toughness": 1e-3, "Material/Rate exponent": .5,
            "Material/Rate speed": 1, "Blade/Speed": speed})
        mesh = f"speed {speed}, 16 along the cut"
        toughness = 1 + speed ** .5
        yield Row("mean force over toughness at that speed", mesh, 1,
                  cut.mean_force() / toughness, .003, expected=mean)
        yield Row("work left for surface over toughness × area", mesh,
                  1e-3 * toughness * cut.change("depth"), cut.new_surface(), .005)
        yield Row("time over travel / speed", mesh, cut.change("travel") / speed,
                  cut.change("time"), 1e-9)


def stored_in_arms(tilt, travel, crack):
    """By beams that a wedge opens at their tips, whose inner sides turn towards it."""
    length = crack + .673 * ARM
    opening = tilt * travel / (1 - .75 * tilt * ARM / length)
    return 3 / (1 - .3 ** 2) * ARM ** 3 / 12 * opening ** 2 / length ** 3


def tip_rows(options, _):
    """A slender wedge between the tips of two arms, pushed and withdrawn."""
    toughness, tilt, row = 1e-7, math.tan(math.radians(2)), 2 / 160
    scene = {
        **PLANE, "Body/Size": f"{2 * ARM}, 2", "Body/Elements": "8, 160",
        "Cut/Surfaces": "x:4", "Blade/Shape": "wedge", "Blade/Wedge angle": 4,
        "Blade/Thickness": .09, "Material/Toughness": toughness}
    mesh = "4 degrees, 4 through an arm"
    for friction in (0, .3):
        lines = run_table(options, {**scene, "Blade/Friction": friction,
                                    "Blade/Travel": "0.35, 0.3"})
        yields = [line for line in lines if line["event"] == "deform"]
        for travel in () if friction else (.2, .3):
            line = next(line for line in yields if number(line, "travel") > travel)
            # The mouth's hat, which the wedge touches, is a third of a row from there.
            stored = [stored_in_arms(tilt, number(line, "travel") - row / 3,
                                     number(line, "depth") - row / 3 + more)
                      for more in (0, row)]
            yield Row(f"energy release of beams over toughness at a travel of {travel}",
                      mesh, toughness, (stored[0] - stored[1]) / row, .015)
        pushed, withdrawn = (line for line in lines if line["event"] == "travel")
        for line, way, name in ((pushed, 1, "pushed"), (withdrawn, -1, "withdrawn")):
            angle = math.radians(2) + way * math.atan(friction)
            flank, rubbed = number(line, "flank_force"), number(line, "friction_force")
            pressure = (flank - rubbed) / tilt
            across = pressure - tilt * rubbed
            yield Row(f"force over that across, {name}, friction {friction}", mesh,
                      math.tan(angle), flank / across, 1e-10)


def withdrawal_rows(options, _):
    """A wedge that is pushed, withdrawn and pushed again."""
    wedge = {"Material/Toughness": 1e-3, "Blade/Shape": "wedge", "Blade/Wedge angle": 30,
             "Blade/Thickness": .1, "Blade/Shoulder radius": .05,
             "Blade/Travel": "0.5, 0.2, 0, 0.2, 0.5, 0", "Body/Size": "1, 1",
             "Body/Elements": "8, 8", "Cut/Surfaces": "x:4"}
    for friction, adhesion in ((0, 0), (.3, 0), (.3, 1e-3)):
        lines = run_table(options, {**PLANE, **wedge, "Blade/Friction": friction,
                                    "Blade/Adhesion": adhesion})
        mesh = f"wedge, friction {friction}, adhesion {adhesion}"
        stops = [line for line in lines if line["event"] == "travel"]
        first, back, out, in_again, again, end = stops
        work = number(end, "work")
        yield Row("1 + energy that is missing over work", mesh, 1, 1 + max(
            abs(number(line, "work") - sum(number(line, column) for column in (
                "strain_energy", "surface_energy", "friction_energy", "excess_energy")))
            for line in lines) / work, 1e-9)
        yield Row("1 + energy that is stored when it is withdrawn over work", mesh, 1,
                  1 + number(out, "strain_energy") / work, 1e-12)
        if adhesion:
            continue
        yield Row("force where it had been, pushed again over before", mesh,
                  number(first, "blade_force"), number(again, "blade_force"), 1e-9)
        if friction:
            continue
        yield Row("force on the way back over that on the way in", mesh,
                  number(back, "blade_force"), number(in_again, "blade_force"), 1e-9)
        yield Row("work of a push and withdrawal over surface and excess", mesh,
                  number(out, "surface_energy") + number(out, "excess_energy"),
                  number(out, "work"), 1e-9)
        yield Row("1 + work that shoulders take over work", mesh, 1,
                  1 + number(end, "excess_energy") / work, 2e-3)


def stress_rows(options, _):
    """A blade that travels and one whose load rises split a row at one force, where
    nothing but the front touches them. A row may only split at a larger force where it
    yields as the one before it splits, which leaves the force where it is: a corner's
    behind a mid-side node's."""
    for release in ("node row", "element row"):
        scene = {
            **PLANE, "Body/Size": "1, 1", "Body/Elements": "8, 8", "Cut/Surfaces": "x:4",
            "Support/Fixed faces": "", "Support/Fixed components": "bottom : y",
            "Support/Displacements": "left : -0.1, free; right : 0.1, free",
            "Yield/Criterion": "maximum shear", "Material/Shear limit": .5,
            "Division/Release": release}
        travel = run_table(options, scene)
        ramp = run_table(options, {
            **scene, "Blade/Drive": "force", "Blade/Edge loads": "0 : 1",
            "Division/Load control": "ramp", "Division/Split rows": "free"})
        forces = [[number(line, "blade_force") for line in lines
                   if line["event"] == "yield"] for lines in (travel, ramp)]
        yield Row("rows", release, len(forces[1]), len(forces[0]), 0)
        yield Row("force of the first row, travel over ramp", release,
                  forces[1][0], forces[0][0], 1e-9)
        yield Row("largest force of a row, travel over ramp", release,
                  max(forces[1]), max(forces[0]), 1e-9)


def block_rows(options, _):
    """A wide wedge without friction that rests on a block's top, which does not split."""
    lines = run_table(options, {
        **material(5, .2), "Material/Toughness": 1e6, "Support/Fixed faces": "bottom",
        "Body/Size": "10, 10, 10", "Body/Elements": "10, 10, 10", "Cut/Surfaces": "y:5",
        "Yield/Criterion": "energy release", "Division/Release": "element row",
        "Blade/Drive": "travel", "Blade/Travel": 1, "Blade/Sharpness": 0,
        "Blade/Shape": "wedge", "Blade/Wedge angle": 120, "Blade/Thickness": 4})
    line = lines[-1]
    mesh = "120 degrees, 10 x 10 x 10"
    force = number(line, "blade_force")
    yield Row("force", mesh, 19.69, force, .015)
    yield Row("reaction over force", mesh, force, number(line, "reaction_z"), 1e-10)
    yield Row("1 + reaction across the cut over force", mesh, 1,
              1 + number(line, "reaction_y") / force, 1e-10)
    yield Row("energy that is stored over work", mesh, number(line, "work"),
              number(line, "strain_energy"), 1e-9)


def half_plane_rows(options, _):
    """A blunt wedge without friction on a block that is much larger than its contact.
    The width is known up to an element: its mean over many travels is."""
    slope, n_stops = math.tan(math.radians(5)), 15
    lines = run_table(options, {
        **PLANE, "Body/Size": "60, 30", "Body/Elements": "160, 80", "Cut/Surfaces": "x:80",
        "Material/Toughness": 1e6, "Blade/Shape": "wedge", "Blade/Wedge angle": 170,
        "Blade/Thickness": 30,
        "Blade/Travel": ", ".join(str(.3 + .03 * i) for i in range(n_stops))})
    stops = [line for line in lines if line["event"] == "travel"]
    pressures = [number(line, "blade_force") / number(line, "contact_area")
                 for line in stops]
    yield Row("mean pressure over E' cot α / 2, α = 85°", "160 x 80",
              slope / (1 - .3 ** 2) / 2, sum(pressures) / n_stops, .03)


def rows(options, long):
    for of_kind in (thin_rows, wedge_rows, wire_rows, profile_rows, height_rows,
                    blunt_rows, cantilever_rows, slab_rows, slicing_rows, off_cut_rows, rate_rows,
                    tip_rows, withdrawal_rows, stress_rows, block_rows,
                    half_plane_rows):
        yield from of_kind(options, long)


CASE = Case(
    "blade", "Blades that travel",
    "energy balance; of a thin blade, mean forces of an independent program for half a "
    "block with 8-node quadrilaterals; of the wedge between two arms, beam theory, "
    "a + 0.673 h = (9 E' I (T/2)² / R)^¼ from the shoulder to the front and "
    "F = R + 2 μ N, N = 3 E' I (T/2) / (a + 0.673 h)³; of a wedge at the tips of two "
    "arms, stored energy 3 E' I (t p)² / (a + 0.673 h)³ and F/N = tan(α/2 ± φ); of a wedge on a "
    "block, linear contact of the same mesh with GetFEM 5.4.2; of one on a half plane, "
    "P = E' a cot α (Johnson, Contact Mechanics, section 5.2)", rows)
