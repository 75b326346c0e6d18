# SPDX-License-Identifier: LGPL-2.1-or-later
"""The tables on finite strain of doc/performance.md."""

import pathlib
import tempfile

import calculix
import measure
import peers
from measure import number, program, remembered, table

BLOCK = peers.HERE / "finite.prm"
CUT = peers.HERE / "finite_cut.prm"
SMALL = {"Deformation/Strain": "small"}


def elements(n):
    return {"Body/Elements": f"{n},{n},{n}"}


def solve(n, values):
    """Seconds, memory in MB and largest displacement."""
    run = program(BLOCK, {**elements(n), **values})
    return run.seconds, run.memory, float(run.events[-1]["max_displacement"])


def finite_deck(deck):
    """The deck of a linear state made one of finite strain: the same mesh and loads, the
    law with C10 = mu / 2 and D1 = 2 / kappa."""
    lines, text = deck.read_text().splitlines(), []
    while lines:
        line = lines.pop(0)
        if line == "*ELASTIC":
            modulus, ratio = map(float, lines.pop(0).split(","))
            text += ["*HYPERELASTIC, NEO HOOKE",
                     f"{modulus / (4 * (1 + ratio))}, {6 * (1 - 2 * ratio) / modulus}"]
        else:
            text.append({"*STEP": "*STEP, NLGEOM", "*STATIC": "*STATIC, DIRECT"}.get(
                line, line))
            if line == "*STATIC":
                text.append("1., 1.")
    result = deck.with_name("finite.inp")
    result.write_text("\n".join(text) + "\n")
    return result


def solve_by_calculix(n, solver):
    """The same, of CalculiX in one increment."""
    with tempfile.TemporaryDirectory() as directory:
        deck = peers.decks(BLOCK, {**elements(n), **SMALL}, pathlib.Path(directory))[0]
        job = finite_deck(deck)
        job.write_text(job.read_text().replace("*STATIC", f"*STATIC, SOLVER={solver}"))
        seconds, memory, said = measure.timed(["ccx", job.stem], directory,
                                              OMP_NUM_THREADS=str(peers.CORES))
        if "*ERROR" in said:
            raise RuntimeError(said[-2000:])
        largest = max(sum(x * x for x in u) ** 0.5
                      for u in calculix.displacements(job).values())
    return seconds, memory, largest


def finite_solve(n=20):
    """A block that a dead pressure shortens by an eighth, in one increment, from file to
    displacement: isochoric neo-Hooke, 107 163 unknowns, on one process. CalculiX has the
    same mesh, law and nodal forces, and two threads; it ends where forces are off by
    5e-3 of their mean, as it does by default, Setsudan at 1e-10. The last column compares
    the largest displacement with Setsudan's."""
    runs = {f"Setsudan, {name}": (lambda values=values: solve(n, values))
            for name, values in (("as it chooses", {}),
                                 ("direct", {"Solver/Method": "direct"}))}
    runs["Setsudan, small strain"] = lambda: solve(n, SMALL)
    for name in ("SPOOLES", "scaled conjugate gradients"):
        runs[f"CalculiX, {name}"] = (
            lambda solver=peers.CALCULIX[name]: solve_by_calculix(n, solver))
    results = {name: remembered(f"finite {n}, {name}", run) for name, run in runs.items()}
    unit, _, reference = next(iter(results.values()))
    rows = [[name, number(seconds / unit), f"{memory:.0f}",
             "" if "small" in name else f"{abs(largest / reference - 1):.1e}"]
            for name, (seconds, memory, largest) in results.items()]
    return (table(["one solve", "time", "memory [MB]", "displacement off by"], rows)
            + f"\n\nThe unit is {unit:.2g} s.\n\n" + larger(unit, n))


def larger(unit, n):
    """The same with up to a million unknowns."""
    rows = []
    for m in (n, 29, 43):
        seconds, memory, _ = remembered(f"finite {m}, Setsudan, as it chooses",
                                        lambda m=m: solve(m, {}))
        unknowns = 3 * ((m + 1) ** 3 + 3 * m * (m + 1) ** 2)
        rows.append([unknowns, number(seconds / unit), f"{memory:.0f}"])
    return table(["unknowns", "time", "memory [MB]"], rows)


def finite_cut(n=10):
    """A cut of 20 rows, 14 883 unknowns, t = 2 % of the body, neo-Hooke. All rows are solved
    with one factorization of the body at rest, which preconditions conjugate
    gradients; the tangents are not assembled."""
    runs = {"small strain": SMALL, "finite strain": {},
            "finite strain, every row anew": {"Division/Solve": "every row anew"}}
    seconds = {name: remembered(f"finite cut {n}, {name}", lambda values=values: program(
        CUT, {**elements(n), **values}).seconds) for name, values in runs.items()}
    unit = seconds["small strain"]
    return (table(["cut of 20 rows", "time"],
                  [[name, number(value / unit)] for name, value in seconds.items()])
            + f"\n\nThe unit is {unit:.2g} s.")
