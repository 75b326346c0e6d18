# SPDX-License-Identifier: LGPL-2.1-or-later
"""What the problems in DOLFINx 0.5 have in common: a block that stands on its bottom, on
serendipity hexahedra, and conjugate gradients."""

import dolfinx.la
import numpy
import ufl
from dolfinx import fem, mesh
from petsc4py import PETSc

# Three Gauss points in each direction.
INTEGRATION = {"quadrature_degree": 5}

# Jacobi and not SOR, which is PETSc's default: with it GAMG fails, and ML takes longer.
SETTINGS = {"ksp_type": "cg", "ksp_norm_type": "unpreconditioned",
            "ksp_max_it": 1000, "mg_levels_ksp_type": "chebyshev",
            "mg_levels_ksp_chebyshev_esteig_steps": 20, "mg_levels_pc_type": "jacobi"}


def faces(body, numbers):
    """The measure of which (1) is on faces of these numbers."""
    return ufl.Measure("ds", domain=body, metadata=INTEGRATION,
                       subdomain_data=mesh.meshtags(body, 2, numpy.sort(numbers), 1))


def fixed_bottom(space):
    bottom = mesh.locate_entities_boundary(space.mesh, 2,
                                           lambda x: numpy.isclose(x[2], 0))
    # These elements take no constant as a boundary value, but a function.
    return [fem.dirichletbc(fem.Function(space),
                            fem.locate_dofs_topological(space, 2, bottom))]


def rigid_modes(space):
    """The shifts along the axes and the rotations around them, orthonormal."""
    modes = []
    for axis in numpy.eye(3):
        for field in (lambda x: numpy.outer(axis, numpy.ones_like(x[0])),
                      lambda x: numpy.cross(axis, x.T).T):
            mode = fem.Function(space)
            mode.interpolate(field)
            # A function's own vector does not outlive it.
            modes.append(mode.vector.copy())
    dolfinx.la.orthonormalize(modes)
    return PETSc.NullSpace().create(vectors=modes, comm=space.mesh.comm)


def make_solver(matrix, multigrid, tolerance):
    """Conjugate gradients with one of PETSc's algebraic multigrids, to a relative
    residual."""
    options = PETSc.Options()
    for name, value in {**SETTINGS, "ksp_rtol": tolerance,
                        "pc_type": multigrid}.items():
        options[name] = value
    solver = PETSc.KSP().create(matrix.comm)
    solver.setFromOptions()
    solver.setOperators(matrix)
    return solver
