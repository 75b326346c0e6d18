// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <setsudan/mechanics/elastic_model.h>
#include <setsudan/solver/solver_parameters.h>

#include <deal.II/lac/affine_constraints.h>

namespace Setsudan
{
/** The motion that a body resists least. */
template <int dim>
struct SoftestMode
{
  /** The node that moves most, at rest, and where to (to either side). */
  dealii::Point<dim> node;
  dealii::Tensor<1, dim> direction;
};

/** The eigenvector of the tangent whose eigenvalue is nearest to 0, by inverse
 * iteration; the same on all processes.
 *
 * @param displacement about which the tangent is. */
template <int dim>
SoftestMode<dim>
softest_mode(const ElasticModel<dim> &model,
             const dealii::AffineConstraints<double> &constraints,
             const SolverParameters &parameters,
             const LA::Vector &displacement);
} // namespace Setsudan
