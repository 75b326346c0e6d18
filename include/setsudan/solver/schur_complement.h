#pragma once

#include <setsudan/solver/cholesky_factor.h>

#include <vector>

namespace Setsudan
{
/**
 * What the last unknowns of a factor are to each other once the others are
 * eliminated, S = L L^T of its last block without the shift. Unknowns that have
 * nothing to do with each other, as those of two bodies, are in dense blocks of
 * their own.
 */
class SchurComplement
{
public:
  SchurComplement(const CholeskyFactor &factor, const double shift);

  double
  operator()(const unsigned int i, const unsigned int j) const;

  /** S x. */
  std::vector<double>
  multiply(const std::vector<double> &x) const;

private:
  struct Block
  {
    std::vector<unsigned int> members;
    /** By columns; all of it. */
    std::vector<double> complement;
  };

  void
  find_blocks(const std::vector<double> &last, const unsigned int n);

  /** From L to S of a block. */
  void
  square(Block &block, const double shift) const;

  std::vector<Block> blocks;
  /** Where each unknown is. */
  std::vector<unsigned int> block_of, place_in_block;
};
} // namespace Setsudan
