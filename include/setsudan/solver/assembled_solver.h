// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <setsudan/solver/constrained_solver.h>
#include <setsudan/solver/linear/linear_solver.h>
#include <setsudan/solver/solver_choice.h>

#include <memory>

namespace Setsudan
{
/** A tangent solver with the assembled matrix, which any number of loads are
 * solved with. */
template <int dim>
class AssembledSolver : public ConstrainedSolver<dim>
{
public:
  /** As the base. In a linear body it is ready; in others linearize() comes
   * first.
   *
   * @param kind any of which the matrix is assembled. */
  AssembledSolver(const ElasticModel<dim> &model,
                  const dealii::AffineConstraints<double> &constraints,
                  const SolverParameters &parameters,
                  const SolverKind kind);

  /** Take the tangent about another displacement.
   *
   * @throw NotDefiniteError where it is not positive definite; of an iterative
   *   solver solves do. */
  void
  linearize(const Linearization &linearization);

  /** See round_off_of_forces(). */
  double
  round_off() const;

private:
  /** Solve, with iterative refinement. */
  LA::Vector
  solve_condensed(const LA::Vector &b,
                  const LA::Vector &guess,
                  SolveQuality &quality) override;

  [[noreturn]] void
  fail(const double residual) const;

  using ConstrainedSolver<dim>::model;
  using ConstrainedSolver<dim>::constraints;
  using ConstrainedSolver<dim>::accepted;

  const SolverKind kind;
  LA::SparseMatrix matrix;
  /** Behind the matrix, which must outlive it. */
  std::unique_ptr<LinearSolver> solver;
};
} // namespace Setsudan
