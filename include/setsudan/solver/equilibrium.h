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

private:
  ElasticModel<dim> &model;
  const dealii::AffineConstraints<double> &constraints;
  LA::SparseMatrix matrix;
  /** Behind the matrix, which must outlive it. */
  std::unique_ptr<LinearSolver> solver;
};
} // namespace Setsudan
