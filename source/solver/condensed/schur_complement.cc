// SPDX-License-Identifier: LGPL-2.1-or-later
#include <deal.II/base/exceptions.h>

#include <setsudan/solver/condensed/schur_complement.h>

#include <Teuchos_BLAS.hpp>

#include <algorithm>

/** LAPACK's product U U^T of an upper triangle, which has no wrapper. */
extern "C" void
dlauum_(const char *uplo, const int *n, double *a, const int *lda, int *info);

namespace Setsudan
{
SchurComplement::Block
SchurComplement::square(const std::vector<unsigned int> &dofs,
                        std::vector<double> &&lower,
                        const double shift)
{
  Block block{dofs, std::move(lower)};
  const int m = dofs.size();
  auto &s     = block.values;
  // From behind, L is an upper triangle.
  std::reverse(s.begin(), s.end());
  // A part that does not meet the cut has no unknowns here.
  if (int info = 0; m > 0)
    dlauum_("U", &m, s.data(), &m, &info);
  for (int i = 0; i < m; ++i)
    for (int j = 0; j < i; ++j)
      s[std::size_t(j) * m + i] = s[std::size_t(i) * m + j];
  std::reverse(s.begin(), s.end());
  for (int i = 0; i < m; ++i)
    s[std::size_t(i) * m + i] -= shift;
  return block;
}



SchurComplement::SchurComplement(std::vector<Block> &&all_blocks)
  : blocks(std::move(all_blocks))
{
  std::size_t n = 0;
  for (const auto &block : blocks)
    n += block.dofs.size();
  block_of.resize(n);
  place_in_block.resize(n);
  for (unsigned int b = 0; b < blocks.size(); ++b)
    for (unsigned int i = 0; i < blocks[b].dofs.size(); ++i)
      {
        block_of[blocks[b].dofs[i]]       = b;
        place_in_block[blocks[b].dofs[i]] = i;
      }
}



void
SchurComplement::add_square(
  const std::vector<std::pair<unsigned int, double>> &v)
{
  for (const auto &[j, column] : v)
    {
      Block &block = blocks[block_of[j]];
      for (const auto &[i, row] : v)
        {
          Assert(block_of[i] == block_of[j], dealii::ExcInternalError());
          block.values[std::size_t(place_in_block[j]) * block.dofs.size() +
                       place_in_block[i]] += row * column;
        }
    }
}



double
SchurComplement::operator()(const unsigned int i, const unsigned int j) const
{
  if (block_of[i] != block_of[j])
    return 0;
  const Block &block = blocks[block_of[i]];
  return block.values[std::size_t(place_in_block[j]) * block.dofs.size() +
                      place_in_block[i]];
}



std::vector<double>
SchurComplement::multiply(const std::vector<double> &x) const
{
  const Teuchos::BLAS<int, double> blas;
  std::vector<double> product(x.size()), of_product;
  for (const auto &block : blocks)
    {
      const int m = block.dofs.size();
      of_product.assign(m, 0.);
      for (int j = 0; j < m; ++j)
        if (const double factor = x[block.dofs[j]]; factor != 0)
          blas.AXPY(m,
                    factor,
                    block.values.data() + std::size_t(j) * m,
                    1,
                    of_product.data(),
                    1);
      for (int i = 0; i < m; ++i)
        product[block.dofs[i]] = of_product[i];
    }
  return product;
}
} // namespace Setsudan
