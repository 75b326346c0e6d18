// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <setsudan/space/linear_algebra.h>

#include <cholmod.h>

#include <memory>
#include <vector>

namespace Setsudan
{
/**
 * The supernodal Cholesky factor K = L L^T of a symmetric positive definite
 * matrix of one process, by CHOLMOD. The given unknowns are ordered last, so
 * that the trailing block of L is the Cholesky factor of their Schur
 * complement; the others are ordered by METIS.
 *
 * Chen, Davis, Hager and Rajamanickam 2008, ACM Transactions on Mathematical
 * Software 35(3), article 22.
 */
class CholeskyFactor
{
public:
  /**
   * Of a part of a matrix, whose other unknowns have nothing to do with it.
   *
   * @param first the unknowns that METIS orders, ascending.
   * @param last  those that come last, in this order.
   * @param shift what is added to their entries of the diagonal.
   * @throw SolverError where the matrix is not positive definite, or memory
   *   runs out.
   */
  CholeskyFactor(const LA::SparseMatrix &matrix,
                 const std::vector<unsigned int> &first,
                 const std::vector<unsigned int> &last,
                 const double shift);

  /** Of a whole matrix. */
  explicit CholeskyFactor(const LA::SparseMatrix &matrix);

  ~CholeskyFactor();

  /**
   * Take another matrix with entries in the same places, in the same order of
   * elimination.
   *
   * @param shift as for the constructor.
   * @throw NotDefiniteError as the constructor; another matrix may follow. */
  void
  update(const LA::SparseMatrix &matrix, const double shift = 0);

  /** A vector in the order of elimination. */
  std::vector<double>
  in_order(const LA::Vector &vector) const;

  /** The opposite of in_order(); unknowns of other parts stay. */
  void
  from_order(const std::vector<double> &ordered, LA::Vector &vector) const;

  /** Entries of L. */
  double
  n_entries() const;

  /**
   * Forward elimination of all but the last unknowns: from a right-hand side b
   * in the order of elimination compute L^-1 b, with the condensed right-hand
   * side of the last at its end.
   */
  void
  forward_eliminate(std::vector<double> &x) const;

  /**
   * Back substitution: from the result of forward_eliminate(), with the last
   * unknowns' values put at its end, compute all values.
   */
  void
  back_substitute(std::vector<double> &x) const;

  /** L of the last unknowns, n_last x n_last by columns, 0 above the
   * diagonal. */
  std::vector<double>
  last_block() const;

private:
  struct Workspace;

  /** The lower half of a matrix in the order of elimination, with the shift. */
  cholmod_sparse *
  in_order(const LA::SparseMatrix &matrix, const double shift) const;

  void
  factorize(cholmod_sparse *lower);

  std::unique_ptr<Workspace> workspace;
  /** The unknown that is eliminated at each place. */
  std::vector<int> order;
  const unsigned int n_at_end;
  /** Where each unknown of the matrix is in the order; -1 for those of other
   * parts. */
  std::vector<int> place;
};
} // namespace Setsudan
