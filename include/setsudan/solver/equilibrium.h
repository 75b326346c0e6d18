#pragma once

#include <setsudan/elasticity/elastic_model.h>
#include <setsudan/solver/linear_solver.h>

namespace Setsudan
{
/**
 * The body's equilibrium for one set of constraints: the assembled and
 * prepared matrix, which any number of loads are solved with.
 */
template <int dim>
class Equilibrium
{
public:
  /**
   * @param constraints homogeneous and closed. Their local lines name every
   * unknown that a constraint of this process couples.
   */
  Equilibrium(ElasticModel<dim> &model,
              const dealii::AffineConstraints<double> &constraints,
              const SolverParameters &parameters);

  /**
   * The displacement under nodal forces.
   *
   * @param forces      without ghosts, no constraint applied.
   * @param prescribed  any displacement that obeys what is prescribed (the
   *   opening of a cut) besides the homogeneous constraints.
   * @param guess       a displacement near the solution.
   * @throw SolverError where the solver fails or its result does not fulfil
   *   the equations.
   */
  LA::Vector
  solve(const LA::Vector &forces,
        const LA::Vector &prescribed,
        const LA::Vector &guess);

  /** The residual that the last solve left, relative to the loads: round-off,
   * which is large where the stiffness is very uneven. */
  double
  relative_residual() const;

private:
  /** Solve for the condensed loads, and improve the solution as long as that
   * lowers the residual. */
  LA::Vector
  solve_condensed(const LA::Vector &b, const LA::Vector &guess);

  [[noreturn]] void
  fail() const;

  ElasticModel<dim> &model;
  const dealii::AffineConstraints<double> &constraints;
  LA::SparseMatrix matrix;
  /** Behind the matrix, which must outlive it. */
  std::unique_ptr<LinearSolver> solver;
  double residual_of_last = 0;
};
} // namespace Setsudan
