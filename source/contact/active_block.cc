// SPDX-License-Identifier: LGPL-2.1-or-later
#include <setsudan/contact/active_block.h>

#include <Teuchos_BLAS.hpp>
#include <Teuchos_LAPACK.hpp>

#include <algorithm>
#include <cmath>
#include <limits>

namespace Setsudan
{
using namespace dealii;

namespace
{
/** A pivot that has lost more digits than this leaves. */
constexpr double smallest_pivot = 1e-6;

/** A residual, relative to the right-hand side, beyond which refinement needs
 * more than one step, and the inverse is made anew before the next change. */
constexpr double largest_residual = 1e-8;

/** What a factorization with pivoting leaves, in the worst case. */
constexpr double accurate_residual = 1e-15;

constexpr unsigned int most_refinements = 6;

const Teuchos::BLAS<int, double> blas;
const Teuchos::LAPACK<int, double> lapack;

/** y += factor A x, or A^T x, of a square matrix. */
void
add_product(const double *matrix,
            const unsigned int n,
            const unsigned int stride,
            const double factor,
            const double *x,
            double *y,
            const bool transposed = false)
{
  blas.GEMV(transposed ? Teuchos::TRANS : Teuchos::NO_TRANS,
            n,
            n,
            factor,
            matrix,
            stride,
            x,
            1,
            1.,
            y,
            1);
}



double
largest_entry(const double *begin, const unsigned int n)
{
  double largest = 0;
  for (unsigned int i = 0; i < n; ++i)
    largest = std::max(largest, std::abs(begin[i]));
  return largest;
}
} // namespace


void
ActiveBlock::forget(const unsigned int number)
{
  for (unsigned int i = 0; i < n(); ++i)
    if (members[i] == number)
      changed[i] = true;
}



void
ActiveBlock::reserve(const unsigned int most)
{
  members.clear();
  changed.clear();
  if (most <= stride)
    return;
  stride = most;
  block.resize(most * most);
  inverse.resize(most * most);
}



void
ActiveBlock::take(const std::vector<unsigned int> &wanted,
                  const Entry &entry,
                  const bool definite)
{
  is_definite = definite;
  // The places of members, and those that stay.
  const unsigned int largest = std::max(
    wanted.empty() ? 0 : *std::max_element(wanted.begin(), wanted.end()),
    members.empty() ? 0 : *std::max_element(members.begin(), members.end()));
  std::vector<bool> enters(largest + 1, false);
  for (const unsigned int number : wanted)
    enters[number] = true;
  std::vector<unsigned int> leaving;
  for (unsigned int i = 0; i < n(); ++i)
    if (!enters[members[i]] || changed[i])
      leaving.push_back(i);
    else
      enters[members[i]] = false;
  const unsigned int n_entering = wanted.size() + leaving.size() - n();
  // Beyond this a factorization is cheaper, which is a product of blocks.
  const bool are_many = leaving.size() + n_entering > 4 + wanted.size() / 8;
  if (are_many || is_inaccurate || !has_inverse || wanted.size() > stride)
    return renew(wanted, entry);
  for (unsigned int k = leaving.size(); k-- > 0;)
    if (!leave(leaving[k]))
      return renew(wanted, entry);
  for (const unsigned int number : wanted)
    if (enters[number] && !enter(number, entry))
      return renew(wanted, entry);
}



void
ActiveBlock::renew(const std::vector<unsigned int> &wanted, const Entry &entry)
{
  const unsigned int size = wanted.size();
  // Some more will enter.
  reserve(size <= stride ? size : size + size / 4 + 8);
  members = wanted;
  changed.assign(size, false);
  for (unsigned int j = 0; j < size; ++j)
    for (unsigned int i = 0; i < size; ++i)
      block[i + j * stride] = entry(members[i], members[j]);
  invert();
}



bool
ActiveBlock::invert_definite()
{
  const int size = n();
  int info       = 0;
  lapack.POTRF('L', size, inverse.data(), stride, &info);
  if (info == 0)
    lapack.POTRI('L', size, inverse.data(), stride, &info);
  for (unsigned int j = 0; j < n(); ++j)
    for (unsigned int i = 0; i < j; ++i)
      inverse[i + j * stride] = inverse[j + i * stride];
  return info == 0;
}



bool
ActiveBlock::invert_general()
{
  const int size   = n();
  const int n_work = 64 * size;
  int info         = 0;
  std::vector<int> pivots(size);
  std::vector<double> work(n_work);
  lapack.GETRF(size, size, inverse.data(), stride, pivots.data(), &info);
  if (info == 0)
    lapack.GETRI(
      size, inverse.data(), stride, pivots.data(), work.data(), n_work, &info);
  return info == 0;
}



void
ActiveBlock::invert()
{
  is_inaccurate = false;
  has_inverse   = true;
  if (n() == 0)
    return;
  inverse     = block;
  has_inverse = is_definite && invert_definite();
  if (has_inverse)
    return;
  inverse     = block;
  has_inverse = invert_general();
}



bool
ActiveBlock::leave(const unsigned int place)
{
  const double pivot = inverse[place + place * stride];
  if (!(std::abs(pivot * block[place + place * stride]) > smallest_pivot))
    return false;
  const unsigned int last = n() - 1;
  std::vector<double> column(&inverse[place * stride],
                             &inverse[place * stride] + n());
  std::vector<double> row(n());
  for (unsigned int j = 0; j < n(); ++j)
    row[j] = inverse[place + j * stride];
  blas.GER(n(),
           n(),
           -1 / pivot,
           column.data(),
           1,
           row.data(),
           1,
           inverse.data(),
           stride);
  for (auto *matrix : {&block, &inverse})
    {
      double *const entries = matrix->data();
      std::copy_n(entries + last * stride, n(), entries + place * stride);
      for (unsigned int j = 0; j < last; ++j)
        entries[place + j * stride] = entries[last + j * stride];
    }
  members[place] = members[last];
  changed[place] = changed[last];
  members.pop_back();
  changed.pop_back();
  return true;
}



bool
ActiveBlock::enter(const unsigned int number, const Entry &entry)
{
  const unsigned int size = n();
  if (size == stride)
    return false;
  std::vector<double> column(size), row(size), by_column(size), by_row(size);
  for (unsigned int i = 0; i < size; ++i)
    {
      column[i] = entry(members[i], number);
      row[i]    = entry(number, members[i]);
    }
  const double diagonal = entry(number, number);
  add_product(inverse.data(), size, stride, 1, column.data(), by_column.data());
  add_product(inverse.data(), size, stride, 1, row.data(), by_row.data(), true);
  double pivot = diagonal, largest = std::abs(diagonal);
  for (unsigned int i = 0; i < size; ++i)
    {
      pivot -= row[i] * by_column[i];
      largest = std::max(largest, std::abs(row[i] * by_column[i]));
    }
  if (!(std::abs(pivot) > smallest_pivot * largest))
    return false;
  if (size > 0)
    blas.GER(size,
             size,
             1 / pivot,
             by_column.data(),
             1,
             by_row.data(),
             1,
             inverse.data(),
             stride);
  for (unsigned int i = 0; i < size; ++i)
    {
      block[i + size * stride]   = column[i];
      block[size + i * stride]   = row[i];
      inverse[i + size * stride] = -by_column[i] / pivot;
      inverse[size + i * stride] = -by_row[i] / pivot;
    }
  block[size + size * stride]   = diagonal;
  inverse[size + size * stride] = 1 / pivot;
  members.push_back(number);
  changed.push_back(false);
  return true;
}



bool
ActiveBlock::refine(const LAPACKFullMatrix<double> &right,
                    LAPACKFullMatrix<double> &solution)
{
  std::vector<double> residual(n());
  for (unsigned int s = 0; s < right.n(); ++s)
    {
      double *const x = &solution(0, s);
      std::fill_n(x, n(), 0.);
      std::copy_n(&right(0, s), n(), residual.begin());
      const double size = largest_entry(residual.data(), n());
      if (size == 0)
        continue;
      double last = std::numeric_limits<double>::infinity();
      for (unsigned int step = 0;; ++step)
        {
          add_product(inverse.data(), n(), stride, 1, residual.data(), x);
          // From here on each step gains as many digits as the first one has.
          if (last <= largest_residual)
            break;
          std::copy_n(&right(0, s), n(), residual.begin());
          add_product(block.data(), n(), stride, -1, x, residual.data());
          const double left = largest_entry(residual.data(), n()) / size;
          if (left <= accurate_residual)
            break;
          if (!(left < last / 2) || step == most_refinements)
            return false;
          is_inaccurate = is_inaccurate || left > largest_residual;
          last          = left;
        }
    }
  return true;
}



void
ActiveBlock::solve(LAPACKFullMatrix<double> &right)
{
  LAPACKFullMatrix<double> solution(right.m(), right.n());
  if (has_inverse && refine(right, solution))
    {
      right = solution;
      return;
    }
  has_inverse = false;
  LAPACKFullMatrix<double> matrix(n());
  for (unsigned int j = 0; j < n(); ++j)
    std::copy_n(&block[j * stride], n(), &matrix(0, j));
  matrix.compute_lu_factorization();
  matrix.solve(right);
}
} // namespace Setsudan
