# SPDX-License-Identifier: LGPL-2.1-or-later
"""The tables, the plots and the advice of the trade."""

import math


def front(points):
    """Which of the (seconds, error) are better than all that are as fast."""
    best, kept = math.inf, set()
    for number, (seconds, error) in sorted(enumerate(points), key=lambda p: p[1]):
        if error < best:
            best = error
            kept.add(number)
    return kept


def percent(value):
    return f"{100 * value:.2g} %" if value < 1 else f"{100 * value:.0f} %"


def table(rows, unit):
    """Rows are (label, seconds, error); seconds as multiples of `unit`."""
    best = front([row[1:] for row in rows])
    lines = ["| | error | time | |", "|---|---|---|---|"]
    for number, (label, seconds, error) in sorted(
            enumerate(rows), key=lambda row: row[1][1]):
        lines.append(f"| {label} | {percent(error)} | {seconds / unit:.2g} "
                     f"| {'Pareto' if number in best else ''} |")
    return "\n".join(lines)


def advice(rows, unit, floor):
    """The fastest for each bound of the error that the reference can resolve."""
    lines = []
    for bound in (.3, .1, .03, .01):
        if bound < floor:
            lines.append(f"- {percent(bound)}: less than the reference resolves.")
            continue
        good = [row for row in rows if row[2] <= bound]
        if not good:
            lines.append(f"- {percent(bound)}: none of these.")
            continue
        label, seconds, error = min(good, key=lambda row: row[1])
        lines.append(f"- {percent(bound)}: **{label}** ({percent(error)}, time "
                     f"{seconds / unit:.2g}).")
    return "\n".join(lines)


def plot(title, rows, floor, file_name):
    """Error over time, the Pareto front as a line."""
    import matplotlib
    matplotlib.use("Agg")
    from matplotlib import pyplot, ticker

    figure, axes = pyplot.subplots(figsize=(7, 5))
    kinds = {}
    for label, seconds, error in rows:
        words = label.split(", ")
        kind = ", ".join(words[:2]) + (", refined near the cut"
                                       if "near the cut" in label else "")
        if "iterative" in label:
            kind = "3D, serendipity, iterative"
        kinds.setdefault(kind, []).append((seconds, max(error, 1e-5)))
    markers = "osD^v<>Pp*Xh"
    for number, (kind, points) in enumerate(sorted(kinds.items())):
        axes.loglog(*zip(*points), markers[number % len(markers)], label=kind, alpha=.8,
                    markerfacecolor="none" if kind.startswith("2D") else None)
    best = front([row[1:] for row in rows])
    line = sorted((rows[n][1], max(rows[n][2], 1e-5)) for n in best)
    axes.loglog(*zip(*line), "k-", linewidth=1, label="Pareto front")
    lowest = min(axes.get_ylim()[0], 0.7 * floor)
    axes.axhspan(lowest, floor, color="0.9", label="error of the reference")
    axes.set_ylim(bottom=lowest)
    axes.yaxis.set_major_formatter(ticker.FuncFormatter(lambda y, _: percent(y)))
    axes.yaxis.set_minor_formatter(ticker.FuncFormatter(
        lambda y, _: percent(y) if f"{y:.0e}"[0] in "25" else ""))
    axes.set(xlabel="time [s]", ylabel="relative error", title=title)
    axes.legend(fontsize=7)
    figure.tight_layout()
    figure.savefig(file_name, dpi=110)
    pyplot.close(figure)
