// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <setsudan/solver/condensed/schur_complement.h>
#include <setsudan/solver/linear/cholesky_factor.h>

#include <functional>
#include <memory>
#include <utility>
#include <vector>

namespace Setsudan
{
/**
 * Static condensation of a stiffness matrix onto the interface, the unknowns of
 * a cut, once for all loads and all stages of the cut.
 *
 * Each connected component of the matrix, as the two sides of a cut before they
 * are tied, has a factor of its own; they are worked on in parallel.
 */
class StaticCondensation
{
public:
  /** @param cut ascending.
   * @throw SolverError where the rest is not positive definite. */
  StaticCondensation(const LA::SparseMatrix &matrix,
                     const std::vector<unsigned int> &cut);

  /** Take another matrix with entries in the same places; it takes no new order
   * of elimination.
   *
   * @throw SolverError as the constructor; another matrix may follow. */
  void
  update(const LA::SparseMatrix &matrix);

  /** The Schur complement, numbered as in the cut. */
  const SchurComplement &
  stiffness() const;

  /** Add a foundation under the cut, the sum of v v^T: see
   * SchurComplement::add_square(). */
  void
  add_foundation(
    const std::vector<std::vector<std::pair<unsigned int, double>>> &springs);

  /** Loads that have been brought to the cut. */
  struct Eliminated
  {
    /** In each part's order of elimination. */
    std::vector<std::vector<double>> of_parts;
    /** The forces on the cut. */
    std::vector<double> on_cut;
  };

  Eliminated
  forward_eliminate(const LA::Vector &loads) const;

  /** The displacement x off the cut from that of the cut, and on it. */
  void
  back_substitute(Eliminated loads,
                  const std::vector<double> &of_cut,
                  LA::Vector &x) const;

private:
  struct Part
  {
    std::unique_ptr<CholeskyFactor> factor;
    /** Its unknowns of the cut, by their places there. */
    std::vector<unsigned int> of_cut;
  };

  /** Factor a part, whose unknowns are given, and find its block of the
   * stiffness. */
  SchurComplement::Block
  factorize(const LA::SparseMatrix &matrix,
            const std::vector<unsigned int> &unknowns,
            const double shift,
            Part &part) const;

  /** Make the complement of the blocks of all parts. */
  void
  take_blocks(
    const std::function<SchurComplement::Block(unsigned int)> &block_of);

  const std::vector<unsigned int> cut;
  std::vector<Part> parts;
  /** Whether each is best left to one core. */
  bool parts_are_alike = false;
  std::unique_ptr<SchurComplement> complement;
  /** Whether threads take less time than they cost to begin. */
  bool is_large = false;
};
} // namespace Setsudan
