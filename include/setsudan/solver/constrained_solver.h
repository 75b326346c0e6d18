#pragma once

#include <setsudan/mechanics/elastic_model.h>
#include <setsudan/solver/solver_parameters.h>
#include <setsudan/solver/tangent_solver.h>

namespace Setsudan
{
/** The equilibrium for one set of constraints, but for the way in which the
 * condensed equations are solved. */
template <int dim>
class ConstrainedSolver : public TangentSolver
{
public:
  /**
   * @param constraints homogeneous and closed, which must live as long. Their
   * local lines name every unknown that a constraint of this process couples.
   */
  ConstrainedSolver(ElasticModel<dim> &model,
                    const dealii::AffineConstraints<double> &constraints,
                    const SolverParameters &parameters);

  LA::Vector
  solve(const LA::Vector &forces,
        const LA::Vector &prescribed,
        const LA::Vector &guess) override;

  SolveQuality
  quality_of_last() const override;

protected:
  /** Solve for condensed loads, and set the quality; what is constrained does
   * not matter in the result. */
  virtual LA::Vector
  solve_condensed(const LA::Vector &b, const LA::Vector &guess) = 0;

  ElasticModel<dim> &model;
  const dealii::AffineConstraints<double> &constraints;
  /** The residual with which a solve is content. */
  const double accepted;
  SolveQuality quality;
};
} // namespace Setsudan
