# SPDX-License-Identifier: LGPL-2.1-or-later
"""Nonlinear least squares of few parameters, and what the data say about them.

Residuals are independent and have one variance, which is estimated from them."""

from types import SimpleNamespace

import numpy as np
from program import Refusal
from scipy import optimize, stats

# A column of the Jacobian, per unit of a logarithm or of the range, below this part of
# the data determines nothing.
LEAST_EFFECT = 1e-6
# Of the Jacobian with columns of length 1: errors of the data, and of the model, reach the
# parameters so many times enlarged. Two parameters have it at a correlation of 0.998.
LARGEST_CONDITION = 30.
LEVEL = 0.95
ALIKE = 2.  # standard errors of the correlation of independent neighbours


class Slopes:
    """A Jacobian of differences, taken anew where x has gone on by more than the steps:
    within them it is a mean in any case."""

    def __init__(self, jacobian, steps):
        self.jacobian, self.steps, self.x = jacobian, steps, None

    def __call__(self, x):
        if self.x is None or np.any(abs(x - self.x) > self.steps):
            self.x, self.value = x.copy(), self.jacobian(x)
        return self.value


def fit(model, jacobian, data, start, bounds):
    """The parameters at which model(x) is closest to the data."""
    scale = np.sqrt(np.mean(data**2)) or 1.
    return optimize.least_squares(
        lambda x: (model(x) - data) / scale, start, lambda x: jacobian(x) / scale,
        bounds=bounds, x_scale=1., ftol=1e-5, xtol=1e-4, gtol=1e-10, max_nfev=50)


def refuse_without_effect(names, jacobian, data):
    """Raises Refusal where the data do not depend on a parameter."""
    least = LEAST_EFFECT * np.linalg.norm(data)
    for name, column in zip(names, jacobian.T):
        if np.linalg.norm(column) <= least:
            raise Refusal(f"the curve does not determine {name}, which has no effect on "
                          "the force")


def refuse_together(names, jacobian, largest=LARGEST_CONDITION):
    """The condition number of the Jacobian with columns of length 1; raises Refusal where
    that is too large, with the parameters that can be changed together."""
    scaled = jacobian / np.linalg.norm(jacobian, axis=0)
    _, values, directions = np.linalg.svd(scaled, full_matrices=False)
    condition = values[0] / values[-1] if values[-1] > 0 else np.inf
    if condition > largest:
        weights = abs(directions[-1])
        together = [name for name, weight in zip(names, weights)
                    if weight > 0.1 * max(weights)]
        raise Refusal(f"the curve does not tell {' and '.join(together)} apart: changed "
                      "together they leave it as it is (condition number "
                      f"{condition:.3g}, at most {largest:g})")
    return condition


def describe(jacobian, residuals):
    """Standard errors, correlations and the half width of 95 % intervals, of a linear
    model with this Jacobian."""
    n, k = jacobian.shape
    noise = np.sqrt(residuals @ residuals / (n - k))
    inverse = np.linalg.inv(jacobian.T @ jacobian)
    spread = np.sqrt(np.diag(inverse))
    return SimpleNamespace(
        freedom=n - k, noise=noise, errors=noise * spread,
        correlations=inverse / np.outer(spread, spread),
        half_widths=stats.t.ppf((1 + LEVEL) / 2, n - k) * noise * spread,
        neighbours=neighbours(residuals))


def neighbours(residuals):
    """The correlation of neighbouring residuals."""
    squares = residuals @ residuals
    return residuals[1:] @ residuals[:-1] / squares if squares > 0 else 0.


def are_alike(correlation, n):
    """Whether neighbouring residuals are more alike than independent ones."""
    return correlation > ALIKE / np.sqrt(n)
