// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <setsudan/solver/linear/cholesky_factor.h>
#include <setsudan/solver/linear/linear_solver.h>

#include <memory>
#include <string>
#include <utility>
#include <vector>

namespace Setsudan
{
/** The supernodal Cholesky factorization of CHOLMOD, on one process. The order
 * of elimination is found once for all matrices with as many entries. */
class CholeskySolver : public LinearSolver
{
public:
  void
  initialize(const LA::SparseMatrix &matrix,
             const std::vector<std::vector<double>> &rigid_modes) override;

  void
  solve(LA::Vector &x, const LA::Vector &b) override;

private:
  std::unique_ptr<CholeskyFactor> factor;
  /** Unknowns, and entries, of the matrix that it is made for. */
  std::pair<std::size_t, std::size_t> size;
};
} // namespace Setsudan
