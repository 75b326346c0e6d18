// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <setsudan/solver/linear/linear_solver.h>

#include <memory>
#include <optional>
#include <vector>

namespace Setsudan
{
/** Sparse factorization by MUMPS in its symmetric form, over several
 * processes. */
class MumpsSolver : public LinearSolver
{
public:
  /**
   * @param spare_percent workspace that MUMPS gets beyond its estimate. Over
   *   several processes its need depends on which of them is ready first, and
   *   the estimate may fall short; then the factorization is repeated with
   *   more.
   * @param is_definite whether another matrix than a positive definite one is
   *   a mistake.
   */
  explicit MumpsSolver(const int spare_percent = 50,
                       const bool is_definite  = true);

  ~MumpsSolver() override;

  void
  initialize(const LA::SparseMatrix &matrix,
             const std::vector<std::vector<double>> &rigid_modes) override;

  void
  solve(LA::Vector &x, const LA::Vector &b) override;

  /** How many eigenvalues of the matrix are negative. */
  unsigned int
  n_negative() const;

private:
  class Instance;

  const int spare_percent;
  const bool is_definite;
  std::unique_ptr<Instance> mumps;
};
} // namespace Setsudan
