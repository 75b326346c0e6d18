#!/usr/bin/env python3
# SPDX-License-Identifier: LGPL-2.1-or-later
"""Orthotropic and layered bodies: isotropic constants give the tables of Hooke's law
through whole cuts, beams of three plies have the stiffness of their layers in the plane
and in bending, and what a cut requires depends on its normal and on the layer.
"""

import math
import pathlib
import sys
import tempfile

import program
import run_scene
import tables

# At an angle to all axes of the body, and about z.
ASKEW = "1, 2, -2, 2, 1, 2"
ABOUT_Z = "2, 1, 0, -1, 2, 0"
DISPLACEMENT = "Material/Formulation=displacement"
# Scene, Young's modulus, Poisson's ratio, axes, and what else is set.
ISOTROPIC = (
    ("block_2x4x4", 5, .2, ASKEW),
    ("block_2x4x4", 5, .2, ASKEW, "Solver/Method=iterative"),
    ("block_2x4x4", 5, .2, ASKEW, "Body/Element type=quadratic"),
    ("block_2x4x4", 5, .2, ASKEW, "Body/Element type=linear"),
    ("mean_shear", 5, .4, ASKEW, DISPLACEMENT, "Material/Poisson's ratio=0.4"),
    ("plane_strain", 5, .2, ABOUT_Z),
    ("double_cantilever", 1000, .3, ABOUT_Z),
    ("blade_wedge", 5, .3, ABOUT_Z),
    ("accuracy", 5, .3, ABOUT_Z),
    ("finite_decks", 10, .2, ASKEW, "Material/Law=linear elastic",
     "Blade/Edge loads=uniform : 10", "Blade/Thickness=0.5"),
    ("finite_auto", 10, .3, ABOUT_Z, "Material/Law=linear elastic"),
)


def run(options, scene, *settings, processes=1):
    """The lines of a scene's statistics."""
    with tempfile.TemporaryDirectory() as directory:
        path = pathlib.Path(options.scenes) / f"{scene}.prm"
        program.run(options, path, directory, (*program.QUIET, *settings), processes)
        return tables.read(pathlib.Path(directory) / "statistics.csv")


def triple(value):
    return ", ".join([repr(value)] * 3)


def check_isotropic(options):
    results = []
    for scene, modulus, ratio, axes, *settings in ISOTROPIC:
        orthotropic = (f"Material/Young's moduli={triple(modulus)}",
                       f"Material/Poisson's ratios={triple(ratio)}",
                       f"Material/Shear moduli={triple(modulus / (2 * (1 + ratio)))}",
                       f"Material/Axes={axes}")
        expected = run(options, scene, *settings)
        for processes in (1, 2) if len(settings) == 0 else (1,):
            lines = run(options, scene, *settings, *orthotropic, processes=processes)
            errors = (list(run_scene.column_errors(lines, expected, 1e-9))
                      if len(lines) == len(expected) else [f"{len(lines)} events"])
            print(f"{scene} {' '.join(settings)}, {processes} processes: "
                  f"{len(expected)} events, {errors or 'the same'}")
            results.append(not errors)
    return results


def check(name, found, expected, bound):
    error = abs(found / expected - 1)
    print(f"{name}: {found:.7g}, expected {expected:.7g}")
    if not error <= bound:
        print(f"  FAILED: off by {error:.2g}, more than {bound:.2g}")
    return error <= bound


def check_layers(options):
    """Moduli of beams in the plane and in bending, by their energies. Where shear does
    not count."""
    length, height, width = 60, 1.5, 1
    along, across = 1000, 50
    fibres, turned = "1, 0, 0, 0, 1, 0", "0, 1, 0, -1, 0, 0"
    results = []
    for name, axes, outer, inner in (
            ("0/90/0", f"{fibres}; core : {turned}", along, across),
            ("90/0/90", f"{turned}; core : {fibres}", across, along)):
        def energy(*settings, axes=axes):
            *_, state = run(options, "plywood", f"Material/Axes={axes}",
                            "Material/Shear moduli=1000, 1000, 1000", *settings)
            return float(state["strain_energy"])
        pulled = energy("Support/Displacements=right : 0.6, 0, 0")
        in_plane = 2 * pulled / (height * width * length * (.6 / length)**2)
        results.append(check(f"{name}, in the plane", in_plane,
                             (2 * outer + inner) / 3, 1e-8))
        force = 1e-3
        bent = energy(f"Load/Tractions=right : 0, 0, {force / (height * width)!r}")
        bending = force**2 * length**3 / (6 * bent) * 12 / (width * height**3)
        results.append(check(f"{name}, in bending", bending,
                             (26 * outer + inner) / 27, 5e-3))
    return results


def required(options, scene, *settings):
    """Of a scene's first row."""
    lines = run(options, scene, *settings)
    return next(float(line["required_stress"]) for line in lines
                if line["event"] == "deform")


def check_directions(options):
    """The normal of the first scene's cut is y, of the others' x and y; their blades have
    a sharpness of 0, 0.5 and 0.5."""
    limits = (8, 2, 1)
    angle = math.radians(30)
    c, s = math.cos(angle), math.sin(angle)
    turned = f"Material/Axes={c!r}, {s!r}, 0, {-s!r}, {c!r}, 0"
    results = []
    for scene, value, normal, part in (
            ("double_cantilever", "Toughness", 1, 1), ("plane_strain", "Shear limit", 0, .5),
            ("mean_shear", "Shear limit", 1, .5)):
        by_axis = f"Material/{value} by axis=8, 2, 1"
        results += [
            check(f"{scene}, along an axis", required(options, scene, by_axis),
                  part * limits[normal], 1e-9),
            check(f"{scene}, at an angle", required(options, scene, by_axis, turned),
                  part * (limits[normal] * c * c + limits[1 - normal] * s * s), 1e-9)]
    return results


def main():
    parser = program.parser(__doc__)
    parser.add_argument("--scenes", required=True)
    parser.add_argument("--part", required=True,
                        choices=("isotropic", "layers", "directions"))
    options = parser.parse_args()
    results = {"isotropic": check_isotropic, "layers": check_layers,
               "directions": check_directions}[options.part](options)
    if not all(results):
        sys.exit("FAILED")


if __name__ == "__main__":
    main()
