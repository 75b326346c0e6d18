# SPDX-License-Identifier: LGPL-2.1-or-later
"""The tables of doc/performance.md."""

import contextlib
import functools
import pathlib
import shutil
import statistics
import tempfile

import block
import finite
import measure
import peers
import pressed
from measure import benchmark, cube, number, program, remembered, table

# The settings that differ from run to run.
PLANE = pathlib.Path(__file__).resolve().parent / "plane.prm"
ANEW = {"Solver/Method": "direct", "Division/Solve": "every row anew"}
CONDENSED = {"Division/Solve": "condensed"}
ITERATIVE = {"Solver/Method": "iterative"}


@contextlib.contextmanager
def block_scene(n):
    """solve.prm beside the mesh that it reads."""
    with tempfile.TemporaryDirectory() as directory:
        directory = pathlib.Path(directory)
        shutil.copy(peers.HERE / "solve.prm", directory)
        block.write(directory / "block.msh", n)
        yield directory / "solve.prm"


def solve_by_program(scene, method, n_processes):
    """Seconds, memory in MB of the larger process, and strain energy."""
    run = program(scene, {"Solver/Method": method, "Solver/Tolerance": "1e-8"},
                  n_processes=n_processes)
    return run.seconds, run.memory, float(run.events[-1]["strain_energy"])


def own_solves(scene, n, runs):
    """What solve_by_program gives, by name and number of processes."""
    return {(f"Setsudan, {method}", processes): remembered(
        f"one solve {n}, {method} on {processes}",
        lambda: solve_by_program(scene, method, processes)) for method, processes in runs}


def dolfinx_solves(n):
    """The same of DOLFINx."""
    results = {}
    for name in peers.DOLFINX:
        for processes in (1, 2):
            seconds, memory, found = peers.solve_by_dolfinx(n, name, processes)
            results[f"DOLFINx, {name}", processes] = (seconds, memory,
                                                      found["strain_energy"])
    return results


def calculix_solves(scene, n):
    """Seconds, memory in MB and how far it is off, by name and number of processes."""
    written = functools.cache(lambda: peers.decks(
        scene, {"Solver/Method": "direct"}, scene.parent / "decks")[0])
    results = {}
    for name, solver in peers.CALCULIX.items():
        seconds, memory, error = remembered(
            f"one solve {n}, CalculiX, {name}",
            lambda: peers.solve_by_calculix(written(), solver))
        results[f"CalculiX, {name}", 1] = seconds, memory, f"displacement {error:.1e}"
    return results


def energies_off(results, reference):
    """Says how far the energies are from that of the reference."""
    def off(energy):
        difference = abs(energy / results[reference][2] - 1)
        # The program's table has twelve digits.
        return f"energy {difference:.1e}" if difference > 1e-11 else "energy < 1e-11"

    return {key: (seconds, memory, "reference" if key == reference else off(energy))
            for key, (seconds, memory, energy) in results.items()}


def solve_table(results):
    unit = next(iter(results.values()))[0]
    rows = [[name, processes, number(seconds / unit), f"{memory:.0f}", off]
            for (name, processes), (seconds, memory, off) in results.items()]
    return (table(["from file to displacement", "processes", "time", "memory [MB]",
                   "off by"], rows) + f"\n\nThe unit is {unit:.2g} s.")


def one_solve(n=20):
    """From file to displacement, for general hexahedra with 107 163 unknowns, against
    CalculiX and DOLFINx. Setsudan and DOLFINx iterate until the residual is 1e-8 of the
    load; CalculiX's iterative solvers have no tolerance to set. A run of CalculiX or of
    DOLFINx on one process may use two threads. DOLFINx makes the mesh itself instead of
    reading it, and has compiled its forms before, in a run that is not counted. What the
    last column compares with is Setsudan's direct solution: displacements of CalculiX,
    the largest difference over the largest displacement; strain energies of the others,
    whose error is only about the square of the displacement's. Memory is that of the
    larger process."""
    with block_scene(n) as scene:
        own = own_solves(scene, n, [("iterative", 1), ("iterative", 2), ("direct", 1)])
        theirs = calculix_solves(scene, n)
    energies = energies_off({**own, **dolfinx_solves(n)}, ("Setsudan, direct", 1))
    return solve_table({**energies, **theirs})


def larger_solve(n=40):
    """The same with 811 923 unknowns, by iterative solvers only: energies are compared
    with that of Setsudan on one process."""
    with block_scene(n) as scene:
        own = own_solves(scene, n, [("iterative", 1), ("iterative", 2)])
    return solve_table(energies_off({**own, **dolfinx_solves(n)}, next(iter(own))))


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


def cut_by_program(n, values, n_processes):
    """Seconds, memory in MB of the larger process, and the number of solved states."""
    run = program(measure.CUBE, {**cube(n), **values}, n_processes=n_processes)
    return run.seconds, run.memory, int(run.events[-1]["frame"])


def cuts_by_program(n):
    """The same by name and number of processes."""
    runs = [("default", {}, 1), ("default", {}, 2), ("condensed", CONDENSED, 1),
            ("iterative", ITERATIVE, 1)]
    return {(name, processes): remembered(
        f"cut {n}, {name} on {processes}",
        lambda: cut_by_program(n, values, processes)) for name, values, processes in runs}


def state_by_calculix(n):
    """Seconds of a state by each solver, the mean of four."""
    with tempfile.TemporaryDirectory() as directory:
        written = peers.decks(measure.CUBE, {**cube(n), **CONDENSED},
                              pathlib.Path(directory))
        chosen = [written[len(written) * i // 4] for i in range(4)]
        return {name: statistics.mean(peers.solve_by_calculix(deck, solver)[0]
                                      for deck in chosen)
                for name, solver in peers.CALCULIX.items()}


def cuts_by_others(n, n_states):
    """Name, processes, seconds and memory in MB, if known, of a cut by others."""
    name = "conjugate gradients with ML"
    for processes in (1, 2):
        seconds, memory, found = peers.solve_by_dolfinx(n, name, processes)
        yield (f"DOLFINx, {name}, {n_states} solves (extrapolated from one of the uncut "
               "block)", processes, seconds + (n_states - 1) * found["seconds"], memory)
    for name, seconds in remembered(f"cut {n}, CalculiX",
                                    lambda: state_by_calculix(n)).items():
        yield (f"CalculiX, {name} (extrapolated from 4 states)", 1, n_states * seconds,
               None)


def whole_cut(n=20):
    """All rows of a cut, against one solve and against every row anew. Default is what a
    scene gets that says nothing about solvers. CalculiX and DOLFINx cannot cut: theirs is
    the time to solve as many states. For DOLFINx that is the uncut block of the first
    section again and again, in a run that starts once but makes mesh, forms and matrix
    for each state, as they change in a cut. Compare runs on as many processes."""
    one = remembered(f"equation {n}, uncut, direct", lambda: benchmark(
        "one_solve", "direct", n))
    unit = one["set_up"] + one["solve"]
    own = cuts_by_program(n)
    n_states = own["condensed", 1][2]
    before, row = remembered(f"cut {n}, every row anew", lambda: rows_anew(n))
    runs = [("one uncut factorization and solve", 1, "", unit, one["memory"]),
            *((f"Setsudan, {name}", processes, states, seconds, memory)
              for (name, processes), (seconds, memory, states) in own.items()),
            ("Setsudan, every row factored anew (extrapolated from 4)", 1, n_states,
             before + row * (n_states - 1), None),
            *((name, processes, n_states, seconds, memory)
              for name, processes, seconds, memory in cuts_by_others(n, n_states))]
    rows = [[name, processes, states, number(seconds / unit),
             f"{memory:.0f}" if memory else ""]
            for name, processes, states, seconds, memory in runs]
    return (table(["run", "processes", "states", "time", "memory [MB]"], rows)
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


def travels():
    """Cuts by a blade that travels, over the cut of the same body under given forces, all
    with element rows and without friction; and cuts in plane strain on elements that
    resolve the force, in seconds. Each state of a travelling blade is followed through all
    changes of its contact, for the rows as they are split and for each of those that may
    split next. One change is at least one solve of the active set method: here of a wedge
    in a cube of 8^3 elements that is cut half through."""
    travel = {"Blade/Drive": "travel", "Blade/Edge loads": "", "Blade/Sharpness": 0,
              "Yield/Criterion": "energy release", "Yield/Check": "every row",
              "Material/Toughness": .1}
    wedge = {"Blade/Shape": "wedge", "Blade/Wedge angle": 20, "Blade/Thickness": .1,
             "Blade/Shoulder radius": .05}
    large_wedge = {**wedge, "Blade/Thickness": 1, "Blade/Shoulder radius": .5}
    in_space = {**cube(20), "Division/Release": "element row"}
    runs = {"given forces": (measure.CUBE, in_space),
            "thin blade": (measure.CUBE, {**in_space, **travel}),
            "wedge": (measure.CUBE, {**in_space, **travel, **large_wedge}),
            "thin blade, plane strain": (PLANE, {}),
            "wedge, plane strain": (PLANE, wedge)}
    seconds = {name: remembered(f"travel, {name}", lambda of=of: program(*of).seconds)
               for name, of in runs.items()}
    change = remembered("change of contact", lambda: benchmark("contact", 8))
    unit = seconds["given forces"]
    lines = [[name, number(value if "plane" in name else value / unit)]
             for name, value in seconds.items()]
    return (table(["cut of 20 rows, 107 163 unknowns", "time"], lines[:3])
            + f"\n\nThe unit is {unit:.2g} s.\n\n"
            + table(["cut of 200 rows", "time [s]"], lines[3:]) + "\n\n"
            + table(["elements", "one change of contact [ms]"],
                    [["8^3", number(change["milliseconds"])]]))


SECTIONS = {
    "One solve": one_solve,
    "A larger solve": larger_solve,
    "The equations alone": one_equation,
    "A whole cut": whole_cut,
    "Finite strain": finite.finite_solve,
    "A cut under finite strain": finite.finite_cut,
    "Contact under finite strain": pressed.contact,
    "A blade that travels": travels,
    "From a thousand to ten million unknowns": sizes,
    "Slender and nearly incompressible bodies": hard_bodies,
    "The product without a matrix": operator,
    "The smallest scenes": events,
    "Frames": frames,
}
