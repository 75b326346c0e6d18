// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <setsudan/mechanics/elastic_model.h>
#include <setsudan/parameters/exceptions.h>
#include <setsudan/solver/solver_parameters.h>

#include <deal.II/lac/affine_constraints.h>

#include <functional>
#include <optional>

namespace Setsudan
{
/** Whether an attempt to go on succeeds.
 *
 * @param failure of a linear solve that was in its way; is set. A tangent that
 *   is not positive definite is none: the state would not be stable. */
bool
succeeds(const std::function<bool()> &attempt,
         std::optional<SolverError> &failure);

/**
 * Follow the way from one equilibrium to another: all of it at once, and where
 * that fails in parts, which are halved down to 1/256.
 *
 * @param go_on to a part of the way from the part that is behind; it tells in
 *   how many steps, or nothing where it fails.
 * @return the part that has been reached: 1 for all of it.
 */
double
follow_in_parts(
  const std::function<std::optional<unsigned int>(double behind, double part)>
    &go_on);

/** Say how far a way could be followed, and where the body gives way.
 *
 * @param last the displacement of the last state that was reached, without
 *   ghosts.
 * @param part of the way to it.
 * @throw NoEquilibriumError always. */
template <int dim>
[[noreturn]] void
throw_no_equilibrium(const ElasticModel<dim> &model,
                     const dealii::AffineConstraints<double> &constraints,
                     const SolverParameters &parameters,
                     const LA::Vector &last,
                     const double part);
} // namespace Setsudan
