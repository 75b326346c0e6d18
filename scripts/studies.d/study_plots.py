# SPDX-License-Identifier: LGPL-2.1-or-later
"""The plots of a study: curves of force over each other, and quantities."""

import matplotlib

matplotlib.use("Agg")
from curve import label, mean_push, travels
from matplotlib import pyplot as plt
from study_file import SUMMARY, labels_of, short_names, slug

STYLE = {"font.size": 8, "axes.linewidth": 0.6}
NAMED = 10  # more curves than these have no legend
STATES = ("deform", "travel")
FAR_APART = 30.  # forces, of which the small ones need a logarithmic axis to be seen


def plot_curves(ended, name):
    """The mean force of the blade between events against its travel or, where it has
    none, its force against the depth of the row at which it stands; of the first cut."""
    with plt.rc_context(STYLE):
        figure, axes = plt.subplots(figsize=(6.2, 3.2), constrained_layout=True)
        labels = labels_of([settings for settings, _ in ended])
        for i, (text, (_, run)) in enumerate(zip(labels, ended)):
            plot_curve(axes, run, label=text, linewidth=0.9,
                       color=plt.cm.viridis(i / max(1, len(ended) - 1) * 0.9))
        forces = [force for _, run in ended
                  if (force := run.summary.get("mean_force") or 0) > 0]
        if forces and max(forces) > FAR_APART * min(forces):
            axes.set_yscale("log")
        run = ended[0][1]
        axes.set_xlabel(label("travel" if travels(run) else "depth", run, "Length unit"))
        axes.set_ylabel(label("mean force" if travels(run) else "force", run,
                              "Force unit"))
        axes.grid(alpha=0.3, linewidth=0.5)
        if len(ended) <= NAMED:
            axes.legend(fontsize=6, frameon=False, bbox_to_anchor=(1, 1),
                        loc="upper left")
        save(figure, name)


def plot_curve(axes, run, **style):
    lines = [line for line in run.statistics
             if line["cut"] == run.cuts[0] and line["event"] in STATES]
    if travels(run):
        axes.step([0.0] + [line["travel"] for line in lines],
                  [0.0] + [mean_push(run, line) for line in lines], where="pre", **style)
    else:
        axes.plot([line["depth"] for line in lines],
                  [line["blade_force"] for line in lines], **style)


def plot_pair(ended, pair, folder):
    """One quantity against another; runs with the same other settings are one line."""
    up, across = pair
    short = short_names([settings for settings, _ in ended])
    groups = {}
    for settings, run in ended:
        point = [value_of(name, settings, run) for name in (across, up)]
        others = ", ".join(f"{short[key]} = {value}" for key, value in settings.items()
                           if key not in pair)
        if None not in point:
            groups.setdefault(others, []).append(point)
    with plt.rc_context(STYLE):
        figure, axes = plt.subplots(figsize=(3.6, 2.8), constrained_layout=True)
        for others, points in groups.items():
            points.sort()
            axes.plot(*zip(*points), "o-", markersize=3, linewidth=0.9, label=others)
        axes.set_xlabel(words_of(across, ended))
        axes.set_ylabel(words_of(up, ended))
        axes.grid(alpha=0.3, linewidth=0.5)
        if 1 < len(groups) <= NAMED:
            axes.legend(fontsize=6, frameon=False)
        save(figure, folder / f"{slug(up)}_against_{slug(across)}")


def value_of(name, settings, run):
    """A number, or None where the run has none."""
    if name in SUMMARY:
        return run.summary[name]
    try:
        return float(run.parameters.get(name, ""))
    except ValueError:
        return None


def words_of(name, ended):
    """A quantity with its unit, as far as the scene labels it."""
    run = ended[0][1]
    length, force = (run.parameters.get(f"{kind} unit", "") for kind in
                     ("Length", "Force"))
    units = {"mean_force": force, "work": f"{force} {length}", "seconds": "s",
             "first_yield": length if travels(run) else ""}
    unit = units.get(name, "").strip()
    return name.rpartition("/")[2].replace("_", " ") + f" [{unit}]" * bool(unit)


def save(figure, name):
    figure.savefig(f"{name}.png", dpi=200)
    figure.savefig(f"{name}.pdf")
    plt.close(figure)
