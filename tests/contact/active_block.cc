// SPDX-License-Identifier: LGPL-2.1-or-later
// The block of a matrix that is changed by a few numbers again and again, and
// some rows and columns of which change: its solutions are those of the matrix,
// be it definite, without symmetry, or so badly conditioned that the inverse is
// of little use. Where nothing changes nothing is asked for. A singular block
// is refused.

#include <setsudan/contact/active_block.h>

#include <deal.II/lac/full_matrix.h>

#include <algorithm>
#include <cmath>
#include <random>

#include "../test_setup.h"

using namespace Setsudan;
using namespace dealii;

using Generator = std::mt19937;

/** A A^T + a little, and a part that is not symmetric. */
FullMatrix<double>
random_matrix(const unsigned int n,
              const double little,
              const double asymmetry,
              Generator &generator)
{
  std::normal_distribution<double> normal;
  FullMatrix<double> a(n), matrix(n);
  for (unsigned int i = 0; i < n; ++i)
    for (unsigned int j = 0; j < n; ++j)
      a(i, j) = normal(generator) / (1 + j);
  a.mTmult(matrix, a);
  for (unsigned int i = 0; i < n; ++i)
    {
      matrix(i, i) += little;
      for (unsigned int j = 0; j < i; ++j)
        matrix(i, j) += asymmetry * little * normal(generator);
    }
  return matrix;
}



/** How far the block is from solving for 1 in all rows, relative to what
 * round-off leaves. */
double
residual(ActiveBlock &block, const FullMatrix<double> &matrix)
{
  const auto &numbers  = block.numbers();
  const unsigned int n = numbers.size();
  LAPACKFullMatrix<double> x(n, 1);
  for (unsigned int i = 0; i < n; ++i)
    x(i, 0) = 1;
  block.solve(x);
  double largest = 0, size = 1;
  for (unsigned int i = 0; i < n; ++i)
    {
      double left = 1;
      for (unsigned int j = 0; j < n; ++j)
        {
          left -= matrix(numbers[i], numbers[j]) * x(j, 0);
          size =
            std::max(size, std::abs(matrix(numbers[i], numbers[j]) * x(j, 0)));
        }
      largest = std::max(largest, std::abs(left));
    }
  return largest / size;
}



void
test(const std::string &name,
     const double little,
     const double asymmetry,
     Generator &generator)
{
  constexpr unsigned int n = 60;
  auto matrix              = random_matrix(n, little, asymmetry, generator);
  unsigned int n_asked     = 0;
  const ActiveBlock::Entry entry = [&](const unsigned int i,
                                       const unsigned int j) {
    ++n_asked;
    return matrix(i, j);
  };
  ActiveBlock block;
  std::vector<unsigned int> active;
  for (unsigned int i = 0; i < n; i += 2)
    active.push_back(i);
  double largest = 0;
  for (unsigned int step = 0; step < 300; ++step)
    {
      for (unsigned int change = 0; change < 1 + step % 3; ++change)
        {
          const unsigned int number = generator() % n;
          const auto at =
            std::lower_bound(active.begin(), active.end(), number);
          if (at != active.end() && *at == number)
            active.erase(at);
          else
            active.insert(at, number);
        }
      if (step % 5 == 0)
        {
          const unsigned int number = generator() % n;
          for (unsigned int i = 0; i < n; ++i)
            matrix(i, number) = matrix(number, i) *= i == number ? 1.1 : 0.99;
          block.forget(number);
        }
      block.take(active, entry, asymmetry == 0);
      largest = std::max(largest, residual(block, matrix));
    }
  n_asked = 0;
  block.take(active, entry, asymmetry == 0);
  auto numbers = block.numbers();
  std::sort(numbers.begin(), numbers.end());
  say(name + (numbers == active ? "" : ": FAILED, other numbers") +
      (n_asked == 0 ? "" : ": FAILED, asks for what it knows"));
  check_below("  residual", largest, 1e-13);
}



void
test_few_entries(Generator &generator)
{
  constexpr unsigned int n       = 50;
  const auto matrix              = random_matrix(n, 1e-3, 0, generator);
  unsigned int n_asked           = 0;
  const ActiveBlock::Entry entry = [&](const unsigned int i,
                                       const unsigned int j) {
    ++n_asked;
    return matrix(i, j);
  };
  ActiveBlock block;
  std::vector<unsigned int> active;
  for (unsigned int i = 0; i + 1 < n; ++i)
    active.push_back(i);
  block.take(active, entry, true);
  n_asked = 0;
  active.push_back(n - 1);
  block.take(active, entry, true);
  say("one number more: " + std::to_string(n_asked) + " entries");
  active.erase(active.begin());
  n_asked = 0;
  block.take(active, entry, true);
  say("one number less: " + std::to_string(n_asked) + " entries");
  check_below("  residual", residual(block, matrix), 1e-13);
}



void
test_singular()
{
  ActiveBlock block;
  LAPACKFullMatrix<double> x(2, 1);
  try
    {
      block.take(
        {0, 1}, [](unsigned int, unsigned int) { return 1.; }, true);
      block.solve(x);
      x(0, 0) = 1;
      block.solve(x);
      say("FAILED: a singular block has a solution");
    }
  catch (const ExceptionBase &)
    {
      say("a singular block is refused");
    }
}


int
main(int argc, char **argv)
{
  return run_test(argc, argv, [] {
    Generator generator(1);
    test("definite", 1e-3, 0, generator);
    test("without symmetry", 1e-3, 1, generator);
    test("badly conditioned", 1e-12, 0, generator);
    test_few_entries(generator);
    test_singular();
  });
}
