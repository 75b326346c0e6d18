// SPDX-License-Identifier: LGPL-2.1-or-later
#include <setsudan/solver/linear/cholesky_solver.h>

namespace Setsudan
{
void
CholeskySolver::initialize(const LA::SparseMatrix &matrix,
                           const std::vector<std::vector<double>> &)
{
  const std::pair<std::size_t, std::size_t> of_matrix(
    matrix.m(), matrix.n_nonzero_elements());
  if (factor && of_matrix == size)
    {
      factor->update(matrix);
      return;
    }
  factor.reset();
  factor = std::make_unique<CholeskyFactor>(matrix);
  size   = of_matrix;
}



void
CholeskySolver::solve(LA::Vector &x, const LA::Vector &b)
{
  std::vector<double> ordered = factor->in_order(b);
  factor->forward_eliminate(ordered);
  factor->back_substitute(ordered);
  factor->from_order(ordered, x);
}
} // namespace Setsudan
