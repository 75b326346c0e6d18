// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <deal.II/lac/lapack_full_matrix.h>

#include <vector>

namespace Setsudan
{
/** The factors L D L^T of a dense symmetric matrix, with the pivots of Bunch
 * and Kaufman (LAPACK): it need not be definite, and they tell whether it is.
 */
class SymmetricFactor
{
public:
  /** @param matrix square, of which the lower half is read.
   * @throw SolverError where it is singular. */
  explicit SymmetricFactor(dealii::LAPACKFullMatrix<double> &&matrix);

  /** How many of its eigenvalues are negative. */
  unsigned int
  n_negative() const;

  /** Solve for all columns of a matrix, in their place. */
  void
  solve(dealii::LAPACKFullMatrix<double> &columns) const;
  void
  solve(std::vector<double> &column) const;

private:
  void
  solve(double *columns, const unsigned int n_columns) const;

  mutable dealii::LAPACKFullMatrix<double> factor;
  std::vector<int> pivots;
};
} // namespace Setsudan
