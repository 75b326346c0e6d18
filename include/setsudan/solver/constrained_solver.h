// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <setsudan/mechanics/elastic_model.h>
#include <setsudan/solver/solver_parameters.h>
#include <setsudan/solver/tangent_solver.h>

namespace Setsudan
{
/** A tangent solver that condenses the constraints into the system of equations
 * and solves that, from the lift on; in which way is left to derived classes.
 */
template <int dim>
class ConstrainedSolver : public TangentSolver
{
public:
  /**
   * @param constraints homogeneous and closed, which must live as long. Their
   * local lines name every unknown that a constraint of this process couples.
   */
  ConstrainedSolver(const ElasticModel<dim> &model,
                    const dealii::AffineConstraints<double> &constraints,
                    const SolverParameters &parameters);

  Solution
  solve(const LA::Vector &forces,
        const LA::Vector &lift,
        const LA::Vector &guess) override;

  /** Solve K d = r for a residual, with no constraint applied.
   *
   * @param guess   of d.
   * @param quality is set. */
  LA::Vector
  increment(const LA::Vector &residual,
            const LA::Vector &guess,
            SolveQuality &quality);

protected:
  /** Solve for condensed loads; constrained entries of the result have no
   * meaning.
   *
   * @param quality is set. */
  virtual LA::Vector
  solve_condensed(const LA::Vector &b,
                  const LA::Vector &guess,
                  SolveQuality &quality) = 0;

  const ElasticModel<dim> &model;
  const dealii::AffineConstraints<double> &constraints;
  /** The relative residual that is accepted. */
  const double accepted;
};
} // namespace Setsudan
