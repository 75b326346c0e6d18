# SPDX-License-Identifier: LGPL-2.1-or-later
"""Bodies under finite strain."""

import math

from bodies import Body, near
from problems import Case, Row, material, solve

FINITE = {"Deformation/Strain": "finite"}


def moduli(mu, kappa):
    """Young's modulus and Poisson's ratio."""
    return material(repr(9 * kappa * mu / (3 * kappa + mu)),
                    (3 * kappa - 2 * mu) / (2 * (3 * kappa + mu)))


# Schröder et al.: the block of 50 mm under a pressure on a quarter of its top.
BLOCK_LAMBDA, BLOCK_MU = 499.92568, 1.61148
BLOCK_PATH = {.1: 2.0122, .5: 10.1077, 1: 19.63724}
PUNCH_MU, PUNCH_RATIO = 80.194e6, .4999
# On n³ elements, and parts of the pressure of 4 MPa times 100; deal.II's step-44 has
# -0.2119, -0.2186 and -0.7279, -0.7719 with its 27-node elements.
PUNCH = {(2, 20): (-.203878, -.21187), (2, 100): (-.699181, -.72786),
         (4, 20): (-.216529, -.21862), (4, 100): (-.756084, -.77192)}


def pressed_block(options, n, size, settings):
    """A block of which a quarter of the top is pressed."""
    body = Body(3)
    body.add_block((n, n, n), lambda *p: tuple(size * x for x in p), straight=True)
    middle = size / 2 - 1e-7
    body.add_group("x", lambda x, y, z: near(x, size))
    body.add_group("y", lambda x, y, z: near(y, size))
    body.add_group("bottom", lambda x, y, z: near(z, 0))
    body.add_group("top", lambda x, y, z: near(z, size))
    body.add_group("patch", lambda x, y, z: near(z, size) and min(x, y) > middle)
    return solve(options, {**FINITE, **settings,
                           "Support/Fixed components":
                               "x : x; y : y; bottom : z; top : xy"},
                 body).at((size, size, size), "uz")


def block_rows(options):
    ratio = BLOCK_LAMBDA / (2 * (BLOCK_LAMBDA + BLOCK_MU))
    of_block = {**material(repr(2 * BLOCK_MU * (1 + ratio)), ratio),
                "Material/Law": "neo-Hooke", "Material/Volumetric energy": "quadratic",
                "Material/Formulation": "displacement"}
    for part, expected in BLOCK_PATH.items():
        # A dead pressure is a traction.
        u = pressed_block(options, 4, 50, {**of_block,
                                           "Load/Tractions": f"patch : 0, 0, {-3 * part}"})
        yield Row(f"block under a dead pressure, {part:.0%} of it", "4 × 4 × 4",
                  expected, -u, 2e-5)
    stiffness = 2 * PUNCH_MU * (1 + PUNCH_RATIO)
    for (n, part), (expected, quadratic) in PUNCH.items():
        for element, reference in (("serendipity", expected), ("quadratic", quadratic)):
            u = pressed_block(options, n, 1e-3, {
                **material(repr(stiffness), PUNCH_RATIO), "Body/Element type": element,
                "Load/Tractions": f"patch : 0, 0, {-4e6 * part}"})
            yield Row(f"step-44's block, pressure {part}, mixed formulation",
                      f"{n} × {n} × {n} {element}", reference, u / 1e-3, 5e-5)


# Cook's membrane by an independent program: displacements at (48, 60), and the potential
# energy.
COOK = {"neo-Hooke": {2: (7.244555, -6.331790, -388.7410), 4: (7.628546, -6.762379, -408.2838),
                      8: (7.724621, -6.899498, -412.5888)},
        "isochoric neo-Hooke": {2: (6.025249, -5.153092, -319.2598),
                                4: (6.618164, -5.541923, -345.2844),
                                8: (6.811739, -5.694626, -354.4978)}}
# The code gallery's, compressible, decoupled, in space: u_y at (48, 52).
GALLERY_MU, GALLERY_RATIO = .4225, .3
GALLERY = {2: 13.9129, 4: 14.5628, 8: 14.6891}


def membrane(dim, n):
    def place(s, t, *u):
        return (48 * s, 44 * s * (1 - t) + (44 + 16 * s) * t, *u)
    body = Body(dim)
    body.add_block((n, n) + (1,) * (dim - 2), place)
    body.add_group("left", lambda *p: near(p[0], 0))
    body.add_group("right", lambda *p: near(p[0], 48))
    if dim == 3:
        body.add_group("sides", lambda *p: near(p[2] * (1 - p[2]), 0))
    return body


def membrane_rows(options):
    for law, meshes in COOK.items():
        is_mixed = law != "neo-Hooke"
        of_law = (moduli(80.1938, 400942) if is_mixed
                  else material("240.565", .3))
        for n, references in meshes.items():
            state = solve(options, {**FINITE, **of_law, "Material/Law": law,
                                    "Support/Fixed faces": "left",
                                    "Load/Tractions": "right : 0, 6.25"}, membrane(2, n))
            found = (state.at((48, 60), "uy"), state.at((48, 60), "ux"),
                     float(state.line["potential_energy"]))
            for quantity, reference, computed in zip(
                    ("v at (48, 60)", "u at (48, 60)", "potential energy"),
                    references, found):
                yield Row(f"membrane, {quantity}, {law}", f"{n} × {n}, plane strain",
                          reference, computed, 1e-6)
    for n, reference in GALLERY.items():
        state = solve(options, {**FINITE,
                                **material(repr(2 * GALLERY_MU * (1 + GALLERY_RATIO)),
                                           GALLERY_RATIO),
                                "Material/Law": "isochoric neo-Hooke",
                                "Support/Fixed components": "left : xyz; sides : z",
                                "Load/Tractions": "right : 0, 0.0625, 0"}, membrane(3, n))
        yield Row("membrane, v at (48, 52), isochoric neo-Hooke, compressible",
                  f"{n} × {n} × 1", reference, state.at((48, 52, 0), "uy"), 2e-5)


# Radii 1 and 2; the pressure at which an incompressible neo-Hookean body of mu = 1 has
# the inner radius 1.5. Of other ratios, an independent program's.
CYLINDER_PRESSURE, SPHERE_PRESSURE = .42822841, .75543312
CYLINDER = {.49: {(2, 4): 1.508143, (4, 8): 1.507965}, .4999: {(2, 4): 1.500279},
            .499999: {(2, 4): 1.500201, (4, 8): 1.500021, (8, 16): 1.500003}}
SPHERE = {.4999: {(2, 4): 1.500086, (4, 4): 1.500199}, .49: {(2, 4): 1.517639}}


def cylinder_rows(options):
    for nu, meshes in CYLINDER.items():
        for (across, along), reference in meshes.items():
            def place(s, t):
                r, angle = 1 + s, t * math.pi / 2
                return r * math.cos(angle), r * math.sin(angle)
            body = Body(2)
            body.add_block((across, along), place)
            body.add_group("inner", lambda x, y: near(math.hypot(x, y), 1))
            body.add_group("x axis", lambda x, y: near(y, 0))
            body.add_group("y axis", lambda x, y: near(x, 0))
            state = solve(options, {
                **FINITE, **material(repr(2 * (1 + nu)), nu),
                "Load/Pressures": f"inner : {CYLINDER_PRESSURE}",
                "Support/Fixed components": "x axis : y; y axis : x"}, body)
            yield Row(f"cylinder under inner pressure, its radius, ν = {nu}",
                      f"{across} × {along}, plane strain", reference,
                      1 + state.at((1, 0), "ux"), 1e-5)


def sphere_rows(options):
    for nu, meshes in SPHERE.items():
        for (n, across), reference in meshes.items():
            body = Body(3)
            for axis in range(3):
                def place(s, t, u):
                    direction = (1, t, u)
                    r = (1 + s) / math.hypot(*direction)
                    point = [r * d for d in direction]
                    return tuple(point[-axis:] + point[:-axis])
                body.add_block((across, n, n), place)
            for axis, name in enumerate("xyz"):
                body.add_group(name, lambda *p, a=axis: near(p[a], 0))
            body.add_group("inner", lambda *p: near(math.hypot(*p), 1))
            state = solve(options, {
                **FINITE, **material(repr(2 * (1 + nu)), nu),
                "Load/Pressures": f"inner : {SPHERE_PRESSURE}",
                "Support/Fixed components": "x : x; y : y; z : z"}, body)
            inner = [math.hypot(*(x + float(node[c]) for x, c in
                                  zip(node["p"], ("ux", "uy", "uz"))))
                     for node in state.nodes if near(math.hypot(*node["p"]), 1)]
            yield Row(f"sphere under inner pressure, its mean radius, ν = {nu}",
                      f"3 × {n} × {n} × {across}", reference, sum(inner) / len(inner),
                      # That program's nodes are those of a part of 1 / 24.
                      1e-3 / n ** 2)


# Tip displacements of Sze, Liu and Lo at parts of the load of 4.
BEAM = {.05: (.026, .663), .1: (.103, 1.309), .15: (.224, 1.922), .2: (.381, 2.493),
        .25: (.563, 3.015), .3: (.763, 3.488), .35: (.971, 3.912), .4: (1.184, 4.292),
        .45: (1.396, 4.631), .5: (1.604, 4.933), .55: (1.807, 5.202), .6: (2.002, 5.444),
        .65: (2.190, 5.660), .7: (2.370, 5.855), .75: (2.541, 6.031), .8: (2.705, 6.190),
        .85: (2.861, 6.335), .9: (3.010, 6.467), .95: (3.151, 6.588), 1: (3.286, 6.698)}
# By an independent program, on n × 1 × 1 elements at the full load.
BEAM_MESHES = {("linear elastic", 5): (1.84041, 5.14017), ("linear elastic", 20): (3.26823, 6.67871),
               ("neo-Hooke", 20): (3.26783, 6.67867)}


def beam(options, law, n, part):
    """Shortening and deflection of a cantilever's end."""
    state = solve(options, {
        **FINITE, **material("1.2e6", 0.), "Material/Law": law, "Body/Size": "10, 1, 0.1",
        "Body/Elements": f"{n}, 1, 1", "Support/Fixed faces": "left",
        "Load/Tractions": f"right : 0, 0, {40 * part}"})

    def end(column):
        # Weights of the shape functions over the end face.
        nodes = [node for node in state.nodes if near(node["p"][0], 10)]
        corners = [float(n[column]) for n in nodes
                   if all(near(n["p"][c] * (size - n["p"][c]), 0)
                          for c, size in ((1, 1), (2, .1)))]
        middles = [float(n[column]) for n in nodes]
        return -sum(corners) / 12 + (sum(middles) - sum(corners)) / 3
    return -end("ux"), end("uz")


def beam_rows(options):
    for (law, n), references in BEAM_MESHES.items():
        for quantity, reference, computed in zip(("shortening", "deflection"), references,
                                                 beam(options, law, n, 1)):
            yield Row(f"cantilever, {quantity}, {law}", f"{n} × 1 × 1", reference, computed,
                      1e-4)
    for part, references in BEAM.items():
        for quantity, reference, computed in zip(("shortening", "deflection"), references,
                                                 beam(options, "linear elastic", 40, part)):
            # Three digits of the larger one.
            bound = .0015 * references[1] / reference
            yield Row(f"cantilever, {quantity} at {part:.0%} of the load", "40 × 1 × 1",
                      reference, computed, bound)


def rows(options, _):
    yield from block_rows(options)
    yield from membrane_rows(options)
    yield from cylinder_rows(options)
    yield from sphere_rows(options)
    yield from beam_rows(options)


CASE = Case(
    "finite", "Finite strain",
    "block: Schröder et al., A selection of benchmark problems in solid mechanics and applied "
    "mathematics, Archives of Computational Methods in Engineering 28, 2021, whose trunk space "
    "of order 2 is the 20-node element; step-44's block: deal.II's tutorial program itself with "
    "27 nodes, an independent program with 20; membrane: the same program in plane strain, and in "
    "space for the data of deal.II's code gallery (Pelteret and McBride), where 14.74 is reached; "
    "cylinder and sphere: closed forms of the incompressible body, 1.5, and that program for "
    "other ratios; cantilever: Sze, Liu and Lo, Finite Elements in Analysis and Design 40, 2004", rows)
