#pragma once

#include <setsudan/solver/linear_solver.h>

#include <Epetra_LinearProblem.h>

#include <memory>

class Amesos_BaseSolver;

namespace Setsudan
{
/**
 * Sparse factorization by Trilinos' Amesos: KLU for small systems, where
 * starting is what costs, and MUMPS in its symmetric form for the rest, which
 * also works over several processes.
 */
class DirectSolver : public LinearSolver
{
public:
  explicit DirectSolver(const dealii::types::global_dof_index n_unknowns);

  ~DirectSolver() override;

  void
  initialize(const LA::SparseMatrix &matrix,
             const std::vector<std::vector<double>> &rigid_modes) override;

  void
  solve(LA::Vector &x, const LA::Vector &b) override;

  std::string
  description() const override;

  bool
  is_iterative() const override;

private:
  const bool small;
  Epetra_LinearProblem problem;
  std::unique_ptr<Amesos_BaseSolver> amesos;
};
} // namespace Setsudan
