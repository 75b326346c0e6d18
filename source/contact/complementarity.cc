// SPDX-License-Identifier: LGPL-2.1-or-later
#include <setsudan/contact/complementarity.h>
#include <setsudan/parameters/exceptions.h>

#include <algorithm>
#include <cmath>
#include <set>

namespace Setsudan
{
using namespace dealii;

namespace
{
/** What is violated by less is round-off, relative to the largest. */
constexpr double round_off = 1e-13;

/** Of a redundant condition, relative to the body's: too little to be seen. */
constexpr double compliance = 1e-12;

/** @param b of the same size. */
Vector<double>
at(const LinearInParameter &quantity, const double p)
{
  Vector<double> value = quantity.constant;
  value.add(p, quantity.slope);
  return value;
}
} // namespace


Complementarity::Complementarity(
  const LAPACKFullMatrix<double> &G,
  std::vector<VectorSum> rows,
  std::vector<VectorSum> forces,
  LinearInParameter b,
  std::optional<SharedUnknown> unknown,
  const std::vector<unsigned int> redundant,
  std::vector<std::pair<unsigned int, unsigned int>> pairs)
  : products(G)
  , measured(std::move(rows))
  , exerted(std::move(forces))
  , required(std::move(b))
  , shared(std::move(unknown))
  , own_compliance(size(), 0.)
  , followers(std::move(pairs))
  , is_follower(size(), false)
{
  for (const auto &[follower, leader] : followers)
    is_follower[follower] = true;
  for (const unsigned int i : redundant)
    own_compliance[i] = compliance;
  AssertDimension(products.m(), products.n());
  AssertDimension(measured.size(), required.constant.size());
  AssertDimension(exerted.size(), required.constant.size());
  AssertDimension(required.slope.size(), required.constant.size());
}



unsigned int
Complementarity::size() const
{
  return required.constant.size();
}



std::vector<Complementarity::Solved>
Complementarity::solve(const ActiveSet &active,
                       const std::vector<Vector<double>> &sides) const
{
  std::vector<unsigned int> indices;
  for (unsigned int i = 0; i < size(); ++i)
    if (active[i])
      indices.push_back(i);
  std::vector<Solved> all(sides.size(), {Vector<double>(size())});
  const unsigned int n = indices.size();
  if (n == 0)
    return all;
  const unsigned int n_all = n + shared.has_value();
  LAPACKFullMatrix<double> block(n_all), right(n_all, sides.size());
  for (unsigned int j = 0; j < n; ++j)
    for (unsigned int i = 0; i < n; ++i)
      for (const auto &[a, factor] : measured[indices[i]])
        for (const auto &[b, other] : exerted[indices[j]])
          block(i, j) += factor * other * products(a, b);
  for (unsigned int i = 0; i < n; ++i)
    block(i, i) *= 1 + own_compliance[indices[i]];
  if (shared)
    {
      for (unsigned int i = 0; i < n; ++i)
        {
          block(i, n) = shared->measured[indices[i]];
          block(n, i) = shared->exerted[indices[i]];
        }
      block(n, n) = -shared->stiffness;
    }
  for (unsigned int s = 0; s < sides.size(); ++s)
    for (unsigned int i = 0; i < n; ++i)
      right(i, s) = sides[s][indices[i]];
  block.compute_lu_factorization();
  block.solve(right);
  for (unsigned int s = 0; s < sides.size(); ++s)
    {
      for (unsigned int i = 0; i < n; ++i)
        all[s].multipliers[indices[i]] = right(i, s);
      if (shared)
        all[s].shared = right(n, s);
    }
  return all;
}



Vector<double>
Complementarity::displacements(const Vector<double> &lambda) const
{
  Vector<double> moved(products.m());
  const auto m = static_cast<unsigned int>(products.m());
  for (unsigned int j = 0; j < size(); ++j)
    if (lambda[j] != 0)
      for (const auto &[b, factor] : exerted[j])
        for (unsigned int a = 0; a < m; ++a)
          moved[a] += factor * lambda[j] * products(a, b);
  return moved;
}



Vector<double>
Complementarity::gaps(const Vector<double> &moved,
                      const double x,
                      const Vector<double> &b) const
{
  Vector<double> gap(size());
  for (unsigned int i = 0; i < size(); ++i)
    {
      for (const auto &[a, factor] : measured[i])
        gap[i] += factor * moved[a];
      gap[i] -= b[i];
      if (shared)
        gap[i] += shared->measured[i] * x;
    }
  return gap;
}



std::vector<unsigned int>
Complementarity::violations(const ActiveSet &active,
                            const Vector<double> &b) const
{
  const auto [lambda, x]    = solve(active, {b})[0];
  const Vector<double> gap  = gaps(displacements(lambda), x, b);
  const double allowed_pull = round_off * lambda.linfty_norm();
  const double allowed_gap  = round_off * b.linfty_norm();
  std::vector<unsigned int> violated;
  for (unsigned int i = 0; i < size(); ++i)
    if (!is_follower[i] &&
        (active[i] ? !(lambda[i] >= -allowed_pull) : !(gap[i] >= -allowed_gap)))
      violated.push_back(i);
  return violated;
}



void
Complementarity::follow(ActiveSet &active) const
{
  for (const auto &[follower, leader] : followers)
    active[follower] = active[leader];
}



ActiveSet
Complementarity::pivot(ActiveSet active, const Vector<double> &b) const
{
  const unsigned int most = 100 + 20 * size();
  for (unsigned int step = 0; step < most; ++step)
    {
      const auto violated = violations(active, b);
      if (violated.empty())
        return active;
      active[violated.back()].flip();
      follow(active);
    }
  throw SolverError(
    "There is no equilibrium with contact: the conditions of contact "
    "contradict each other, as they may with much friction. Lower "
    "Blade/Friction.");
}



ActiveSet
Complementarity::active_set(const double p, ActiveSet active) const
{
  const Vector<double> b = at(required, p);
  active.resize(size(), false);
  follow(active);
  std::set<ActiveSet> known;
  while (known.insert(active).second)
    {
      const auto violated = violations(active, b);
      if (violated.empty())
        return active;
      for (const unsigned int i : violated)
        active[i].flip();
      follow(active);
    }
  return pivot(std::move(active), b);
}



Complementarity::Piece
Complementarity::piece(const ActiveSet &active) const
{
  Piece piece;
  piece.active = active;
  follow(piece.active);
  const auto solved = solve(piece.active, {required.constant, required.slope});
  const auto &[constant, x0] = solved[0];
  const auto &[slope, x1]    = solved[1];
  piece.multipliers          = {constant, slope};
  piece.displacements        = {displacements(constant), displacements(slope)};
  piece.shared               = {{x0, x1}};
  piece.gaps = {gaps(piece.displacements.constant, x0, required.constant),
                gaps(piece.displacements.slope, x1, required.slope)};
  for (unsigned int i = 0; i < size(); ++i)
    if (piece.active[i])
      piece.gaps.constant[i] = piece.gaps.slope[i] = 0;
  return piece;
}



std::optional<Complementarity::Breakpoint>
Complementarity::end_of(const Piece &piece,
                        const double p,
                        const int heading) const
{
  const auto falling = [&](const unsigned int i) -> const LinearInParameter & {
    return piece.active[i] ? piece.multipliers : piece.gaps;
  };
  std::array<double, 2> largest{};
  for (unsigned int i = 0; i < size(); ++i)
    if (!is_follower[i])
      largest[piece.active[i]] =
        std::max(largest[piece.active[i]], std::abs(falling(i).slope[i]));
  std::optional<Breakpoint> end;
  for (unsigned int i = 0; i < size(); ++i)
    {
      const double slope = heading * falling(i).slope[i];
      if (is_follower[i] || slope >= -round_off * largest[piece.active[i]])
        continue;
      const double zero = p + heading * std::max(falling(i)(i, p), 0.) / -slope;
      if (!end || heading * (zero - end->p) < 0)
        end = {zero, i};
    }
  return end;
}
} // namespace Setsudan
