#pragma once

#include <setsudan/solver/linear/linear_solver.h>

#include <Epetra_LinearProblem.h>

#include <memory>
#include <string>
#include <vector>

class Amesos_BaseSolver;
class Amesos_Mumps;

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
  /** Up to this number of unknowns KLU's whole solve is a few milliseconds. */
  static constexpr unsigned int small_size = 1500;

  /**
   * @param spare_percent workspace that MUMPS gets beyond its estimate. Over
   *   several processes its need depends on which of them is ready first, and
   *   the estimate may fall short; then the factorization is repeated with
   *   more.
   */
  explicit DirectSolver(const dealii::types::global_dof_index n_unknowns,
                        const int spare_percent = 50);

  ~DirectSolver() override;

  void
  initialize(const LA::SparseMatrix &matrix,
             const std::vector<std::vector<double>> &rigid_modes) override;

  void
  solve(LA::Vector &x, const LA::Vector &b) override;

  std::string
  description() const override;

private:
  /** Factorize by MUMPS.
   *
   * @return whether the workspace sufficed. */
  bool
  factorize_with_mumps(const int percent);

  const bool small;
  const int spare_percent;
  Epetra_LinearProblem problem;
  std::unique_ptr<Amesos_BaseSolver> amesos;
};
} // namespace Setsudan
