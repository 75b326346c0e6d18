# SPDX-License-Identifier: LGPL-2.1-or-later
"""Parameters of a scene that are fitted: on logarithms where they are positive."""

import math
from dataclasses import dataclass

from program import Refusal

RANGE = 100.  # from the scene's value, where no bounds are given
STEP = 0.03  # of a logarithm, or of the range between the bounds
# Forces, and forces per length or area. In a linear body under a blade that travels all
# forces are multiplied with what all of these are.
OF_FORCE = ("Material/Young's modulus", "Material/Toughness", "Material/Shear limit",
            "Blade/Adhesion")


@dataclass
class Parameter:
    name: str
    start: float
    low: float
    high: float

    @property
    def is_log(self):
        return self.low > 0

    def inward(self, value):
        """What the fit works with."""
        return math.log(value) if self.is_log else value

    def outward(self, x):
        return math.exp(x) if self.is_log else x

    @property
    def step(self):
        """The change of x over which slopes are taken."""
        return STEP * (1 if self.is_log else self.high - self.low)


def free_parameters(names, bounds, parameters):
    """Those that are named, with the scene's values to start from.

    @param bounds: texts 'NAME=low,high'.
    @param parameters: all of the scene, as texts. Raises Refusal."""
    given = dict(read_bounds(text) for text in bounds)
    for name in given:
        if name not in names:
            raise Refusal(f"bounds are given for '{name}', which is not free")
    free = []
    for i, name in enumerate(names):
        if name in names[:i]:
            raise Refusal(f"'{name}' is free twice")
        if name not in parameters:
            raise Refusal(f"the scene has no parameter '{name}'")
        free.append(Parameter(name, *numbers_of(name, parameters[name], given.get(name))))
    return free


def read_bounds(text):
    name, _, values = text.rpartition("=")
    try:
        low, high = map(float, values.split(","))
    except ValueError:
        low = high = math.nan
    if not name or not low < high or math.isinf(high - low):
        raise Refusal(f"the bounds '{text}' are not of the form 'NAME=low,high'")
    return name.strip(), (low, high)


def numbers_of(name, text, bounds):
    """The start and the bounds."""
    try:
        start = float(text)
    except ValueError as error:
        raise Refusal(f"{name} of the scene is '{text}', which is not a number") from error
    if not bounds and start <= 0:
        raise Refusal(f"{name} of the scene is {text}: without --bounds '{name}=low,high' "
                      "a parameter must be positive")
    low, high = bounds or (start / RANGE, start * RANGE)
    if not low < start < high:
        raise Refusal(f"{name} of the scene, {text}, is not between its bounds "
                      f"{low:g} and {high:g}")
    return start, low, high


def follows_from_scale(free, parameters):
    """Whether the slope for Young's modulus follows from those for the other free
    parameters: all forces of a linear body are multiplied with what its moduli, limits
    and toughness are, F(s E, s R) = s F(E, R)."""
    names = [parameter.name for parameter in free]
    others = [name for name in OF_FORCE if name not in names]
    return (parameters["Deformation/Strain"] == "small" and OF_FORCE[0] in names
            and all(parameter.is_log for parameter in free if parameter.name in OF_FORCE)
            and strength(parameters) in names
            and is_zero(parameters["Material/Yield stress"])
            and all(is_zero(parameters[name]) or not takes_part(name, parameters)
                    for name in others)
            and not any(value for name, value in parameters.items()
                        if name.startswith("Load/")))


def strength(parameters):
    """What a row must overcome."""
    energy = parameters["Yield/Criterion"] == "energy release"
    return "Material/Toughness" if energy else "Material/Shear limit"


def takes_part(name, parameters):
    """Whether the force depends on a parameter of force."""
    if name == "Material/Shear limit" and not is_zero(parameters["Blade/Edge radius"]):
        return True
    return name in ("Blade/Adhesion", strength(parameters))


def is_zero(text):
    """Of numbers, separated by commas."""
    try:
        return not any(float(word) for word in text.split(","))
    except ValueError:
        return False
