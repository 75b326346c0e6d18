// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <setsudan/mechanics/elastic_model.h>
#include <setsudan/solver/solver_choice.h>
#include <setsudan/solver/tangent_solver.h>

#include <memory>
#include <string>

namespace Setsudan
{
template <int dim>
class AssembledSolver;
template <int dim>
class MatrixFreeSolver;

/** A tangent solver by multigrid without a matrix, or by one of the assembled
 * matrix from where multigrid fails on. */
template <int dim>
class FallbackSolver : public TangentSolver
{
public:
  using Constraints = dealii::AffineConstraints<double>;

  /**
   * @param kind the solver that is tried first.
   * @param last the solver for the same model under other constraints, of which
   *   is kept what serves here; or nothing.
   */
  FallbackSolver(const ElasticModel<dim> &model,
                 std::shared_ptr<const Constraints> constraints,
                 const SolverParameters &parameters,
                 const SolverKind kind,
                 const FallbackSolver<dim> *last = nullptr);

  ~FallbackSolver() override;

  Solution
  solve(const LA::Vector &forces,
        const LA::Vector &lift,
        const LA::Vector &guess) override;

  /** Whether multigrid has failed in this solver. */
  bool
  has_fallen_back() const;

private:
  void
  assemble(const SolverKind kind);

  const ElasticModel<dim> &model;
  const std::shared_ptr<const Constraints> constraints;
  const SolverParameters parameters;
  std::unique_ptr<MatrixFreeSolver<dim>> multigrid;
  std::unique_ptr<AssembledSolver<dim>> assembled;
  bool fell_back = false;
};
} // namespace Setsudan
