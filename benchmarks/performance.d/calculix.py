"""CalculiX on the decks that the program writes."""

import csv
import pathlib

import measure

SOLVERS = {"SPOOLES": "SPOOLES", "scaled conjugate gradients": "ITERATIVE SCALING",
           "conjugate gradients with incomplete Cholesky": "ITERATIVE CHOLESKY"}


def displacements(path):
    """What CalculiX prints, by node."""
    found = {}
    with open(path) as lines:
        for line in lines:
            words = line.split()
            if len(words) == 4 and words[0].isdigit():
                found[words[0]] = [float(word) for word in words[1:]]
    return found


def difference(deck):
    """The largest difference from the program's own displacement, relative to the
    largest displacement."""
    found = displacements(deck.with_suffix(".dat"))
    with open(deck.with_suffix(".csv"), newline="") as table:
        own = {row["node"]: [float(row[u]) for u in ("ux", "uy", "uz")]
               for row in csv.DictReader(table)}
    largest = max(abs(u) for node in own.values() for u in node)
    return max(abs(u - v) for node in own
               for u, v in zip(own[node], found[node])) / largest


def solve(deck, solver):
    """Seconds, memory in MB, and how far the displacements are from the program's."""
    text = deck.read_text()
    job = deck.with_name(f"{deck.stem}_{solver.replace(' ', '_')}.inp")
    job.write_text(text.replace("*STATIC\n", f"*STATIC, SOLVER={solver}\n"))
    job.with_suffix(".csv").write_bytes(deck.with_suffix(".csv").read_bytes())
    seconds, memory, said = measure.timed(["ccx", job.stem], job.parent,
                                          OMP_NUM_THREADS="2")
    if "*ERROR" in said:
        raise RuntimeError(said[-2000:])
    return seconds, memory, difference(job)


def decks(scene, values, directory):
    """The decks of a run's states."""
    measure.program(scene, {**values, "Output/CalculiX decks": "true"}, directory)
    return sorted(pathlib.Path(directory).glob("stage_*.inp"))
