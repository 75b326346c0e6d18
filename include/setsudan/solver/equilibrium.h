#pragma once

#include <setsudan/elasticity/elastic_model.h>
#include <setsudan/solver/equilibrium_solver.h>
#include <setsudan/solver/linear_solver.h>

namespace Setsudan
{
/**
 * The body's equilibrium for one set of constraints: the assembled and
 * prepared matrix, which any number of loads are solved with.
 */
template <int dim>
class Equilibrium : public EquilibriumSolver
{
public:
  /**
   * @param constraints homogeneous and closed. Their local lines name every
   * unknown that a constraint of this process couples.
   */
  Equilibrium(ElasticModel<dim> &model,
              const dealii::AffineConstraints<double> &constraints,
              const SolverParameters &parameters);

  LA::Vector
  solve(const LA::Vector &forces,
        const LA::Vector &prescribed,
        const LA::Vector &guess) override;

  SolveQuality
  quality_of_last() const override;

  /** The solver, in words. */
  std::string
  description() const;

private:
  /** Solve for the condensed loads, and improve the solution as long as that
   * lowers the residual. */
  LA::Vector
  solve_condensed(const LA::Vector &b, const LA::Vector &guess);

  [[noreturn]] void
  fail() const;

  ElasticModel<dim> &model;
  const dealii::AffineConstraints<double> &constraints;
  /** The residual with which a solve is content. */
  const double accepted;
  LA::SparseMatrix matrix;
  /** Behind the matrix, which must outlive it. */
  std::unique_ptr<LinearSolver> solver;
  SolveQuality quality;
};
} // namespace Setsudan
