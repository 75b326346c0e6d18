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
    multiply(block, shift);
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
      block.lower.assign(m * m, 0.);
      for (unsigned int j = 0; j < m; ++j)
        for (unsigned int i = j; i < m; ++i)
          block.lower[j * m + i] =
            last[std::size_t(members[j]) * n + members[i]];
    }
}



void
SchurComplement::multiply(Block &block, const double shift) const
{
  // From behind, L is an upper triangle.
  const int m      = block.members.size();
  block.complement = {block.lower.rbegin(), block.lower.rend()};
  int info         = 0;
  dlauum_("U", &m, block.complement.data(), &m, &info);
  auto &s = block.complement;
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



void
SchurComplement::multiply(double *x, const bool transposed) const
{
  const Teuchos::BLAS<int, double> blas;
  std::vector<double> part;
  for (const auto &block : blocks)
    {
      const int m = block.members.size();
      part.clear();
      for (const unsigned int member : block.members)
        part.push_back(x[member]);
      blas.TRMM(Teuchos::LEFT_SIDE,
                Teuchos::LOWER_TRI,
                transposed ? Teuchos::TRANS : Teuchos::NO_TRANS,
                Teuchos::NON_UNIT_DIAG,
                m,
                1,
                1.,
                block.lower.data(),
                m,
                part.data(),
                m);
      for (int i = 0; i < m; ++i)
        x[block.members[i]] = part[i];
    }
}



void
SchurComplement::multiply_lower(double *x) const
{
  multiply(x, false);
}



void
SchurComplement::multiply_upper(double *x) const
{
  multiply(x, true);
}
} // namespace Setsudan
