// SPDX-License-Identifier: LGPL-2.1-or-later
// Random complementarity problems with a symmetric positive definite matrix:
// from any active set the same solution is found, it obeys the conditions, and
// pieces that are followed from breakpoint to breakpoint are the solutions that
// are found anew between them; also where gaps share an unknown, where some
// conditions are equations that follow others, and where the body is held by a
// foundation that is taken out again. A problem that has no solution is
// refused.

#include <setsudan/contact/complementarity.h>
#include <setsudan/parameters/exceptions.h>

#include <cmath>
#include <random>

#include "../test_setup.h"

using namespace Setsudan;
using namespace dealii;

using Generator = std::mt19937;

/** A A^T + a little, of nearly dependent columns as those of a fine mesh are.
 */
LAPACKFullMatrix<double>
random_products(const unsigned int n, Generator &generator)
{
  std::normal_distribution<double> normal;
  LAPACKFullMatrix<double> a(n), products(n);
  for (unsigned int i = 0; i < n; ++i)
    for (unsigned int j = 0; j < n; ++j)
      a(i, j) = normal(generator) / (1 + j);
  a.mTmult(products, a);
  for (unsigned int i = 0; i < n; ++i)
    products(i, i) += 1e-3;
  return products;
}


std::vector<VectorSum>
single_vectors(const unsigned int n)
{
  std::vector<VectorSum> vectors;
  for (unsigned int i = 0; i < n; ++i)
    vectors.push_back({{{i, 1.}, {i, 0.}, {i, 0.}}});
  return vectors;
}


/** How far a piece is from obeying the conditions at p. */
double
violation(const Complementarity::Piece &piece,
          const LAPACKFullMatrix<double> &products,
          const LinearInParameter &required,
          const double p)
{
  const unsigned int n = piece.active.size();
  Vector<double> lambda(n), gap(n);
  for (unsigned int i = 0; i < n; ++i)
    lambda[i] = piece.multipliers(i, p);
  products.vmult(gap, lambda);
  double largest = 0;
  for (unsigned int i = 0; i < n; ++i)
    {
      gap[i] -= required(i, p);
      largest =
        std::max({largest, -lambda[i], -gap[i], std::abs(lambda[i] * gap[i])});
    }
  return largest / (1 + lambda.linfty_norm());
}


void
test(const unsigned int n, Generator &generator)
{
  std::normal_distribution<double> normal;
  const auto products = random_products(n, generator);
  LinearInParameter required{Vector<double>(n), Vector<double>(n)};
  for (unsigned int i = 0; i < n; ++i)
    {
      required.constant[i] = normal(generator);
      required.slope[i]    = normal(generator);
    }
  const auto vectors = single_vectors(n);
  const Complementarity problem(products, {vectors, vectors, required});

  const ActiveSet first = problem.active_set(0);
  bool is_unique        = true;
  for (unsigned int start = 0; start < 20; ++start)
    {
      ActiveSet guess(n);
      for (unsigned int i = 0; i < n; ++i)
        guess[i] = generator() % 2 == 0;
      is_unique = is_unique && problem.active_set(0, guess) == first;
    }
  double p            = 0;
  auto piece          = problem.piece(first);
  double largest      = violation(piece, products, required, p);
  unsigned int n_ends = 0;
  while (const auto end = problem.end_of(piece, p))
    {
      if (end->p > 10)
        break;
      largest = std::max(
        largest, violation(piece, products, required, (p + end->p) / 2));
      p = end->p;
      piece.active[end->condition].flip();
      piece     = problem.piece(piece.active);
      is_unique = is_unique && problem.active_set(p + 1e-9) == piece.active;
      ++n_ends;
    }
  std::cout << n << (n_ends > 0 ? ": has breakpoints" : ": no breakpoints")
            << (is_unique ? ", one solution" : ", FAILED: several solutions")
            << std::endl;
  check_below("  violation", largest, 1e-9);
}


/** An unknown that gaps share, and has a stiffness, adds its own compliance to
 * that of the body. */
void
test_shared(const unsigned int n, Generator &generator)
{
  constexpr double stiffness = 0.1;
  std::normal_distribution<double> normal;
  const auto products = random_products(n, generator);
  auto with_unknown   = products;
  Vector<double> factor(n), required(n);
  for (unsigned int i = 0; i < n; ++i)
    {
      factor[i]   = normal(generator);
      required[i] = normal(generator);
    }
  for (unsigned int i = 0; i < n; ++i)
    for (unsigned int j = 0; j < n; ++j)
      with_unknown(i, j) = products(i, j) + factor[i] * factor[j] / stiffness;
  const auto vectors = single_vectors(n);
  const LinearInParameter constant{required, Vector<double>(n)};
  const Complementarity expected(with_unknown, {vectors, vectors, constant});
  const Complementarity problem(
    products,
    {vectors, vectors, constant, SharedUnknown{factor, factor, stiffness}});
  const ActiveSet active = problem.active_set(0);
  const auto piece       = problem.piece(active);
  auto difference        = piece.multipliers.constant;
  difference -= expected.piece(active).multipliers.constant;
  std::cout << n << ": "
            << (active == expected.active_set(0) ? "same" : "FAILED, another")
            << " active set with a shared unknown" << std::endl;
  check_below("  multipliers", difference.linfty_norm(), 1e-9);
  check_below(
    "  its equation",
    std::abs(factor * piece.multipliers.constant - stiffness * piece.shared[0]),
    1e-9);
}


/** Some conditions are followed by an equation each. */
void
test_followers(const unsigned int n, Generator &generator)
{
  std::normal_distribution<double> normal;
  // With much coupling there may be no solution.
  auto products = random_products(2 * n, generator);
  LinearInParameter required{Vector<double>(2 * n), Vector<double>(2 * n)};
  std::vector<unsigned int> leader;
  for (unsigned int i = 0; i < 2 * n; ++i)
    {
      products(i, i) += 2;
      required.constant[i] = i < n ? normal(generator) : 0;
      leader.push_back(i % n);
    }
  const auto vectors = single_vectors(2 * n);
  ContactConditions conditions{vectors, vectors, required};
  conditions.leader = leader;
  const Complementarity problem(products, conditions);
  // All of them are there in the guess.
  const auto piece =
    problem.piece(problem.active_set(0, ActiveSet(2 * n, true)));
  const auto &lambda = piece.multipliers.constant;
  Vector<double> gap(2 * n);
  products.vmult(gap, lambda);
  gap -= required.constant;
  double violated = 0, other = 0;
  bool are_led = true;
  for (unsigned int i = 0; i < n; ++i)
    {
      violated =
        std::max({violated, -lambda[i], -gap[i], std::abs(lambda[i] * gap[i])});
      other   = std::max(other,
                       piece.active[n + i] ? std::abs(gap[n + i])
                                             : std::abs(lambda[n + i]));
      are_led = are_led && piece.active[n + i] == piece.active[i];
    }
  std::cout << n
            << (are_led ? ": followers end with their leaders"
                        : ": FAILED: a follower without its leader")
            << std::endl;
  const double scale = 1 + lambda.linfty_norm();
  check_below("  leaders", violated / scale, 1e-9);
  check_below("  followers", other / scale, 1e-9);
}


/** The inverse of K, and of K with springs at the first few unknowns, pose the
 * same problem once the springs are taken out. */
void
test_foundation(const unsigned int n, Generator &generator)
{
  std::normal_distribution<double> normal;
  const unsigned int n_springs = (n + 1) / 2;
  auto stiffness               = random_products(n, generator);
  for (unsigned int i = 0; i < n; ++i)
    stiffness(i, i) += 0.1;
  auto with_springs = stiffness;
  Vector<double> springs(n), closed(n), loads(n), required(n);
  for (unsigned int i = 0; i < n; ++i)
    {
      closed[i] = normal(generator);
      loads[i]  = normal(generator);
      if (i < n_springs)
        springs[i] = 0.5 + i;
      with_springs(i, i) += springs[i];
    }
  const auto vectors = single_vectors(n);
  const auto solve   = [&](LAPACKFullMatrix<double> &matrix,
                         const std::optional<Foundation> &foundation) {
    matrix.invert();
    Vector<double> at_rest(n);
    matrix.vmult(at_rest, loads);
    LinearInParameter b{closed, Vector<double>(n)};
    b.constant -= at_rest;
    ContactConditions conditions{vectors, vectors, b};
    conditions.foundation = foundation;
    const Complementarity problem(matrix, conditions);
    return problem.piece(problem.active_set(0));
  };
  const auto expected = solve(stiffness, {});
  const auto piece    = solve(with_springs, Foundation{springs, closed});
  auto multipliers    = piece.multipliers.constant;
  multipliers -= expected.multipliers.constant;
  auto gaps = piece.gaps.constant;
  gaps -= expected.gaps.constant;
  std::cout << n << ": "
            << (piece.active == expected.active ? "same" : "FAILED, another")
            << " active set on a foundation" << std::endl;
  const double scale = 1 + expected.gaps.constant.linfty_norm();
  check_below("  multipliers", multipliers.linfty_norm() / scale, 1e-9);
  check_below("  gaps", gaps.linfty_norm() / scale, 1e-9);
}


/** A gap that its own multiplier closes. */
void
test_impossible()
{
  LAPACKFullMatrix<double> products(1);
  products(0, 0) = -1;
  const Complementarity problem(products,
                                {single_vectors(1),
                                 single_vectors(1),
                                 {Vector<double>({1.}), Vector<double>({0.})}});
  try
    {
      problem.active_set(0);
      std::cout << "FAILED: a solution was found" << std::endl;
    }
  catch (const SolverError &error)
    {
      std::cout << error.what() << std::endl;
    }
}


int
main(int argc, char **argv)
{
  return run_test(argc, argv, [] {
    Generator generator(1996);
    for (const unsigned int n : {1, 2, 5, 20, 60})
      test(n, generator);
    for (const unsigned int n : {1, 5, 20})
      test_shared(n, generator);
    for (const unsigned int n : {1, 5, 20})
      test_followers(n, generator);
    for (const unsigned int n : {2, 5, 20})
      test_foundation(n, generator);
    test_impossible();
  });
}
