# SPDX-License-Identifier: LGPL-2.1-or-later
"""Other programs on the same work."""

import functools
import pathlib
import subprocess
import tempfile

import calculix
import measure
from measure import program, remembered

HERE = pathlib.Path(__file__).resolve().parent
CORES = 2

# How CalculiX calls its solvers.
CALCULIX = {"SPOOLES": "SPOOLES", "scaled conjugate gradients": "ITERATIVE SCALING",
            "conjugate gradients with incomplete Cholesky": "ITERATIVE CHOLESKY"}

# How PETSc, with which DOLFINx solves, calls its algebraic multigrids.
DOLFINX = {"conjugate gradients with ML": "ml", "conjugate gradients with GAMG": "gamg"}


def decks(scene, values, directory):
    """The decks for CalculiX of a run's states."""
    program(scene, {**values, "Output/CalculiX decks": "true"}, directory)
    return sorted(directory.glob("stage_*.inp"))


def solve_by_calculix(deck, solver):
    """Seconds, memory in MB, and how far the displacements are from the program's."""
    job = deck.with_name(f"{deck.stem}_{solver.replace(' ', '_')}.inp")
    job.write_text(deck.read_text().replace("*STATIC\n", f"*STATIC, SOLVER={solver}\n"))
    seconds, memory, said = measure.timed(["ccx", job.stem], job.parent,
                                          OMP_NUM_THREADS=str(CORES))
    if "*ERROR" in said:
        raise RuntimeError(said[-2000:])
    return seconds, memory, calculix.compare(job, deck.with_suffix(".csv"))[2]


def run_dolfinx(n, multigrid, n_processes, problem="solve"):
    """Seconds, memory in MB of the larger process, and what is found."""
    with tempfile.TemporaryDirectory() as directory:
        found = pathlib.Path(directory) / "found"
        # Debian's own Python has Debian's packages; another may come before it.
        command = [*measure.processes(n_processes), "/usr/bin/python3", "-B",
                   HERE / f"dolfinx_{problem}.py", n, multigrid, found]
        seconds, memory, _ = measure.timed(command,
                                           OMP_NUM_THREADS=str(CORES // n_processes))
        return seconds, memory, measure.values_in(found.read_text())


def has_dolfinx():
    return subprocess.run(["/usr/bin/python3", "-c", "import dolfinx"],
                          stderr=subprocess.DEVNULL).returncode == 0


@functools.cache
def warm_up_dolfinx(problem="solve"):
    """DOLFINx compiles its forms in the first run ever, the same for all sizes."""
    run_dolfinx(2, "ml", 1, problem)


def solve_by_dolfinx(n, name, n_processes):
    """What run_dolfinx gives or gave, once the forms are compiled."""
    def run():
        warm_up_dolfinx()
        return run_dolfinx(n, DOLFINX[name], n_processes)
    return remembered(f"one solve {n}, DOLFINx, {name} on {n_processes}", run)
