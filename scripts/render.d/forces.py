# SPDX-License-Identifier: LGPL-2.1-or-later
"""The blade's force and the stresses of a run, over the way of the blade."""

from itertools import accumulate

from matplotlib import pyplot as plt

RAMP = "ramp"
FAR = 4  # times as much as what the blade exerts is not worth showing
STYLE = {"linewidth": 1.2, "markersize": 3.5}


def plot_forces(run, title, name):
    """NAME.png and NAME.pdf."""
    cuts = [lines for lines in (of_cut(run, cut) for cut in run.cuts) if lines]
    starts = [0, *accumulate(lines[-1]["depth"] for lines in cuts)][:len(cuts)]
    with plt.rc_context({"font.size": 8, "axes.linewidth": 0.6}):
        figure, panels = plt.subplots(2, 1, sharex=True, figsize=(3.5, 3.6),
                                      constrained_layout=True)
        ramp = run.parameters.get("Division/Load control") == RAMP and \
            all(is_at_yield(run, lines) for lines in cuts)
        for start, lines in zip(starts, cuts):
            depth = [start + line["depth"] for line in lines]
            panels[0].plot(depth, [line["blade_force"] for line in lines], "o-",
                           color="C0", **STYLE)
            (plot_load if ramp else plot_stresses)(
                run, panels, start, lines,
                lambda text: text if lines is cuts[0] else None)
        finish(run, panels, starts, cuts)
        panels[0].set_title(title, fontsize=9, loc="left")
        figure.savefig(f"{name}.png", dpi=200)
        figure.savefig(f"{name}.pdf")
        plt.close(figure)


def of_cut(run, cut):
    """The states under the blade, one for each row."""
    return [line for line in run.statistics
            if line["cut"] == cut and line["event"] == "deform"]


def plot_load(run, panels, start, lines, label):
    """Where the load rises until a row yields: the load, which is what changes."""
    depth = [start + line["depth"] for line in lines]
    largest = float(run.parameters["Division/Maximum load factor"])
    panels[1].plot(depth, [line["load_factor"] for line in lines], "o-",
                   color="C0", label=label("where a row yields"), **STYLE)
    if largest < FAR * max(line["load_factor"] for line in lines):
        panels[1].axhline(largest, color="k", linestyle="--", linewidth=0.8,
                          label=label("maximum"))
    panels[1].set_ylabel("load factor")


def plot_stresses(run, panels, start, lines, label):
    depth = [start + line["depth"] for line in lines]
    panels[1].plot(depth, [line["cutting_stress"] for line in lines], "o-",
                   color="C3", label=label("cutting stress"), **STYLE)
    panels[1].plot(depth, [line["required_stress"] for line in lines], "k--",
                   label=label("required"), linewidth=0.8)
    unit = run.unit("stress")
    panels[1].set_ylabel("stress" + f" [{unit}]" * bool(unit))


def is_at_yield(run, lines):
    """Whether the load is such that each row just yields, until one does not."""
    yielding = lines[:-1] if arrests(run, lines) else lines
    return all(abs(line["cutting_stress"] - line["required_stress"]) <=
               0.01 * line["required_stress"] for line in yielding)


def arrests(run, lines):
    """Where a cut has been arrested."""
    return [line for line in run.statistics
            if line["cut"] == lines[0]["cut"] and line["event"] == "arrest"]


def finish(run, panels, starts, cuts):
    """What both kinds have: units, the cuts' borders, where one is arrested."""
    length = run.parameters.get("Length unit", "")
    force = run.parameters.get("Force unit", "")
    panels[0].set_ylabel("blade force" + f" [{force}]" * bool(force))
    what = "depth of the front row" if len(cuts) == 1 else \
        "travel of the blade, cut after cut"
    panels[1].set_xlabel(what + f" [{length}]" * bool(length))
    for axes in panels:
        axes.set_ylim(0, 1.12 * axes.get_ylim()[1])
        axes.grid(alpha=0.3, linewidth=0.5)
    for start, lines in zip(starts, cuts):
        mark_cut(run, panels, start, lines, len(cuts) > 1)
    for axes in panels:
        if axes.get_legend_handles_labels()[0]:
            axes.legend(fontsize=7, frameon=False, ncol=2, loc="lower right",
                        bbox_to_anchor=(1, 1), borderaxespad=0)


def mark_cut(run, panels, start, lines, has_others):
    cut = lines[0]["cut"]
    if has_others:
        for axes in panels:
            axes.axvline(start, color="0.6", linewidth=0.6)
        panels[0].annotate(f" cut {cut + 1}", (start, 1), va="top", fontsize=7,
                           xycoords=("data", "axes fraction"), xytext=(0, -2),
                           textcoords="offset points")
    for line in arrests(run, lines):
        panels[0].annotate("arrested", (start + line["depth"], line["blade_force"]),
                           xytext=(0, -10), textcoords="offset points", va="top",
                           ha="right", fontsize=7, arrowprops={"arrowstyle": "-"})
