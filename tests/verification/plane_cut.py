# SPDX-License-Identifier: LGPL-2.1-or-later
"""The cut of a block in plane strain by a blade that travels, and its energies."""

from problems import Row, material, run_table

PLANE = {"Dimension": 2, **material(1, .3), "Support/Fixed faces": "bottom",
         "Blade/Drive": "travel", "Blade/Sharpness": 0,
         "Yield/Criterion": "energy release", "Division/Release": "element row"}


class Cut:
    """The part of a cut between two depths, from yield to yield."""

    def __init__(self, options, n_across, n_along, size, settings, depths):
        self.lines = run_table(options, {
            **PLANE, "Body/Size": f"{size[0]}, {size[1]}",
            "Body/Elements": f"{n_across}, {n_along}",
            "Cut/Surfaces": f"x:{n_across // 2}", **settings})
        self.toughness = settings["Material/Toughness"]
        self.yields = [line for line in self.lines if line["event"] == "deform"]
        self.begin, self.end = (
            next(line for line in self.yields if number(line, "depth") > depth - 1e-9)
            for depth in depths)

    def change(self, column):
        return number(self.end, column) - number(self.begin, column)

    def mean_force(self):
        """Over the toughness."""
        return self.change("work") / self.change("travel") / self.toughness

    def new_surface(self):
        """What is left of the work for new surface."""
        return self.change("work") - sum(map(self.change, (
            "strain_energy", "friction_energy", "excess_energy")))

    def largest_imbalance(self):
        """Of the energies, over the whole work."""
        return max(abs(number(line, "work") - sum(number(line, column) for column in (
            "strain_energy", "surface_energy", "friction_energy", "excess_energy")))
            for line in self.lines) / number(self.lines[-3], "work")


def number(line, column):
    return float(line[column])


def block(options, n, settings):
    """The square block of side 1, clamped at its bottom."""
    return Cut(options, n, n, (1, 1), settings, (.25, .75))


def energies(cut, mesh, bound=1e-8):
    """What must be so whatever the mesh is."""
    yield Row("work left for surface over toughness × area", mesh,
              cut.toughness * cut.change("depth"), cut.new_surface(), bound)
    yield Row("1 + energy that is missing over work", mesh, 1,
              1 + cut.largest_imbalance(), bound)
