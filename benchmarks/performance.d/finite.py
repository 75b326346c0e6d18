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


def solve(n, values, n_processes=1):
    """The processor's seconds, memory in MB and largest displacement."""
    seconds, run = measure.of_processor(
        lambda: program(BLOCK, {**elements(n), **values}, n_processes=n_processes))
    return seconds, run.memory, float(run.events[-1]["max_displacement"])


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
        seconds, (_, memory, said) = measure.of_processor(
            lambda: measure.timed(["ccx", job.stem], directory, OMP_NUM_THREADS="1"))
        if "*ERROR" in said:
            raise RuntimeError(said[-2000:])
        largest = max(sum(x * x for x in u) ** 0.5
                      for u in calculix.displacements(job).values())
    return seconds, memory, largest


def solve_by_dolfinx(n, multigrid, n_processes):
    """The same, of DOLFINx."""
    peers.warm_up_dolfinx("finite")
    seconds, (_, memory, found) = measure.of_processor(
        lambda: peers.run_dolfinx(n, multigrid, n_processes, "finite"))
    return seconds, memory, found["max_displacement"]


def peers_solves(n):
    """By name and number of processes."""
    if peers.has_dolfinx():
        for name, multigrid in peers.DOLFINX.items():
            for processes in (1, 2):
                yield ((f"DOLFINx, {name}", processes),
                       lambda multigrid=multigrid, processes=processes:
                       solve_by_dolfinx(n, multigrid, processes))
    name = "scaled conjugate gradients"
    yield ((f"CalculiX, {name}", 1),
           lambda: solve_by_calculix(n, peers.CALCULIX[name]))


def finite_solve(n=20, n_rounds=2):
    """A block that a dead pressure shortens by an eighth, in one increment, from file to
    displacement: isochoric neo-Hooke, 107 163 unknowns. Times are the processor's, of all
    threads and processes together: compare runs on as many processes. Each is the least of
    two, between which all others ran. Memory is that of the larger process. DOLFINx, with
    the same elements and integration points, ends where the residual is 1e-8 of the first
    one, and has compiled its forms before. CalculiX has the same mesh, law and nodal
    forces, and ends where forces are off by 5e-3 of their mean, as it does by default;
    Setsudan at 1e-10. The last column compares the largest displacement with Setsudan's."""
    runs = {("Setsudan", processes): (lambda processes=processes: solve(n, {}, processes))
            for processes in (1, 2)}
    runs["Setsudan, small strain", 1] = lambda: solve(n, SMALL)
    runs.update(peers_solves(n))
    rounds = [{key: remembered(f"finite {n}, {key[0]} on {key[1]}, round {i}", run)
               for key, run in runs.items()} for i in range(n_rounds)]
    results = {key: min(one[key] for one in rounds) for key in runs}
    unit, _, reference = results["Setsudan", 1]
    rows = [[name, processes, number(seconds / unit), f"{memory:.0f}",
             "" if "small" in name else f"{abs(largest / reference - 1):.1e}"]
            for (name, processes), (seconds, memory, largest) in results.items()]
    return (table(["one solve", "processes", "time", "memory [MB]",
                   "displacement off by"], rows)
            + f"\n\nThe unit is {unit:.2g} s."
            + ("" if peers.has_dolfinx() else " DOLFINx is not installed.")
            + "\n\n" + larger(unit, n))


def larger(unit, n):
    """The same with up to a million unknowns."""
    rows = []
    for m in (n, 29, 43):
        seconds, memory, _ = remembered(f"finite {m}, Setsudan on 1, round 0",
                                        lambda m=m: solve(m, {}))
        unknowns = 3 * ((m + 1) ** 3 + 3 * m * (m + 1) ** 2)
        rows.append([unknowns, number(seconds / unit), f"{memory:.0f}"])
    return table(["unknowns", "time", "memory [MB]"], rows)


def cut(n, values):
    """The processor's seconds of a cut of n^3 elements."""
    return measure.of_processor(lambda: program(CUT, {**elements(n), **values}))[0]


def finite_cut(n=10):
    """A cut of 20 rows, 14 883 unknowns, t = 2 % of the body, neo-Hooke, in the processor's
    seconds. Rows are solved by conjugate gradients, which the factorization of the body at
    rest preconditions, and one of a later state where that fits no more; every row anew
    is with a factorization in each step of Newton's method. In the displacement
    formulation the tangents are not assembled. The unit is the same cut under small
    strain."""
    anew = {"Division/Solve": "every row anew"}
    unit = remembered(f"finite cut {n}, small strain", lambda: cut(n, SMALL))
    rows = []
    for ratio in (.2, .45, .49):
        for formulation in ("displacement", "mixed")[:1 if ratio < .45 else 2]:
            values = {"Material/Poisson's ratio": ratio,
                      "Material/Formulation": formulation}
            rows.append([ratio, formulation, *(number(remembered(
                f"finite cut {n}, {ratio}, {formulation}, {name}",
                lambda: cut(n, {**values, **way})) / unit)
                for name, way in (("default", {}), ("anew", anew)))])
    return (table(["Poisson's ratio", "formulation", "time", "every row anew"], rows)
            + f"\n\nThe unit is {unit:.2g} s.")
