#!/usr/bin/env python3
# SPDX-License-Identifier: LGPL-2.1-or-later
"""Parameters at their extremes: what the program answers is right, by a scaling law
or a closed form, or it is a refusal in one sentence. Never a number that is none,
never a wrong one without a word.

usage: extremes.py PROGRAM [--long]

"""

import csv
import math
import pathlib
import subprocess
import sys
import tempfile

import distortion
import large_strain
from two_bars import TWO_BARS

PROGRAM = None
TIME_LIMIT = 300
CUBE = {
    "Body/Elements": "2,2,2", "Support/Fixed faces": "bottom", "Cut/Surfaces": "y:1",
    "Blade/Edge loads": "0:10, 5:50, 10:10", "Blade/Sharpness": "0.5",
    "Blade/Thickness": "0.2", "Blade/Direction": "0,0,-1", "Material/Young's modulus": "5",
    "Material/Poisson's ratio": "0.2", "Material/Shear limit": "1", "Yield/Check": "once",
    "Output/Frames": "none", "Output/Node tables": "true",
}
# A block that a traction pulls without holding it sideways: the stress is uniform.
BLOCK = {
    "Body/Elements": "2,2,2", "Support/Fixed components": "left : x; front : y; bottom : z",
    "Load/Tractions": "top : 0, 0, 1", "Output/Frames": "none", "Output/Node tables": "true",
}


class Run:
    """A run of a scene that is given as settings."""

    def __init__(self, settings, dimension=3, directory=None, limit=TIME_LIMIT):
        self.directory = tempfile.TemporaryDirectory() if directory is None else directory
        path = pathlib.Path(self.directory.name)
        lines = [f"set Dimension = {dimension}"]
        for name, value in settings.items():
            *subsections, last = name.split("/")
            lines += [f"subsection {s}" for s in subsections]
            lines += [f"set {last} = {value}"] + ["end"] * len(subsections)
        (path / "scene.prm").write_text("\n".join(lines) + "\n")
        result = subprocess.run([PROGRAM, str(path / "scene.prm"), "--output",
                                 str(path / "out")], capture_output=True, text=True,
                                timeout=limit)
        self.status, self.errors, self.output = (result.returncode, result.stderr.strip(),
                                                 result.stdout)
        self.events = self.read("statistics.csv")
        numbers = [v for e in self.events for k, v in e.items()
                   if k not in ("event", "row_pieces")]
        if any(not math.isfinite(float(v)) for v in numbers):
            raise AssertionError("statistics.csv has a value that is no number")

    def read(self, name):
        path = pathlib.Path(self.directory.name) / "out" / name
        if not path.exists():
            return []
        with open(path, newline="") as table:
            return list(csv.DictReader(table))

    def displacements(self, frame):
        """By node and side, with positions."""
        return {(n["number"], n["side"]): [float(n[c]) for c in ("x", "y", "z", "ux", "uy", "uz")]
                for n in self.read(f"nodes_{frame:04d}.csv")}


def refusal(run):
    """The sentence with which a run was refused; it must be one, and honest."""
    if run.status != 1 or not run.errors.startswith("setsudan: ") or "\n" in run.errors:
        raise AssertionError(f"status {run.status}, '{run.errors[:200]}'")
    return "refused: " + run.errors[len("setsudan: "):].split(": ", 1)[-1]


def accepted(run):
    if run.status != 0:
        raise AssertionError(f"status {run.status}: {run.errors[:300]}")
    return run


def all_displacements(run):
    """Of all solved states: by state, node and side."""
    return {(frame,) + key: node[3:] for frame in range(1, int(run.events[-1]["frame"]) + 1)
            for key, node in run.displacements(frame).items()}


def largest_of(displacements):
    return max(abs(v) for u in displacements.values() for v in u)


def difference(run, reference, scale=1.0):
    """Largest difference of all states' displacements to `scale` times those of
    another run on the same mesh, relative to the largest."""
    mine, other = all_displacements(accepted(run)), all_displacements(reference)
    if mine.keys() != other.keys():
        raise AssertionError("other states or nodes")
    return max(abs(a - scale * b) for key, u in other.items()
               for a, b in zip(mine[key], u)) / (scale * largest_of(other))


class Table:
    """The cases that were tried; each line says what was expected and measured."""

    def __init__(self):
        self.lines, self.failures = [], 0

    def add(self, group, case, against, measured, bound=None):
        try:
            value = measured()
        except (AssertionError, subprocess.TimeoutExpired) as error:
            self.failures += 1
            value, failed = str(error), True
        else:
            failed = bound is not None and not value <= bound
            self.failures += failed
        text = value if isinstance(value, str) else (
            f"{value:.0e} (allowed {bound:.0e})" if failed else
            f"below {bound:.0e}" if bound > 0 else "so it is")
        self.lines.append((group, case, against, text + (" FAILED" if failed else "")))

    def print(self):
        print("| parameter | value | against | result |\n|---|---|---|---|")
        for line in self.lines:
            print("| " + " | ".join(cell.replace("|", "/") for cell in line) + " |")


def scaled_cube(stiffness=1.0, length=1.0, **more):
    """The cube in other units: stresses times `stiffness`, lengths times `length`."""
    force = stiffness * length**2
    settings = dict(CUBE)
    settings["Material/Young's modulus"] = repr(5 * stiffness)
    settings["Material/Shear limit"] = repr(1 * stiffness)
    settings["Body/Size"] = ", ".join([repr(10 * length)] * 3)
    settings["Blade/Thickness"] = repr(0.2 * length)
    settings["Blade/Edge loads"] = ", ".join(
        f"{s * length!r}:{f * force!r}" for s, f in ((0, 10), (5, 50), (10, 10)))
    settings.update(more)
    return settings


def block_error(E, nu, size=(10.0, 10.0, 10.0), traction=1.0, **more):
    """A uniform stress: u_z = t z / E, u_x = - nu t x / E."""
    settings = dict(BLOCK)
    settings.update({"Material/Young's modulus": repr(E), "Material/Poisson's ratio": repr(nu),
                     "Body/Size": ", ".join(map(repr, size)),
                     "Load/Tractions": f"top : 0, 0, {traction!r}"})
    settings.update(more)
    run = accepted(Run(settings))
    strain = traction / E
    worst = 0.0
    for x, y, z, ux, uy, uz in run.displacements(1).values():
        for u, exact, most in ((ux, -nu * strain * x, strain * size[0]),
                               (uy, -nu * strain * y, strain * size[1]),
                               (uz, strain * z, strain * size[2])):
            worst = max(worst, abs(u - exact) / most)
    return worst


def stiffness_cases(table, base):
    for E in (1e-9, 1e-3, 1e6, 1e12):
        table.add("Young's modulus", f"{E:g}", "the cube, stresses in another unit",
                  lambda: difference(Run(scaled_cube(stiffness=E / 5)), base), 1e-9)
    for length, name in ((1e-7, "10 nm"), (1e5, "10 km"), (1e-2, "SI instead of cm")):
        table.add("size", name, "the cube, lengths in another unit",
                  lambda: difference(Run(scaled_cube(length=length)), base, length), 1e-9)
    table.add("units", "cm, gf to m, N", "the cube",
              lambda: difference(Run(scaled_cube(98.0665, 0.01)), base, 0.01), 1e-9)
    for nu in (-0.99, -0.5, 0.0, 0.45, 0.49, 0.499, 0.4999, 0.49999, 0.4999999):
        table.add("Poisson's ratio", f"{nu}", "uniform stress, closed form",
                  lambda: block_error(5.0, nu), 1e-7)
    for nu in ("0.5", "-1"):
        table.add("Poisson's ratio", nu, "refusal",
                  lambda: refusal(Run({**CUBE, "Material/Poisson's ratio": nu})))


def shape_cases(table):
    for ratio in (1e2, 1e4):
        for size in ((10.0, 10.0, 10.0 / ratio), (10.0 / ratio, 10.0, 10.0)):
            table.add("aspect ratio", f"{ratio:g}, " + " x ".join(f"{s:g}" for s in size),
                      "uniform stress, closed form", lambda: block_error(5.0, 0.3, size), 1e-7)
    table.add("elements", "1 x 1 x 1", "uniform stress, closed form",
              lambda: block_error(5.0, 0.3, **{"Body/Elements": "1,1,1"}), 1e-10)
    table.add("elements", "1 x 1 x 1000, a rod of 1 x 1 x 1000", "uniform stress, closed form",
              lambda: block_error(5.0, 0.3, (1.0, 1.0, 1000.0), **{"Body/Elements": "1,1,1000"}),
              1e-7)
    table.add("elements", "30 x 30 x 1, a slice", "uniform stress, closed form",
              lambda: block_error(5.0, 0.3, (10.0, 10.0, 0.01),
                                  **{"Body/Elements": "30,30,1"}), 1e-7)


def rod_cases(table):
    """Rods that are cut, lengthwise and across, of one element across each half."""
    rod = {"Body/Size": "1, 1, 1000", "Body/Elements": "2, 1, 1000",
           "Support/Fixed faces": "bottom, top", "Blade/Sharpness": "1",
           "Blade/Thickness": "0.001", "Blade/Direction": "0, 0, -1",
           "Blade/Edge loads": "0.5 : 1e-4", "Output/Frames": "none",
           "Solver/Method": "direct"}
    table.add("elements", "a rod of 2 x 1 x 1000, cut lengthwise 5 deep", "it goes through",
              lambda: float(accepted(Run({**rod, "Support/Fixed faces": "bottom",
                                          "Cut/Surfaces": "x:1", "Cut/Extent": "depth : 5"}))
                            .events[-1]["event"] != "divide"), 0)
    for length in ("100", "1000"):
        table.add("elements", f"a rod of 2 x 1 x 1000, {length} long and 1 wide, cut across",
                  "two pieces", lambda: float(
                      accepted(Run({**rod, "Body/Size": f"1, 1, {length}",
                                    "Cut/Surfaces": "z:500", "Blade/Direction": "1, 0, 0"}))
                      .events[-1]["pieces"] != "2"), 0)


def blade_cases(table, base):
    def thickness_law(value):
        a, b, c = (all_displacements(r) for r in (
            accepted(Run({**CUBE, "Blade/Thickness": "0"})), base,
            accepted(Run({**CUBE, "Blade/Thickness": repr(value)}))))
        return max(abs(u0 + (u1 - u0) * value / 0.2 - u) for key in a
                   for u0, u1, u in zip(a[key], b[key], c[key])) / largest_of(c)

    for thickness in (0.0, 1e-12, 5.0):
        table.add("Blade/Thickness", f"{thickness:g}", "linear in the thickness",
                  lambda: thickness_law(thickness), 1e-9)
    sharp = {**CUBE, "Blade/Sharpness": "1", "Yield/Check": "every row",
             "Blade/Edge loads": "5:0"}
    table.add("Blade/Sharpness", "1, without a load", "every row yields",
              lambda: float(accepted(Run(sharp)).events[-1]["event"] != "divide"), 0)
    table.add("Blade/Sharpness", "0, without a load", "arrested at the first row",
              lambda: float(accepted(Run({**sharp, "Blade/Sharpness": "0"}))
                            .events[-1]["event"] != "arrest"), 0)
    for limit, last in (("1e-300", "divide"), ("1e300", "arrest")):
        for control in ("constant", "ramp"):
            table.add("Shear limit", f"{limit}, {control}", last,
                      lambda: float(accepted(Run({**CUBE, "Material/Shear limit": limit,
                                                  "Division/Load control": control}))
                                    .events[-1]["event"] != last), 0)
    table.add("load", "1e-300", "the cube, forces in another unit", lambda: difference(
        Run({**CUBE, "Blade/Edge loads": "0:1e-299, 5:5e-299, 10:1e-299",
             "Blade/Thickness": "0", "Material/Shear limit": "1e-300"}),
        accepted(Run({**CUBE, "Blade/Thickness": "0"})), 1e-300), 1e-9)
    table.add("load", "1e300", "refusal",
              lambda: refusal(Run({**CUBE, "Blade/Edge loads": "5:1e300"})))


def contrast_cases(table):
    """Two bars one behind the other: the soft one takes the whole strain."""
    def error(contrast, must_warn=False):
        directory = tempfile.TemporaryDirectory()
        (pathlib.Path(directory.name) / "bars.geo").write_text(TWO_BARS)
        run = accepted(Run({
            "Body/Shape": "file", "Body/File": "bars.geo",
            "Material/Young's modulus": f"hard : {5 * contrast!r}; soft : 5",
            "Material/Poisson's ratio": "0", "Support/Fixed components": "bottom : xyz",
            "Load/Tractions": "top : 0, 0, 1", "Output/Frames": "none",
            "Output/Node tables": "true"}, directory=directory))
        nodes = run.displacements(1).values()
        if must_warn and "digits are lost" not in run.output:
            raise AssertionError("no word of lost digits")
        return max(abs(uz - (min(z, 1) / (5 * contrast) + max(z - 1, 0) / 5)) / (1 / 5)
                   for x, y, z, ux, uy, uz in nodes)

    for contrast in (1e3, 1e6, 1e9):
        table.add("two materials", f"contrast {contrast:g}", "bars in a row, closed form",
                  lambda: error(contrast), 1e-7)
    # The hard bar moves as a whole, far more than it is strained.
    table.add("two materials", "contrast 1e-09, the hard bar on the soft one",
              "bars in a row, closed form, with a warning of lost digits",
              lambda: error(1e-9, must_warn=True) * 1e-9, 1e-4)


def symmetry_cases(table):
    """The scene turned and mirrored gives turned and mirrored displacements."""
    settings = {**CUBE, "Body/Elements": "2,2,3", "Body/Size": "8, 9, 10",
                "Blade/Edge loads": "0:10, 3:40", "Material/Poisson's ratio": "0.3",
                "Load/Body force": "0.01, 0.02, -0.03"}

    def compare(other_settings, map_back):
        one, other = accepted(Run(settings)), accepted(Run(other_settings))
        worst, largest = 0.0, largest_of(all_displacements(one))
        for frame in range(1, int(one.events[-1]["frame"]) + 1):
            at = {}
            for (number, side), node in other.displacements(frame).items():
                x, u, flips = map_back(node[:3], node[3:])
                side = side.translate(str.maketrans("+-", "-+")) if flips else side
                at[tuple(round(v, 6) + 0.0 for v in x) + (side,)] = u
            for (number, side), node in one.displacements(frame).items():
                u = at[tuple(round(v, 6) + 0.0 for v in node[:3]) + (side,)]
                worst = max(worst, max(abs(p - q) for p, q in zip(u, node[3:])) / largest)
        return worst

    # x, y to y, -x + 9: a quarter turn about z.
    turned = {**settings, "Body/Elements": "2,2,3", "Body/Size": "9, 8, 10",
              "Cut/Surfaces": "x:1", "Blade/Edge loads": "0:10, 3:40",
              "Load/Body force": "-0.02, 0.01, -0.03"}
    table.add("the scene", "turned by 90 degrees", "the scene as it was", lambda: compare(
        turned, lambda x, u: ((x[1], 9 - x[0], x[2]), (u[1], -u[0], u[2]), True)), 1e-9)
    mirrored = {**settings, "Blade/Edge loads": "8:10, 5:40",
                "Load/Body force": "-0.01, 0.02, -0.03"}
    table.add("the scene", "mirrored", "the scene as it was", lambda: compare(
        mirrored, lambda x, u: ((8 - x[0], x[1], x[2]), (-u[0], u[1], u[2]), False)), 1e-9)


def rows_case(table, n_rows):
    """A strip of so many rows, two for each layer of elements."""
    n = n_rows // 2
    table.add("rows", f"{n_rows} rows, 2D", "two pieces in the end", lambda: float(
        accepted(Run({"Body/Size": f"50, {n}", "Body/Elements": f"2, {n}",
                      "Support/Fixed faces": "bottom", "Cut/Surfaces": "x:1",
                      "Blade/Sharpness": "1", "Blade/Direction": "0,-1",
                      "Blade/Edge loads": "0:0", "Output/Frames": "none"}, dimension=2,
                     limit=5 * n_rows))
        .events[-1]["pieces"] != "2"), 0)


def main():
    global PROGRAM
    PROGRAM = sys.argv[1]
    table = Table()
    base = accepted(Run(CUBE))
    stiffness_cases(table, base)
    shape_cases(table)
    distortion.cases(table, Run, accepted, refusal, tempfile.TemporaryDirectory)
    rod_cases(table)
    blade_cases(table, base)
    contrast_cases(table)
    symmetry_cases(table)
    large_strain.cases(table, lambda *settings, **more: accepted(Run(*settings, **more)),
                 tempfile.TemporaryDirectory)
    rows_case(table, 500)
    if "--long" in sys.argv[2:]:
        rows_case(table, 2000)
    table.print()
    if table.failures:
        sys.exit(f"{table.failures} cases failed")


main()
