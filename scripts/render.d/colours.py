# SPDX-License-Identifier: LGPL-2.1-or-later
"""What colours stand for: the same for VTK and for the colour bar."""

import matplotlib
import numpy as np

MAPS = {"positive": "YlOrRd", "signed": "coolwarm", "few": "Set3",
        "many": "viridis"}
FEW = 12  # numbers of pieces or materials that have colours of their own


def choose_colours(frames, field, limits):
    """The field, the range, the map, how many colours it has, and which ends of
    the range values exceed."""
    values = np.concatenate([frame.nodal_values(field) for frame in frames])
    if field in frames[0].cells_data and not limits:
        low, high = int(values.min()), int(values.max())
        n = high - low + 1
        return {"field": field, "range": [low - 0.5, high + 0.5],
                "map": MAPS["few" if n <= FEW else "many"], "colours": n,
                "extend": "neither"}
    low, high = limits or value_range(values)
    below, above = bool(values.min() < low), bool(values.max() > high)
    extend = ("both" if above else "min") if below else \
        "max" if above else "neither"
    return {"field": field, "range": [low, high],
            "map": MAPS["signed" if low < 0 else "positive"], "colours": 256,
            "extend": extend}


def value_range(values):
    """Nearly all values: the few at a blade's force grow without bound."""
    high = np.percentile(np.abs(values), 99.5) or np.abs(values).max() or 1.0
    high = float(high)
    return (-high, high) if values.min() < -0.01 * high else (0.0, high)


def colour_map(colours):
    return matplotlib.colormaps[colours["map"]].resampled(colours["colours"])


def colour(values, colours):
    """Red, green and blue as bytes."""
    low, high = colours["range"]
    share = np.clip((values - low) / (high - low), 0, 1)
    return colour_map(colours)(share, bytes=True)[:, :3].copy()
