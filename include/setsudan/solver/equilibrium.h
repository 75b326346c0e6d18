#pragma once

#include <setsudan/solver/constrained_equilibrium.h>
#include <setsudan/solver/linear/linear_solver.h>

#include <memory>
#include <string>

namespace Setsudan
{
/**
 * The body's equilibrium for one set of constraints: the assembled and
 * prepared matrix, which any number of loads are solved with.
 */
template <int dim>
class Equilibrium : public ConstrainedEquilibrium<dim>
{
public:
  /** As the base. */
  Equilibrium(ElasticModel<dim> &model,
              const dealii::AffineConstraints<double> &constraints,
              const SolverParameters &parameters);

  /** The solver, in words. */
  std::string
  description() const;

private:
  /** Solve for the condensed loads, and improve the solution as long as that
   * lowers the residual. */
  LA::Vector
  solve_condensed(const LA::Vector &b, const LA::Vector &guess) override;

  [[noreturn]] void
  fail() const;

  using ConstrainedEquilibrium<dim>::model;
  using ConstrainedEquilibrium<dim>::constraints;
  using ConstrainedEquilibrium<dim>::accepted;
  using ConstrainedEquilibrium<dim>::quality;

  LA::SparseMatrix matrix;
  /** Behind the matrix, which must outlive it. */
  std::unique_ptr<LinearSolver> solver;
};
} // namespace Setsudan
