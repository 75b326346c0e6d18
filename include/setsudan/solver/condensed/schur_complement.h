// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <utility>
#include <vector>

namespace Setsudan
{
/**
 * The Schur complement of the interface unknowns, stored as one dense block per
 * connected component: the two sides of a cut, as long as nothing ties them,
 * are two.
 */
class SchurComplement
{
public:
  /** The unknowns of a component, ascending, and their block, by columns. */
  struct Block
  {
    std::vector<unsigned int> dofs;
    std::vector<double> values;
  };

  /**
   * The block S = L L^T - shift of a Cholesky factor.
   *
   * @param lower L by columns, 0 above the diagonal.
   */
  static Block
  square(const std::vector<unsigned int> &dofs,
         std::vector<double> &&lower,
         const double shift);

  /** @param blocks which hold each unknown from 0 on once. */
  explicit SchurComplement(std::vector<Block> &&blocks);

  /** Add v v^T, where v has the same component's unknowns alone.
   *
   * @param v unknowns and entries, each unknown once. */
  void
  add_square(const std::vector<std::pair<unsigned int, double>> &v);

  double
  operator()(const unsigned int i, const unsigned int j) const;

  /** S x; x may have few entries that are not 0. */
  std::vector<double>
  multiply(const std::vector<double> &x) const;

private:
  std::vector<Block> blocks;
  /** Where each unknown is. */
  std::vector<unsigned int> block_of, place_in_block;
};
} // namespace Setsudan
