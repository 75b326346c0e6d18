# SPDX-License-Identifier: LGPL-2.1-or-later
"""Extremes of finite strain: closed forms of bars and columns, and bodies that have no
stable state, which must be said."""

import math
import pathlib
import re

from two_bars import TWO_BARS

E = 5.0
BAR = {
    "Body/Size": "10, 10, 10", "Deformation/Strain": "finite",
    "Support/Fixed components": "left : x; front : y; bottom : z",
    "Material/Young's modulus": repr(E), "Output/Frames": "none",
    "Output/Node tables": "true",
}
# Nothing moves across the direction in which the bar is pressed.
CHANNEL = "left : x; right : x; front : y; back : y; bottom : z"
OGDEN = ((.63, 1.3), (.0012, 5.0), (-.01, -2.0))


def root(function, low, high):
    """Of a function that grows."""
    for _ in range(200):
        middle = (low + high) / 2
        low, high = (low, middle) if function(middle) > 0 else (middle, high)
    return (low + high) / 2


def lateral_stretch(stretch, ratio, law):
    """Of a bar whose sides are free."""
    mu, lam = E / 2 / (1 + ratio), E * ratio / (1 + ratio) / (1 - 2 * ratio)
    kappa = lam + 2 * mu / 3

    def across(t):
        J = stretch * t * t
        if law == "neo-Hooke":
            return mu * (t * t - 1) + lam / 2 * (J * J - 1)
        if law == "linear elastic":
            return (lam * ((stretch**2 - 1) / 2 + t * t - 1) + mu * (t * t - 1))
        terms = OGDEN if law == "Ogden" else ((1.0, 2.0),)
        scale = mu / sum(m * a / 2 for m, a in terms)
        along, side = stretch * J ** (-1 / 3), t * J ** (-1 / 3)
        return sum(scale * m * (side**a - along**a) / 3 for m, a in terms) + (
            kappa / 2 * (J * J - 1))

    return root(across, 1e-3, 1e3)


def bar_error(run, stretch, ratio, law, **more):
    """Of the displacements of a bar that is pulled to a length, relative to the size of
    the body."""
    result = run({**BAR, "Material/Poisson's ratio": repr(ratio), "Material/Law": law,
                  "Support/Displacements": f"top : free, free, {10 * (stretch - 1)!r}",
                  "Material/Ogden terms": "; ".join(f"{m} : {a}" for m, a in OGDEN),
                  **more})
    if result.events[-1]["event"] == "arrest":
        raise AssertionError(arrest_of(result))
    side = lateral_stretch(stretch, ratio, law)
    return max(abs(u - (factor - 1) * x) / 10 for node in result.displacements(1).values()
               for x, u, factor in zip(node[:3], node[3:], (side, side, stretch)))


def arrest_of(result):
    """The sentence with which a run was arrested."""
    found = re.search(r"^Arrest: (.*)$", result.output, re.M)
    if result.events[-1]["event"] != "arrest" or not found:
        raise AssertionError(f"not arrested: {result.output[-300:]}")
    return found[1]


def part_of(sentence):
    return float(re.search(r"beyond (\S+) of the way", sentence)[1])


def bar_cases(table, run):
    for ratio, law in ((-.5, "isochoric neo-Hooke"), (0.0, "neo-Hooke"), (.3, "neo-Hooke"),
                       (.49, "isochoric neo-Hooke"), (.4999, "isochoric neo-Hooke"),
                       (.4999999, "isochoric neo-Hooke"), (.4999999, "Ogden")):
        table.add("finite strain: Poisson's ratio", f"{ratio}, {law}, to twice the length",
                  "a bar, closed form", lambda: bar_error(run, 2.0, ratio, law), 1e-7)
    for stretch in (.5, .7, 1.5, 3.0, 5.0):
        for ratio, law in ((.3, "neo-Hooke"), (.4999999, "isochoric neo-Hooke")):
            if stretch == .5 and ratio > .45:
                continue
            table.add("finite strain: stretch", f"{stretch:g}, {law}, Poisson's ratio {ratio}",
                      "a bar, closed form", lambda: bar_error(run, stretch, ratio, law), 1e-7)

    def in_channel(stretch):
        result = run({**BAR, "Support/Fixed components": CHANNEL,
                      "Material/Poisson's ratio": "0.3",
                      "Support/Displacements": f"top : free, free, {10 * (stretch - 1)!r}"})
        return max(abs(node[5] - (stretch - 1) * node[2]) / 10 + abs(node[3]) + abs(node[4])
                   for node in result.displacements(1).values())

    table.add("finite strain: stretch", "0.1, neo-Hooke, held at its sides",
              "a uniform strain", lambda: in_channel(.1), 1e-7)

    def gives_way(ratio, longer):
        sentence = arrest_of(run({
            **BAR, "Material/Poisson's ratio": repr(ratio),
            "Support/Displacements": f"top : free, free, {longer}"}))
        if "gives way along" not in sentence:
            raise AssertionError(sentence)
        stretch = 1 + longer / 10 * part_of(sentence)
        return f"arrested at a stretch of {stretch:.1f}, and said to give way"

    for ratio, law in ((.3, "neo-Hooke"), (.49, "isochoric neo-Hooke, mixed")):
        table.add("finite strain: stretch",
                  f"0.1, {law}, Poisson's ratio {ratio}, its sides free",
                  "an arrest, no state that is not stable", lambda: gives_way(ratio, -9))

    # Lambda is negative, and the energy of the volume not convex.
    table.add("finite strain: Poisson's ratio", "-0.5, neo-Hooke, to twice the length",
              "an arrest, no state that is not stable", lambda: gives_way(-.5, 10))


def column_cases(table, run):
    """Euler's load, of a column that is clamped at its foot."""
    def difference(slenderness):
        load = math.pi**2 * E / 48 / slenderness**2
        result = run({**BAR, "Body/Size": f"1, 1, {slenderness}", "Body/Elements": "1, 1, 20",
                      "Support/Fixed components": "", "Support/Fixed faces": "bottom",
                      "Material/Poisson's ratio": "0", "Blade/Edge loads": "",
                      "Load/Tractions": f"top : 0, 0, {-2 * load!r}"})
        sentence = arrest_of(result)
        if "gives way" not in sentence:
            raise AssertionError(sentence)
        return abs(2 * part_of(sentence) - 1)

    for slenderness in (10, 100, 1000):
        table.add("finite strain: slender columns",
                  f"{slenderness} times as long as wide, under twice Euler's load",
                  "arrested at Euler's load, and said to give way",
                  lambda: difference(slenderness), 2e-2)


def contrast_cases(table, run, directory_of):
    """A hard bar of the law of St. Venant and Kirchhoff below a soft one of neo-Hooke."""
    def error(contrast):
        directory = directory_of()
        (pathlib.Path(directory.name) / "bars.geo").write_text(TWO_BARS)
        traction = 5.0
        result = run({
            "Body/Shape": "file", "Body/File": "bars.geo", "Deformation/Strain": "finite",
            "Material/Young's modulus": f"hard : {E * contrast!r}; soft : {E!r}",
            "Material/Law": "hard : linear elastic; soft : neo-Hooke",
            "Material/Poisson's ratio": "0", "Support/Fixed components": "bottom : xyz",
            "Load/Tractions": f"top : 0, 0, {traction!r}", "Output/Frames": "none",
            "Output/Node tables": "true"}, directory=directory)
        hard = root(lambda s: contrast * E * s * (s * s - 1) / 2 - traction, 1, 10) - 1
        soft = root(lambda s: E / 2 * (s - 1 / s) - traction, 1, 10) - 1
        return max(abs(node[5] - hard * min(node[2], 1) - soft * max(node[2] - 1, 0))
                   for node in result.displacements(1).values())

    for contrast in (1e3, 1e6):
        table.add("finite strain: two laws", f"contrast {contrast:g}",
                  "bars in a row, closed form", lambda: error(contrast), 1e-7)


def ellipticity_cases(table, run):
    """The law of St. Venant and Kirchhoff loses ellipticity under compression: with
    Poisson's ratio .3 and held sides at a stretch of .7056 in bands at 45 degrees."""
    def arrested(shortening):
        sentence = arrest_of(run({
            **BAR, "Support/Fixed components": CHANNEL, "Material/Poisson's ratio": "0.3",
            "Material/Law": "linear elastic",
            "Support/Displacements": f"top : free, free, {-shortening!r}"}))
        if "the law linear elastic" not in sentence or "resistance" not in sentence:
            raise AssertionError(sentence)
        return abs(1 - part_of(sentence) * shortening / 10 - .7056)

    for shortening in (4.0, 9.0):
        table.add("finite strain: linear elastic",
                  f"pressed to a stretch of {1 - shortening / 10:.1g}, held at its sides",
                  "arrested where ellipticity is lost, and the law is named",
                  lambda: arrested(shortening), 1e-2)


def cases(table, run, directory_of):
    bar_cases(table, run)
    column_cases(table, run)
    contrast_cases(table, run, directory_of)
    ellipticity_cases(table, run)
