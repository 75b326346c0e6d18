# SPDX-License-Identifier: LGPL-2.1-or-later
"""What pictures say in words."""


def stage(run, frame):
    """What happened in a frame, in a few words."""
    events = {line["event"]: line for line in run.events(frame)}
    line = list(events.values())[-1]
    of_cut = f"cut {line['cut'] + 1}: " if len(run.cuts) > 1 else ""
    if "divide" in events:
        pieces = int(line["pieces"])
        return of_cut + ("cut open" if pieces == 1 else f"{pieces} pieces")
    if "rest" in events:
        return "at rest"
    return of_cut + stage_of_cut(events, line)


def stage_of_cut(events, line):
    if "arrest" in events and "travel" not in events:
        return f"arrested at row {line['row'] + 1}"
    if line["released_rows"] == 0:
        return "deformed"
    return f"{line['released_rows']} row{'s'[:line['released_rows'] > 1]} split"


def loaded(run, frame):
    """The line of a state under the blade."""
    lines = [line for line in run.events(frame) if line["event"] in ("deform", "travel")]
    return lines[-1] if lines and lines[-1]["blade_force"] else None


def load(run, frame):
    """Where the blade is and what it exerts, in a few words."""
    line = loaded(run, frame)
    if not line:
        return ""
    return (f"depth {with_unit(line['depth'], run, 'Length unit')}, "
            f"F = {with_unit(line['blade_force'], run, 'Force unit')}")


def cutting_stress(run, frame):
    """The state's stress and what is needed to go on."""
    line, unit = loaded(run, frame), run.unit("stress")
    if not line:
        return ""
    if run.parameters.get("Yield/Criterion") == "energy release":
        unit = run.unit("energy_release")
        return (f"energy release {line['cutting_stress']:.3g} of "
                f"{line['required_stress']:.3g} {unit} required").replace("  ", " ")
    return (f"cutting stress {line['cutting_stress']:.3g} of "
            f"{line['required_stress']:.3g} {unit} required").replace("  ", " ")


def legend(run, view):
    """What is what in a picture of a body."""
    states = view["frames"].values()
    force = run.parameters.get("Force unit", "")
    unit = f" [{force}]" if force else ""
    blade = []
    if any(state["arrows"] for state in states):
        blade.append(f"Blue: the blade and its forces{unit}.")
    if any(len(line) > 1 for state in states for line in state["front"]):
        blade.append("Dashed: the row under it.")
    return " ".join([*blade, "Grey: the body at rest.", warp(view)])


def warp(view):
    factor = view["warp"]
    if factor == 1:
        return "Displacements to scale."
    return f"Displacements drawn × {factor:g}."


def with_unit(number, run, name):
    return f"{number:.3g} {run.parameters.get(name, '')}".strip()
