#!/usr/bin/env python3
# SPDX-License-Identifier: LGPL-2.1-or-later
"""Bodies in time: a strip of a standard linear solid that is clamped, or loaded, against
its closed forms; a bar that flows under a load that comes and goes; and a blade that is
so fast, or so slow, that a viscous body is elastic.
"""

import math
import pathlib
import sys
import tempfile

import program
import tables

NU, TAU = 0.3, 0.5
TIMES = [0, 0.1, 0.25, 0.5, 1, 2, 5]
LOADED = ("Support/Displacements=", "Load/Tractions=right : 0.1, 0")
# Of viscous_wedge.prm.
WEDGE_E, WEDGE_NU, LASTING_SHEAR = 20, 0.4, 0.5
BAR = """\
subsection Body
  set Size     = 1, 1, 1
  set Elements = 1, 1, 1
end
subsection Material
  set Young's modulus = 5
  set Yield stress    = 0.5
  set Hardening       = 0.4, 0
end
subsection Deformation
  set Strain = finite
end
subsection Support
  set Fixed components = left : x; front : y; bottom : z
  set Displacements    = right : 0.5, free, free
end
subsection Time
  set Steps       = 1 : 20; 1 : 5
  set Load factor = 0 : 0; 1 : 1; 2 : 0.9
end
"""


def run(options, scene, *settings):
    """The table of a run."""
    with tempfile.TemporaryDirectory() as directory:
        program.run(options, scene, directory, (*program.QUIET, *settings))
        return tables.read(pathlib.Path(directory) / "statistics.csv")


def check(name, error, bound):
    """Whether an error is small enough."""
    if error <= bound:
        print(f"{name}: below {bound:.2g}")
        return True
    print(f"{name}: FAILED, {error:.3g} exceeds {bound:.2g}")
    return False


def check_relaxation(options):
    lines = run(options, options.scenes / "viscous_clamp.prm")[1:]
    error = energy = 0
    for time, line in zip(TIMES, lines, strict=True):
        modulus = 1 + 2 * math.exp(-time / TAU)
        force = 0.1 * modulus / (1 - NU**2)
        error = max(error, abs(float(line["clamp_x"]) / force - 1))
        total = float(line["strain_energy"]) + float(line["viscous_energy"])
        energy = max(energy, abs(total / (0.05 * 0.3 / (1 - NU**2)) - 1))
    return [check("relaxation of a strip", error, 1e-10),
            check("  energy is kept or heat", energy, 1e-10)]


def creep(time):
    """The elongation of the strip under its load."""
    return 0.1 * (1 - NU**2) * (1 - 2 / 3 * math.exp(-time / (3 * TAU)))


def check_creep(options):
    """With steps that are chosen, and with given ones that are halved."""
    results, errors = [], []
    for settings in (("Time/Tolerance=1e-5",), ("Time/Steps=5 : 20",),
                     ("Time/Steps=5 : 40",)):
        lines = run(options, options.scenes / "viscous_clamp.prm", *LOADED, *settings)
        first = float(lines[1]["max_displacement"])
        errors.append(max(abs(float(line["max_displacement"]) / first * creep(0) /
                              creep(float(line["time"])) - 1) for line in lines[1:]))
    results.append(check("creep with Time/Tolerance", errors[0], 2e-4))
    print(f"creep, error with steps of half the length: {errors[2] / errors[1]:.2f} of it")
    return results + [check("  more than a third", errors[2] / errors[1], 1 / 3)]


def check_bar(options):
    """Stretched beyond its limit, and a little back."""
    with tempfile.TemporaryDirectory() as directory:
        scene = pathlib.Path(directory) / "bar.prm"
        scene.write_text(BAR)
        lines = run(options, scene)[2:]
    young, limit, hardening = 5, 0.5, 0.4
    slope = young * hardening / (young + hardening)
    largest = limit + slope * (math.log(1.5) - limit / young)
    error = 0
    for line in lines:
        time = float(line["time"])
        stretch = 1 + 0.5 * (time if time <= 1 else 1 - (time - 1) / 10)
        strain = math.log(stretch)
        if time > 1:
            stress = largest - young * (math.log(1.5) - strain)
        else:
            stress = min(young * strain, limit + slope * (strain - limit / young))
        error = max(error, abs(float(line["clamp_x"]) * stretch / stress - 1))
    return [check("bar that flows under finite strain", error, 1e-7)]


def check_speeds(options):
    """First split and mean force at extreme speeds."""
    shear = WEDGE_E / (2 * (1 + WEDGE_NU)) * LASTING_SHEAR
    bulk = WEDGE_E / (3 * (1 - 2 * WEDGE_NU))
    slow = [9 * bulk * shear / (3 * bulk + shear),
            (3 * bulk - 2 * shear) / (6 * bulk + 2 * shear)]
    results = []
    for name, speed, (young, nu) in (("fast", "1e6", (WEDGE_E, WEDGE_NU)),
                                     ("slow", "1e-6", slow)):
        mixed = ("Material/Formulation=displacement", "Blade/Travel=7")
        elastic, viscous = (
            run(options, options.scenes / "viscous_wedge.prm", *mixed, *settings)
            for settings in ((f"Material/Young's modulus={young!r}",
                              f"Material/Poisson's ratio={nu!r}", "Material/Viscous="),
                             (f"Blade/Speed={speed}",)))
        first = [next(float(line["travel"]) for line in lines
                      if line["event"] == "yield") for lines in (elastic, viscous)]
        work = [float(lines[-1]["work"]) for lines in (elastic, viscous)]
        results += [check(f"{name} blade: first split", abs(first[1] / first[0] - 1), 1e-3),
                    check("  work", abs(work[1] / work[0] - 1), 0.01)]
    return results


def main():
    parser = program.parser(__doc__)
    parser.add_argument("--scenes", type=pathlib.Path, required=True)
    options = parser.parse_args()
    results = [result for group in (check_relaxation, check_creep, check_bar, check_speeds)
               for result in group(options)]
    sys.exit(0 if all(results) else 1)


if __name__ == "__main__":
    main()
