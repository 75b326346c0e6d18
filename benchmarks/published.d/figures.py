# SPDX-License-Identifier: LGPL-2.1-or-later
"""Pictures with what was published and what is computed on top of it."""

import argparse
import pathlib

import matplotlib

matplotlib.use("Agg")
from matplotlib import pyplot

ROOT = pathlib.Path(__file__).resolve().parents[2]
OPTIONS = argparse.Namespace(program=str(ROOT / "build" / "setsudan"), processes=1,
                             mpiexec="mpirun")
PUBLISHED, COMPUTED = {"color": "black", "linewidth": 1}, {"linestyle": "none"}


def picture(name, title, curves, points, **axes_settings):
    """Write doc/images/published_NAME.png; the answer is the line that shows it.

    @param curves, points (label, x, y), of what was published and of what is computed;
      a label begins with '+' where it is published and given by points."""
    figure, axes = pyplot.subplots(figsize=(6, 4.2), layout="constrained")
    for (label, x, y), style in zip(curves, ("-", "--", ":", "-.") * 3):
        if label.startswith("+"):
            axes.plot(x, y, "ks", markersize=7, markerfacecolor="none", label=label[1:])
        else:
            axes.plot(x, y, style, label=label, **PUBLISHED)
    for (label, x, y), marker in zip(points, "ox^dv*"):
        axes.plot(x, y, marker, label=label, markersize=5, **COMPUTED)
    axes.set(title=title, **axes_settings)
    axes.grid(alpha=.3)
    axes.legend(fontsize="small")
    path = f"images/published_{name}.png"
    figure.savefig(ROOT / "doc" / path, dpi=110)
    pyplot.close(figure)
    return f"![{title}]({path})"


def table(titles, rows):
    lines = [titles, ["---"] * len(titles), *rows]
    return "\n".join("| " + " | ".join(map(str, line)) + " |" for line in lines)


def missing(text):
    return f"**What is missing for a closer comparison.** {text}"
