#pragma once

#include <setsudan/space/linear_algebra.h>

#include <memory>
#include <vector>

namespace Setsudan
{
/**
 * The supernodal Cholesky factor K = L L^T of a symmetric positive definite
 * matrix of one process, by CHOLMOD, with some unknowns eliminated last: L
 * restricted to them is then the factor of what they are to each other once the
 * others are gone (the Schur complement). The others are ordered by METIS.
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

  /** A vector in the order of elimination. */
  std::vector<double>
  in_order(const LA::Vector &vector) const;

  /** The opposite of in_order(); unknowns of other parts stay. */
  void
  from_order(const std::vector<double> &ordered, LA::Vector &vector) const;

  /** Entries of L. */
  double
  n_entries() const;

  /** Eliminate all but the last unknowns: of a right-hand side b in the order
   * of elimination make L^-1 b, and at its end what is left for the last. */
  void
  forward_eliminate(std::vector<double> &x) const;

  /** Of what forward_eliminate() has made, with the last unknowns' values put
   * at its end, make the values of all. */
  void
  back_substitute(std::vector<double> &x) const;

  /** L of the last unknowns, n_last x n_last by columns, 0 above the
   * diagonal. */
  std::vector<double>
  last_block() const;

private:
  struct Workspace;

  std::unique_ptr<Workspace> workspace;
  /** The unknown that is eliminated at each place. */
  std::vector<int> order;
  const unsigned int n_at_end;
  /** Where each unknown of the matrix is in the order; -1 for those of other
   * parts. */
  std::vector<int> place;
};
} // namespace Setsudan
