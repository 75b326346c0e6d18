# SPDX-License-Identifier: LGPL-2.1-or-later
"""The force of a blade that travels against its travel, with its parts."""

from matplotlib import pyplot as plt
from words import with_unit

# From below: columns whose sum is the blade's force.
PARTS = (("edge", "C0", lambda line: line["edge_force"]),
         ("flanks", "C1", lambda line: line["flank_force"] - line["friction_force"]),
         ("friction", "C3", lambda line: line["friction_force"]))
ALL_CUT = "divide"
STATES = ("deform", "release", "travel")


def travels(run):
    """Whether a run's blade does."""
    return "travel" in run.statistics[-1]


def turns(lines):
    """Whether the blade is withdrawn between some."""
    return any(line["travel"] < before["travel"] for before, line in zip(lines, lines[1:]))


def plot_curve(run, title, name):
    """NAME.png and NAME.pdf: the parts stacked, or where the blade turns the force and its
    friction; the mean force between yields, and where the cut begins and ends."""
    with plt.rc_context({"font.size": 8, "axes.linewidth": 0.6}):
        figure, panels = plt.subplots(len(run.cuts), 1, squeeze=False,
                                      figsize=(4.2, 2.8 * len(run.cuts)),
                                      constrained_layout=True)
        for cut, axes in zip(run.cuts, panels[:, 0]):
            lines = [line for line in run.statistics
                     if line["cut"] == cut and line["event"] in STATES]
            if lines:
                (plot_loop if turns(lines) else plot_parts)(axes, run, lines)
                mark(axes, run, cut, lines)
                mark_steady(axes, run, yields_of(run, cut))
            axes.set_ylabel(label("force", run, "Force unit"))
            axes.set_xlabel(label("travel", run, "Length unit"))
        panels[0, 0].set_title(title, fontsize=9, loc="left")
        panels[0, 0].legend(fontsize=7, frameon=False, ncol=4, loc="lower right",
                            bbox_to_anchor=(1, 1), borderaxespad=0)
        figure.savefig(f"{name}.png", dpi=200)
        figure.savefig(f"{name}.pdf")
        plt.close(figure)


def plot_together(runs, name):
    """NAME.png and NAME.pdf: the mean forces of several runs, in their first cuts."""
    with plt.rc_context({"font.size": 8, "axes.linewidth": 0.6}):
        figure, axes = plt.subplots(figsize=(4.2, 2.8), constrained_layout=True)
        for run in runs:
            yields = yields_of(run, run.cuts[0])
            axes.step([0.0] + [line["travel"] for line in yields],
                      [0.0] + [mean_push(run, line) for line in yields], where="pre",
                      linewidth=1, label=run.name())
        axes.set_xlim(left=0)
        axes.set_ylim(bottom=0)
        axes.grid(alpha=0.3, linewidth=0.5)
        axes.set_xlabel(label("travel", runs[0], "Length unit"))
        axes.set_ylabel(label("mean force", runs[0], "Force unit"))
        axes.legend(fontsize=7, frameon=False)
        figure.savefig(f"{name}.png", dpi=200)
        figure.savefig(f"{name}.pdf")
        plt.close(figure)


def mean_push(run, line):
    """The mean force along the blade's direction: mean_force has the work of a blade
    that slices in it too."""
    return line["mean_force"] * share_of_push(run, line)


def yields_of(run, cut):
    """The states in which rows yield."""
    return [line for line in run.statistics
            if line["cut"] == cut and line["event"] == "deform"]


def share_of_push(run, line):
    """Of the blade's work, that of the force along its direction."""
    slice_push = float(run.parameters.get("Blade/Slice-push ratio", 0))
    push, aside = line["blade_force"], slice_push * line["force_along"]
    return push / (push + aside) if push + aside > 0 else 1.0


def with_feet(run, lines):
    """Travels and lines of a curve. An event leaves the blade with little force, which
    begins to rise where the area below is the work until the next one."""
    begin = {**dict.fromkeys(lines[0], 0.0), "work": work_before(run, lines[0])}
    travels, shown = [0.0], [begin]
    for before, line in zip([begin, *lines], lines):
        moved, rise = (line[name] - before[name] for name in ("travel", "blade_force"))
        if moved > 0 and rise > 0:
            work = (line["work"] - before["work"]) * share_of_push(run, line)
            foot = line["travel"] - 2 * (work - before["blade_force"] * moved) / rise
            travels.append(min(max(before["travel"], foot), line["travel"]))
            shown.append(before)
        travels.append(line["travel"])
        shown.append(line)
    return travels, shown


def work_before(run, line):
    """The work when the cut of a line began."""
    earlier = [other["work"] for other in run.statistics if other["cut"] < line["cut"]]
    return earlier[-1] if earlier else 0.0


def plot_parts(axes, run, lines):
    """Between two events the force is drawn with one corner, so that the area is the
    work; it has one wherever contacts change."""
    travels, shown = with_feet(run, lines)
    axes.stackplot(travels, *([part(line) for line in shown] for _, _, part in PARTS),
                   labels=[text for text, _, _ in PARTS],
                   colors=[colour for _, colour, _ in PARTS], alpha=0.55)
    yields = [line for line in lines if line["event"] == "deform"]
    axes.step([line["travel"] for line in yields],
              [mean_push(run, line) for line in yields], "k-", where="pre",
              linewidth=1.2, label="mean")
    axes.set_xlim(left=0)
    axes.set_ylim(bottom=0)
    axes.grid(alpha=0.3, linewidth=0.5)


def plot_loop(axes, run, lines):
    """A blade that is pushed and withdrawn: its force from state to state."""
    travels = [0.0] + [line["travel"] for line in lines]
    for name, colour, text in (("blade_force", "k", "force"),
                               ("friction_force", "C3", "friction")):
        axes.plot(travels, [0.0] + [line[name] for line in lines], "-", color=colour,
                  linewidth=1, label=text)
    axes.axhline(0, color="0.4", linewidth=0.6)
    axes.grid(alpha=0.3, linewidth=0.5)


def mark(axes, run, cut, lines):
    """The first yield, and where the blade comes out, is arrested or rests."""
    first = next((line for line in lines if line["event"] == "deform"), None)
    ends = [line for line in run.statistics if line["cut"] == cut and
            line["event"] in (ALL_CUT, "arrest")]
    stops = any(line["event"] == "travel" for line in lines)
    words = [(first, "yields at " + with_unit(first["blade_force"], run, "Force unit"))
             ] if first else []
    words += [(line, "through" if line["event"] == ALL_CUT else
               "ends" if stops else "arrested") for line in ends]
    for line, text in words:
        axes.axvline(line["travel"], color="0.4", linestyle=":", linewidth=0.8)
        axes.annotate(text, (line["travel"], 1), xycoords=("data", "axes fraction"),
                      xytext=(-2 if line is not first else 2, -3), va="top",
                      ha="right" if line is not first else "left", fontsize=7,
                      textcoords="offset points", rotation=90)


def mark_steady(axes, run, yields):
    """The mean force while the front is in the middle half of the cut."""
    deepest = yields[-1]["depth"] if yields else 0
    middle = [line for line in yields if deepest / 4 <= line["depth"] <= 3 * deepest / 4]
    if len(middle) < 3:
        return
    begin, end = middle[0], middle[-1]
    force = ((end["work"] - begin["work"]) / (end["travel"] - begin["travel"]) *
             share_of_push(run, end))
    axes.plot([begin["travel"], end["travel"]], [force, force], "k--", linewidth=1)
    axes.annotate("mean " + with_unit(force, run, "Force unit"),
                  (end["travel"], force), xytext=(0, 2), va="bottom", ha="right",
                  fontsize=7, textcoords="offset points")


def label(what, run, name):
    unit = run.parameters.get(name, "")
    return what + f" [{unit}]" * bool(unit)
