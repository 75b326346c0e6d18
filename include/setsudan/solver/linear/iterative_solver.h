// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <setsudan/solver/linear/algebraic_multigrid.h>
#include <setsudan/solver/linear/linear_solver.h>

#include <string>
#include <vector>

namespace Setsudan
{
/** Conjugate gradients, preconditioned by algebraic multigrid. */
class IterativeSolver : public LinearSolver
{
public:
  explicit IterativeSolver(const SolverParameters &parameters);

  void
  initialize(const LA::SparseMatrix &matrix,
             const std::vector<std::vector<double>> &rigid_modes) override;

  void
  solve(LA::Vector &x, const LA::Vector &b) override;

  void
  approximate(LA::Vector &x, const LA::Vector &b) override;

  bool
  is_iterative() const override;

private:
  const SolverParameters parameters;
  const LA::SparseMatrix *matrix = nullptr;
  AlgebraicMultigrid multigrid;
};
} // namespace Setsudan
