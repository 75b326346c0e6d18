# SPDX-License-Identifier: LGPL-2.1-or-later
"""The problem of finite.prm in DOLFINx 0.5, in a process of its own or under mpirun:
dolfinx_finite.py N gamg|ml OUTPUT

Solves the block of N^3 elements with the same elements, integration points and law as the
program, by Newton's method in one increment, and writes the names and values of what it
finds to the file OUTPUT.
"""

import pathlib
import sys

import dolfinx_block
import numpy
import ufl
from dolfinx import fem, mesh
from dolfinx.fem import petsc
from mpi4py import MPI
from petsc4py import PETSc

# What finite.prm says.
SIZE = 10
YOUNGS_MODULUS = 5
POISSONS_RATIO = 0.2
TRACTION = (0, 0, -0.75)

# The residual at which Newton's method ends, relative to the first one, and that of each
# linear solve.
TOLERANCE = 1e-8
LINEAR_TOLERANCE = 1e-4
MOST_STEPS = 20


def forms(displacement):
    """The residual of isochoric neo-Hooke under a dead traction on the top, and its
    derivative."""
    space = displacement.function_space
    body = space.mesh
    inside = ufl.dx(metadata=dolfinx_block.INTEGRATION)
    mu = YOUNGS_MODULUS / 2 / (1 + POISSONS_RATIO)
    bulk = YOUNGS_MODULUS / 3 / (1 - 2 * POISSONS_RATIO)
    gradient = ufl.Identity(3) + ufl.grad(displacement)
    volume = ufl.det(gradient)
    energy = (mu / 2 * (volume ** (-2 / 3) * ufl.tr(gradient.T * gradient) - 3)
              + bulk / 2 * (volume - 1) ** 2)
    test = ufl.TestFunction(space)
    top = mesh.locate_entities_boundary(body, 2, lambda x: numpy.isclose(x[2], SIZE))
    residual = (ufl.derivative(energy * inside, displacement, test)
                - ufl.inner(fem.Constant(body, numpy.array(TRACTION, dtype=float)), test)
                * dolfinx_block.faces(body, top)(1))
    return fem.form(residual), fem.form(
        ufl.derivative(residual, displacement, ufl.TrialFunction(space)))


def assemble_residual(form, fixed):
    result = petsc.assemble_vector(form)
    result.ghostUpdate(addv=PETSc.InsertMode.ADD, mode=PETSc.ScatterMode.REVERSE)
    petsc.set_bc(result, fixed)
    return result


def solve(n, multigrid):
    """The names and values of what is found."""
    body = mesh.create_box(MPI.COMM_WORLD, [[0, 0, 0], [SIZE, SIZE, SIZE]], [n, n, n],
                           mesh.CellType.hexahedron)
    space = fem.VectorFunctionSpace(body, ("S", 2))
    displacement, step = fem.Function(space), fem.Function(space)
    residual_form, tangent_form = forms(displacement)
    fixed = dolfinx_block.fixed_bottom(space)
    tangent = petsc.create_matrix(tangent_form)
    tangent.setOption(PETSc.Mat.Option.SPD, True)
    tangent.setNearNullSpace(dolfinx_block.rigid_modes(space))
    solver = dolfinx_block.make_solver(tangent, multigrid, LINEAR_TOLERANCE)
    residual = assemble_residual(residual_form, fixed)
    first, iterations = residual.norm(), 0
    for n_steps in range(MOST_STEPS):
        if residual.norm() <= TOLERANCE * first:
            break
        tangent.zeroEntries()
        petsc.assemble_matrix(tangent, tangent_form, fixed)
        tangent.assemble()
        solver.setOperators(tangent)
        solver.solve(residual, step.vector)
        step.x.scatter_forward()
        iterations += solver.getIterationNumber()
        displacement.x.array[:] -= step.x.array
        residual = assemble_residual(residual_form, fixed)
    else:
        sys.exit("Newton's method does not converge.")
    owned = displacement.vector.array.reshape(-1, 3)
    largest = numpy.sqrt((owned ** 2).sum(axis=1)).max()
    return {"unknowns": residual.getSize(), "iterations": iterations, "steps": n_steps,
            "max_displacement": body.comm.allreduce(largest, MPI.MAX)}


def main():
    n, multigrid, output = sys.argv[1:]
    found = solve(int(n), multigrid)
    if MPI.COMM_WORLD.rank == 0:
        pathlib.Path(output).write_text(
            "".join(f"{name} {value!r}\n" for name, value in found.items()))


main()
