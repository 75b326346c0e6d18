// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <deal.II/base/aligned_vector.h>
#include <deal.II/lac/lapack_full_matrix.h>

#include <functional>
#include <vector>

namespace Setsudan
{
/**
 * The Cholesky factor of a dense matrix that grows by rows and columns at its
 * end; those before stay factored.
 */
class IncrementalCholesky
{
public:
  /** @param most how many unknowns there may be in the end. */
  explicit IncrementalCholesky(const unsigned int most);

  unsigned int
  size() const;

  /**
   * Add unknowns.
   *
   * @param entry the matrix at a row and a column, asked for in each new row up
   *   to the diagonal.
   * @throw SolverError where the matrix is not positive definite.
   */
  void
  append(const unsigned int n_new,
         const std::function<double(unsigned int, unsigned int)> &entry);

  /** Forget the last unknowns. */
  void
  shrink(const unsigned int n);

  /** Solve for the first unknowns, as many as x has. */
  void
  solve(std::vector<double> &x) const;

  /** Replace vectors b, the columns of a matrix of size() rows, by L^-1 b,
   * where L is the factor. */
  void
  solve_lower(dealii::LAPACKFullMatrix<double> &b) const;

private:
  const unsigned int most;
  unsigned int n = 0;
  /** By columns of length `most`; from the diagonal on. The rest is not
   * written, so that it takes no memory. */
  dealii::AlignedVector<double> factor;
};
} // namespace Setsudan
