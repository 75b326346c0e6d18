// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <setsudan/mechanics/elastic_model.h>
#include <setsudan/solver/solver_choice.h>
#include <setsudan/solver/tangent_solver.h>

#include <deal.II/lac/affine_constraints.h>

#include <memory>
#include <string>

namespace Setsudan
{
/** An equilibrium to be found: F(u) = f under constraints, where F are the
 * internal forces of the model and u has what the lift has. */
template <int dim>
struct EquilibriumProblem
{
  const ElasticModel<dim> &model;
  /** Homogeneous and closed. */
  std::shared_ptr<const dealii::AffineConstraints<double>> constraints;
  /** External nodal forces, without ghosts, no constraint applied. */
  const LA::Vector &forces;
  /** A displacement that has what is prescribed. */
  LA::Vector lift;
};

/** One step from the lift, which is the solution of a linear body.
 *
 * @param guess a displacement near the solution. */
template <int dim>
Solution
solve_linear(const EquilibriumProblem<dim> &problem,
             TangentSolver &solver,
             const LA::Vector &guess);

/**
 * Newton's method with the assembled tangent of the model's laws.
 *
 * @param start a displacement, to which what is prescribed is added in the
 * first step.
 * @throw SolverError where the residual does not fall.
 */
template <int dim>
Solution
solve_newton(const EquilibriumProblem<dim> &problem,
             const SolverParameters &parameters,
             const LA::Vector &start);
} // namespace Setsudan
