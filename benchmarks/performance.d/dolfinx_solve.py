# SPDX-License-Identifier: LGPL-2.1-or-later
"""The problem of solve.prm in DOLFINx 0.5, in a process of its own or under mpirun:
dolfinx_solve.py N gamg|ml OUTPUT

Solves the block of N^3 elements with the same elements, integration points and tolerance
as the program, and writes the names and values of what it finds to the file OUTPUT:
standard output is shared with whatever MPI and PETSc have to say. The mesh is made here
and not read from a file, which is in DOLFINx's favour.
"""

import pathlib
import sys
import time

import block
import dolfinx_block
import numpy
import ufl
from dolfinx import fem, mesh
from dolfinx.fem import petsc
from mpi4py import MPI
from petsc4py import PETSc

# What solve.prm says.
YOUNGS_MODULUS = 1
POISSONS_RATIO = 0.2
TRACTION = (0.003, 0.001, -0.01)

TOLERANCE = 1e-8


def make_block(n):
    """The body of block.py."""
    body = mesh.create_box(MPI.COMM_WORLD, [[0, 0, 0], [1, 1, 1]], [n, n, n],
                           mesh.CellType.hexahedron)
    points = body.geometry.x
    points[:] = [block.moved(point, n) for point in numpy.rint(points * n).tolist()]
    return body


def forms(space):
    """The bilinear form of elasticity, and the linear one of the traction on the top."""
    body = space.mesh
    mu = YOUNGS_MODULUS / 2 / (1 + POISSONS_RATIO)
    lame = 2 * mu * POISSONS_RATIO / (1 - 2 * POISSONS_RATIO)
    trial, test = ufl.TrialFunction(space), ufl.TestFunction(space)
    strain = ufl.sym(ufl.grad(trial))
    stress = 2 * mu * strain + lame * ufl.tr(strain) * ufl.Identity(3)
    top = mesh.locate_entities_boundary(body, 2, lambda x: numpy.isclose(x[2], 1))
    traction = fem.Constant(body, numpy.array(TRACTION))
    return (fem.form(ufl.inner(stress, ufl.sym(ufl.grad(test)))
                     * ufl.dx(metadata=dolfinx_block.INTEGRATION)),
            fem.form(ufl.inner(traction, test)
                     * dolfinx_block.faces(body, top)(1)))


def equations(space):
    """Matrix and load of the block that stands on its bottom."""
    stiffness, traction = forms(space)
    fixed = dolfinx_block.fixed_bottom(space)
    matrix = petsc.assemble_matrix(stiffness, fixed)
    matrix.assemble()
    matrix.setOption(PETSc.Mat.Option.SPD, True)
    load = petsc.assemble_vector(traction)
    load.ghostUpdate(addv=PETSc.InsertMode.ADD, mode=PETSc.ScatterMode.REVERSE)
    petsc.set_bc(load, fixed)
    return matrix, load


def solve(n, multigrid):
    """The names and values of what is found."""
    space = fem.VectorFunctionSpace(make_block(n), ("S", 2))
    matrix, load = equations(space)
    matrix.setNearNullSpace(dolfinx_block.rigid_modes(space))
    solver = dolfinx_block.make_solver(matrix, multigrid, TOLERANCE)
    displacement = load.duplicate()
    solver.solve(load, displacement)
    if solver.getConvergedReason() <= 0:
        sys.exit(f"PETSc gives up: reason {solver.getConvergedReason()}")
    residual = matrix * displacement - load
    return {"unknowns": load.getSize(), "strain_energy": load.dot(displacement) / 2,
            "iterations": solver.getIterationNumber(),
            "residual": residual.norm() / load.norm()}


def main():
    begin = time.monotonic()
    n, multigrid, output = sys.argv[1:]
    found = solve(int(n), multigrid)
    # Without the start of Python and of MPI.
    found["seconds"] = time.monotonic() - begin
    if MPI.COMM_WORLD.rank == 0:
        pathlib.Path(output).write_text(
            "".join(f"{name} {value!r}\n" for name, value in found.items()))


main()
