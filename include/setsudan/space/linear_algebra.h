// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <deal.II/lac/affine_constraints.h>
#include <deal.II/lac/trilinos_sparse_matrix.h>
#include <deal.II/lac/trilinos_vector.h>

/** The matrices and vectors of the house, distributed over the processes; see
 * deal.II's glossary on ghosted vectors. */
namespace Setsudan::LA
{
using Vector       = dealii::TrilinosWrappers::MPI::Vector;
using SparseMatrix = dealii::TrilinosWrappers::SparseMatrix;
} // namespace Setsudan::LA

namespace Setsudan
{
/**
 * Evaluate the constraints: compute constrained from unconstrained entries, as
 * AffineConstraints::distribute() does, which copies the vector even where
 * there is one process.
 */
void
distribute(const dealii::AffineConstraints<double> &constraints,
           LA::Vector &vector);

/** Hand forces on constrained unknowns on to those that they depend on.
 *
 * @param forces without ghosts, as is the result. */
LA::Vector
condense(const dealii::AffineConstraints<double> &constraints,
         const LA::Vector &forces);

/** A matrix or vector with all of its rows on the first process, where columns
 * have the numbers of their unknowns. Collective; a copy on one process. */
LA::SparseMatrix
gather(const LA::SparseMatrix &matrix);
LA::Vector
gather(const LA::Vector &vector);

/** The opposite of gather(): set the entries of a vector. */
void
scatter(const LA::Vector &gathered, LA::Vector &vector);
} // namespace Setsudan
