// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <setsudan/mechanics/elastic_model.h>
#include <setsudan/solver/solver_parameters.h>
#include <setsudan/solver/tangent_solver.h>

#include <deal.II/lac/affine_constraints.h>

#include <memory>

namespace Setsudan
{
template <int dim>
class CondensedSolver;

/**
 * Solves F(u) = f for a body whose laws are not linear, by Newton's method with
 * the assembled tangent, or with conjugate gradients on one that is not
 * assembled (TangentIteration).
 *
 * What has changed since the state that a solve starts from, loads, ties and
 * what is prescribed, is applied at once; where that fails, in parts: the
 * residual of that state under the new constraints is what it still lacks, and
 * is taken off in proportion. Each part is tried with a tangent whose stress is
 * extrapolated (see LawIntegration), then with the exact one and a line search.
 *
 * An equilibrium whose tangent is not positive definite is not stable, and is
 * none of those that a body takes; neither is, under finite strain, one that
 * turns an element inside out at a node.
 *
 * A plastic body goes from the last accepted state to each one in a single step
 * of its laws, whatever is tried on the way.
 */
template <int dim>
class NewtonSolver : public TangentSolver
{
public:
  using Constraints = dealii::AffineConstraints<double>;

  /** @param model must live as long.
   * @param constraints homogeneous and closed.
   * @param factor of the cut that the constraints belong to, with which
   *   conjugate gradients are preconditioned (see TangentIteration); or
   *   nothing. */
  NewtonSolver(const ElasticModel<dim> &model,
               std::shared_ptr<const Constraints> constraints,
               const SolverParameters &parameters,
               std::shared_ptr<CondensedSolver<dim>> factor = nullptr);

  /**
   * As the base.
   *
   * @param start a displacement that has been solved for, or that of the body
   *   at rest.
   * @throw NoEquilibriumError where there is none that can be reached; it says
   *   how far the way could be followed, and where the body gives way.
   */
  Solution
  solve(const LA::Vector &forces,
        const LA::Vector &lift,
        const LA::Vector &start) override;

private:
  const ElasticModel<dim> &model;
  const std::shared_ptr<const Constraints> constraints;
  const SolverParameters parameters;
  const std::shared_ptr<CondensedSolver<dim>> factor;
};
} // namespace Setsudan
