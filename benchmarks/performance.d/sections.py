# SPDX-License-Identifier: LGPL-2.1-or-later
"""The tables of doc/performance.md."""

import functools
import pathlib
import shutil
import statistics
import tempfile

import block
import calculix
import measure
from measure import benchmark, cube, number, program, remembered, table

# How CalculiX calls its solvers.
CALCULIX = {"SPOOLES": "SPOOLES", "scaled conjugate gradients": "ITERATIVE SCALING",
            "conjugate gradients with incomplete Cholesky": "ITERATIVE CHOLESKY"}

# The settings that differ from run to run.
ANEW = {"Solver/Method": "direct", "Division/Solve": "every row anew"}
CONDENSED = {"Division/Solve": "condensed"}
ITERATIVE = {"Solver/Method": "iterative"}


def decks(scene, values, directory):
    """The decks for CalculiX of a run's states."""
    program(scene, {**values, "Output/CalculiX decks": "true"}, directory)
    return sorted(directory.glob("stage_*.inp"))


def solve_by_calculix(deck, solver):
    """Seconds, memory in MB, and how far the displacements are from the program's."""
    job = deck.with_name(f"{deck.stem}_{solver.replace(' ', '_')}.inp")
    job.write_text(deck.read_text().replace("*STATIC\n", f"*STATIC, SOLVER={solver}\n"))
    seconds, memory, said = measure.timed(["ccx", job.stem], job.parent,
                                          OMP_NUM_THREADS="2")
    if "*ERROR" in said:
        raise RuntimeError(said[-2000:])
    return seconds, memory, calculix.compare(job, deck.with_suffix(".csv"))[2]


def solve_by_program(scene, values, n_processes):
    run = program(scene, values, n_processes=n_processes)
    return run.seconds, run.memory


def one_solve(n=20):
    """From file to displacement, against CalculiX."""
    with tempfile.TemporaryDirectory() as directory:
        directory = pathlib.Path(directory)
        scene = directory / "solve.prm"
        shutil.copy(pathlib.Path(__file__).parent / "solve.prm", scene)
        block.write(directory / "block.msh", n)
        own = {}
        for name, method, processes in (("iterative", "iterative", 1),
                                        ("iterative, 2 processes", "iterative", 2),
                                        ("direct", "direct", 1)):
            values = {"Solver/Method": method, "Solver/Tolerance": "1e-8"}
            own[name] = remembered(f"solve {n}, {name}",
                                   lambda: solve_by_program(scene, values, processes))
        written = functools.cache(lambda: decks(
            scene, {"Solver/Method": "direct"}, directory / "decks")[0])
        theirs = {name: remembered(f"solve {n}, CalculiX, {name}",
                                   lambda: solve_by_calculix(written(), solver))
                  for name, solver in CALCULIX.items()}
    unit = own["iterative"][0]
    rows = [[f"Setsudan, {name}", number(seconds / unit), f"{memory:.0f}", ""]
            for name, (seconds, memory) in own.items()]
    rows += [[f"CalculiX, {name}", number(seconds / unit), f"{memory:.0f}",
              f"{error:.1e}"] for name, (seconds, memory, error) in theirs.items()]
    return (table(["from file to displacement", "time", "memory [MB]",
                   "displacement off by"], rows) + f"\n\nThe unit is {unit:.2g} s.")


def one_equation(n=20):
    """The solve alone, against the assembled matrix."""
    rows, unit = [], None
    for name, method in (("multigrid over the order, no matrix", "multigrid"),
                         ("ML on the assembled matrix, rigid modes", "algebraic"),
                         ("sparse Cholesky", "direct")):
        result = remembered(f"equation {n}, {method}",
                            lambda: benchmark("one_solve", method, n, "distorted"))
        seconds = result["set_up"] + result["solve"]
        unit = unit or seconds
        rows.append([name, number(seconds / unit), number(result["set_up"] / unit),
                     number(result["solve"] / unit), f"{result['iterations']:.0f}",
                     f"{result['residual']:.1e}", f"{result['memory']:.0f}"])
    return (table(["one solve", "time", "set-up", "solve", "iterations", "residual",
                   "memory [MB]"], rows) + f"\n\nThe unit is {unit:.2g} s.")


def rows_anew(n, n_rows=4):
    """Seconds of a cut of which every row is factored anew: up to the first one, and for
    one of the next few, behind which it is stopped."""
    def found(events):
        seconds = [float(line["seconds"]) for line in events if line["event"] == "deform"]
        return (seconds[0], (seconds[-1] - seconds[0]) / n_rows) \
            if len(seconds) > n_rows else None

    with tempfile.TemporaryDirectory() as directory:
        command = [*measure.processes(1), measure.ROOT / "build" / "setsudan",
                   measure.CUBE, "--output", directory,
                   *measure.settings({**measure.QUIET, **cube(n), **ANEW})]
        result, refusal = measure.watched(command, directory, found)
    if refusal:
        raise RuntimeError(refusal)
    return result


def whole_cut(n=20):
    """All rows of a cut, against one solve and against every row anew."""
    one = remembered(f"equation {n}, uncut, direct", lambda: benchmark(
        "one_solve", "direct", n))
    unit = one["set_up"] + one["solve"]
    rows = [["one uncut factorization and solve", "", 1, f"{one['memory']:.0f}"]]
    results = {}
    for name, values in (("condensed", CONDENSED), ("iterative", ITERATIVE)):
        def run():
            result = program(measure.CUBE, {**cube(n), **values})
            return (result.seconds, result.memory,
                    int(result.events[-1]["frame"]))
        results[name] = remembered(f"cut {n}, {name}", run)
    n_states = results["condensed"][2]
    before, row = remembered(f"cut {n}, every row anew", lambda: rows_anew(n))
    for name, (seconds, memory, states) in results.items():
        rows.append([f"cut, {name}", states, number(seconds / unit), f"{memory:.0f}"])
    anew = before + row * (n_states - 1)
    rows.append(["cut, every row factored anew (extrapolated from 4)", n_states,
                 number(anew / unit), ""])

    def by_calculix():
        with tempfile.TemporaryDirectory() as directory:
            written = decks(measure.CUBE, {**cube(n), **CONDENSED},
                            pathlib.Path(directory))
            chosen = [written[len(written) * i // 4] for i in range(4)]
            return {name: statistics.mean(solve_by_calculix(deck, solver)[0]
                                          for deck in chosen)
                    for name, solver in CALCULIX.items()}
    theirs = remembered(f"cut {n}, CalculiX", by_calculix)
    for name, seconds in theirs.items():
        rows.append([f"CalculiX, {name} (extrapolated from 4 states)", n_states,
                     number(seconds * n_states / unit), ""])
    return (table(["run", "states", "time", "memory [MB]"], rows)
            + f"\n\nThe unit is {unit:.2g} s.")


def sizes():
    """Time and memory over the number of unknowns."""
    rows, unit = [], None
    for n in (6, 9, 13, 20, 29, 43, 64, 94):
        result = remembered(f"size {n}", lambda: benchmark(
            "one_solve", "multigrid", n, "distorted"))
        unknowns = result["unknowns"]
        each = (result["set_up"] + result["solve"]) / unknowns
        if n == 20:
            unit = each
        rows.append((unknowns, result, each))
    return table(
        ["unknowns", "iterations", "time per unknown", "of it set-up", "mesh and loads",
         "memory [kB per unknown]"],
        [[f"{unknowns:.0f}", f"{result['iterations']:.0f}", number(each / unit),
          f"{100 * result['set_up'] / (result['set_up'] + result['solve']):.0f} %",
          number(result["model"] / unknowns / unit),
          number(result["memory"] * 1024 / unknowns)] for unknowns, result, each in rows]
    ) + f"\n\nThe unit is {unit * 1e6:.2g} s for a million unknowns."


def operator():
    """K u without a matrix, against what the processor can do."""
    rows = []
    for n in (20, 40):
        result = remembered(f"throughput {n}", lambda: benchmark("throughput", n))
        for kind in ("general", "uniform"):
            limits = {"operations": result["core_flops"] / result[f"{kind}_flops"],
                      "memory": result["core_bytes"] / result[f"{kind}_bytes"]}
            limit = min(limits, key=limits.get)
            rows.append([f"{result['unknowns']:.0f}", kind,
                         f"{result[f'{kind}_rate'] / 1e6:.0f}",
                         f"{result[f'{kind}_flops']:.0f}", f"{result[f'{kind}_bytes']:.0f}",
                         limit, f"{100 * result[f'{kind}_cells'] / limits[limit]:.0f} %"])
    return (table(["unknowns", "cells", "million unknowns per second and core",
                   "operations per cell", "bytes per cell", "limit",
                   "reached of it"], rows)
            + f"\n\nOne core does {result['core_flops'] / 1e9:.0f} billion operations a "
            f"second (dgemm) and moves {result['core_bytes'] / 1e9:.0f} GB/s.")


def one_event(n, values):
    """The milliseconds of a row, in the median."""
    lines = [line for line in program(measure.CUBE, {**cube(n), **values}).events
             if line["event"] == "deform"]
    seconds = [float(line["seconds"]) for line in lines]
    # The second row prepares the cut.
    return statistics.median(b - a for a, b in zip(seconds[1:], seconds[2:])) * 1e3


def events():
    """The time of one row in small scenes, once the cut is prepared."""
    rows = [[f"{n}^3", number(remembered(f"event {n}, whole",
                                         lambda: one_event(n, CONDENSED)))]
            for n in (4, 6, 8)]
    return table(["elements", "one row [ms, median]"], rows)


def hard_bodies(n=12):
    """Iterations without a matrix for slender and nearly incompressible bodies; those
    that need more than 500 are left to another solver."""
    def iterations(assignments):
        try:
            result = benchmark("one_solve", "multigrid", n, *assignments)
            return result["iterations"], result["residual"]
        except RuntimeError:
            return None, None

    bodies = [("cube", "Body/Size=10,10,10"),
              *((f"{text}, {ratio} to 1", f"Body/Size={size}")
                for ratio in (10, 30, 100)
                for text, size in (("plates", f"{10 * ratio},{10 * ratio},10"),
                                   ("bars", f"{10 * ratio},10,10"),
                                   ("columns", f"10,10,{10 * ratio}"))),
              *((f"Poisson's ratio {nu}", f"Material/Poisson's ratio={nu}")
                for nu in (.4, .45, .49, .499))]
    rows = []
    for name, assignment in bodies:
        found, residual = remembered(f"hard {n}, {name}",
                                     lambda: iterations([assignment]))
        rows.append([name, f"{found:.0f}" if found else "falls back",
                     f"{residual:.1e}" if found else ""])
    return table(["shape of the elements and of the body", "iterations", "residual"], rows)


def frames(n=20):
    """What writing every frame costs."""
    values = {**cube(n), **CONDENSED}
    without, with_frames = (
        remembered(f"frames {n}, {frames}", lambda: program(
            measure.CUBE, {**values, "Output/Frames": frames}).seconds)
        for frames in ("none", "every row"))
    return table(["frames", "time"],
                 [["none", 1], ["every row", f"{with_frames / without:.2f}"]])


SECTIONS = {
    "One solve": one_solve,
    "The equations alone": one_equation,
    "A whole cut": whole_cut,
    "From a thousand to ten million unknowns": sizes,
    "Slender and nearly incompressible bodies": hard_bodies,
    "The product without a matrix": operator,
    "The smallest scenes": events,
    "Frames": frames,
}
