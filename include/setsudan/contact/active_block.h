// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <deal.II/lac/lapack_full_matrix.h>

#include <functional>
#include <vector>

namespace Setsudan
{
/**
 * The rows and columns of a dense matrix that belong to some of its numbers, as
 * those of active conditions, and their inverse.
 *
 * Where few numbers enter or leave from one block to the next the inverse is
 * bordered, or the border is taken off again: changes of rank one, in O(n^2)
 * each (Householder, "The Theory of Matrices in Numerical Analysis",
 * 1964, 5.1). A solution is refined with the block itself, so that it is as
 * accurate as one from a factorization; where the first residual says that the
 * inverse has become inaccurate, it is made anew.
 */
class ActiveBlock
{
public:
  /** The entry of a row and a column of the matrix. */
  using Entry = std::function<double(unsigned int, unsigned int)>;

  /** Rows and columns of these numbers.
   *
   * @param is_definite whether it is symmetric and positive definite. */
  void
  take(const std::vector<unsigned int> &numbers,
       const Entry &entry,
       const bool is_definite);

  /** The row and column of a number have changed: take() asks for them. */
  void
  forget(const unsigned int number);

  /** The numbers in the order of the block's rows. */
  const std::vector<unsigned int> &
  numbers() const
  {
    return members;
  }

  /** Solve for several right-hand sides, by columns, in the order of numbers().
   *
   * @throw dealii::LACExceptions::ExcSingular where the block is singular. */
  void
  solve(dealii::LAPACKFullMatrix<double> &right_and_solution);

private:
  /** The number of rows. */
  unsigned int
  n() const
  {
    return members.size();
  }

  /** Begin anew with no rows, and memory for so many. */
  void
  reserve(const unsigned int n);

  /** Make block and inverse anew. */
  void
  renew(const std::vector<unsigned int> &numbers, const Entry &entry);

  /** Make the inverse anew from the block. */
  void
  invert();
  bool
  invert_definite();
  bool
  invert_general();

  /** Take the border of a number off, or add one; false where the pivot says
   * that this were inaccurate. */
  bool
  leave(const unsigned int place);
  bool
  enter(const unsigned int number, const Entry &entry);

  /** Refine solutions that begin with those of the inverse; whether they are
   * accurate. */
  bool
  refine(const dealii::LAPACKFullMatrix<double> &right,
         dealii::LAPACKFullMatrix<double> &solution);

  std::vector<unsigned int> members;
  /** Whether the row and column of each member have changed. */
  std::vector<bool> changed;
  /** The block and its inverse, by columns of length `stride`. */
  std::vector<double> block;
  std::vector<double> inverse;
  unsigned int stride = 0;
  bool is_definite    = false;
  /** Whether there is an inverse, and whether the next one must be made anew.
   */
  bool has_inverse   = false;
  bool is_inaccurate = false;
};
} // namespace Setsudan
