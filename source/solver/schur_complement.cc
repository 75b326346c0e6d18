#include <setsudan/solver/schur_complement.h>

#include <Teuchos_BLAS.hpp>


#include <algorithm>
#include <numeric>

/** LAPACK's product U U^T of an upper triangle, which has no wrapper. */
extern "C" void
dlauum_(const char *uplo, const int *n, double *a, const int *lda, int *info);

namespace Setsudan
{
SchurComplement::SchurComplement(const CholeskyFactor &factor,
                                 const double shift)
  : block_of(factor.n_last())
  , place_in_block(factor.n_last())
{
  find_blocks(factor.last_block(), factor.n_last());
  for (auto &block : blocks)
    square(block, shift);
}



void
SchurComplement::find_blocks(const std::vector<double> &last,
                             const unsigned int n)
{
  // The name of a block is its first unknown.
  std::vector<unsigned int> name(n);
  std::iota(name.begin(), name.end(), 0);
  const auto find = [&](unsigned int i) {
    while (name[i] != i)
      i = name[i] = name[name[i]];
    return i;
  };
  for (unsigned int column = 0; column < n; ++column)
    for (unsigned int row = column + 1; row < n; ++row)
      if (last[std::size_t(column) * n + row] != 0)
        {
          const unsigned int a = find(row), b = find(column);
          name[std::max(a, b)] = std::min(a, b);
        }
  std::vector<unsigned int> number(n);
  for (unsigned int i = 0; i < n; ++i)
    {
      const unsigned int first = find(i);
      if (first == i)
        {
          number[i] = blocks.size();
          blocks.emplace_back();
        }
      block_of[i]       = number[first];
      auto &members     = blocks[block_of[i]].members;
      place_in_block[i] = members.size();
      members.push_back(i);
    }
  for (auto &block : blocks)
    {
      const auto &members = block.members;
      const std::size_t m = members.size();
      block.complement.assign(m * m, 0.);
      for (unsigned int j = 0; j < m; ++j)
        for (unsigned int i = j; i < m; ++i)
          block.complement[j * m + i] =
            last[std::size_t(members[j]) * n + members[i]];
    }
}



void
SchurComplement::square(Block &block, const double shift) const
{
  const int m = block.members.size();
  auto &s     = block.complement;
  // From behind, L is an upper triangle.
  std::reverse(s.begin(), s.end());
  int info = 0;
  dlauum_("U", &m, s.data(), &m, &info);
  for (int i = 0; i < m; ++i)
    for (int j = 0; j < i; ++j)
      s[std::size_t(j) * m + i] = s[std::size_t(i) * m + j];
  std::reverse(s.begin(), s.end());
  for (int i = 0; i < m; ++i)
    s[std::size_t(i) * m + i] -= shift;
}



double
SchurComplement::operator()(const unsigned int i, const unsigned int j) const
{
  if (block_of[i] != block_of[j])
    return 0;
  const Block &block = blocks[block_of[i]];
  return block
    .complement[std::size_t(place_in_block[j]) * block.members.size() +
                place_in_block[i]];
}



std::vector<double>
SchurComplement::multiply(const std::vector<double> &x) const
{
  const Teuchos::BLAS<int, double> blas;
  std::vector<double> product(x.size()), of_x, of_product;
  for (const auto &block : blocks)
    {
      const int m = block.members.size();
      of_x.resize(m);
      of_product.resize(m);
      for (int i = 0; i < m; ++i)
        of_x[i] = x[block.members[i]];
      blas.GEMV(Teuchos::NO_TRANS,
                m,
                m,
                1.,
                block.complement.data(),
                m,
                of_x.data(),
                1,
                0.,
                of_product.data(),
                1);
      for (int i = 0; i < m; ++i)
        product[block.members[i]] = of_product[i];
    }
  return product;
}
} // namespace Setsudan
