# SPDX-License-Identifier: LGPL-2.1-or-later
"""The picture of a calibration: the data, and the fit."""

from curve import label
from matplotlib import pyplot as plt
from study_plots import STYLE, save


def plot_fit(model, data, result, name):
    """The mean forces of the cells over the measured ones, and what is left."""
    with plt.rc_context(STYLE):
        figure, (above, below) = plt.subplots(
            2, 1, sharex=True, figsize=(4.2, 3.6), constrained_layout=True,
            gridspec_kw={"height_ratios": (3, 1)})
        above.plot(data.travel, data.force, ".", color="0.5", markersize=3,
                   label="measured")
        above.stairs(result.fitted, model.ends, baseline=None, color="C0", linewidth=1,
                     label="fitted")
        below.plot(data.travel, data.force - result.fitted, ".", color="0.5",
                   markersize=3)
        below.axhline(0, color="C0", linewidth=0.8)
        above.set_ylabel(label("force", model, "Force unit"))
        below.set_ylabel(label("residual", model, "Force unit"))
        below.set_xlabel(label("travel", model, "Length unit"))
        above.legend(fontsize=7, frameon=False)
        for axes in (above, below):
            axes.grid(alpha=0.3, linewidth=0.5)
        save(figure, name)
