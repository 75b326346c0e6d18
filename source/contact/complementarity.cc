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
constexpr double little_compliance = 1e-12;

/** A condition's part that is linear in p. */
Vector<double>
at(const LinearInParameter &quantity, const double p)
{
  Vector<double> value = quantity.constant;
  value.add(p, quantity.slope);
  return value;
}
} // namespace


Complementarity::Complementarity(const LAPACKFullMatrix<double> &G,
                                 ContactConditions all)
  : products(G)
  , conditions(std::move(all))
  , own_compliance(size(), 0.)
{
  for (const unsigned int i : conditions.redundant)
    own_compliance[i] = little_compliance;
  AssertDimension(products.m(), products.n());
  AssertDimension(conditions.measured.size(), size());
  AssertDimension(conditions.exerted.size(), size());
  AssertDimension(conditions.required.slope.size(), size());
}



unsigned int
Complementarity::size() const
{
  return conditions.required.constant.size();
}



bool
Complementarity::is_follower(const unsigned int i) const
{
  return !conditions.leader.empty() && conditions.leader[i] != i;
}



double
Complementarity::spring(const unsigned int i) const
{
  return conditions.foundation ? conditions.foundation->stiffness[i] : 0.;
}



Complementarity::Side
Complementarity::side(const double p) const
{
  return {at(conditions.required, p),
          conditions.foundation ? conditions.foundation->closed
                                : Vector<double>()};
}



void
Complementarity::flip(ActiveSet &active, const unsigned int condition) const
{
  active[condition].flip();
  if (!active[condition])
    for (unsigned int i = 0; i < conditions.leader.size(); ++i)
      if (conditions.leader[i] == condition)
        active[i] = false;
}



double
Complementarity::compliance(const unsigned int i, const VectorSum &force) const
{
  double sum = 0;
  for (const auto &[a, factor] : conditions.measured[i])
    for (const auto &[b, other] : force)
      sum += factor * other * products(a, b);
  return sum;
}



std::vector<Complementarity::Solved>
Complementarity::solve(const ActiveSet &active,
                       const std::vector<Side> &sides) const
{
  const auto
    &[measured, exerted, required, shared, redundant, leader, springs] =
      conditions;
  // Unknown are the multipliers of active conditions, and the springs of
  // others: those of active ones are as long as the gap says.
  std::vector<unsigned int> indices;
  std::vector<unsigned int> known_springs;
  for (unsigned int i = 0; i < size(); ++i)
    {
      if (active[i] || spring(i) > 0)
        indices.push_back(i);
      if (active[i] && spring(i) > 0)
        known_springs.push_back(i);
    }
  std::vector<Solved> all(
    sides.size(),
    {Vector<double>(size()), Vector<double>(springs ? size() : 0)});
  const unsigned int n = indices.size();
  if (n == 0)
    return all;
  const unsigned int n_all = n + shared.has_value();
  LAPACKFullMatrix<double> block(n_all), right(n_all, sides.size());
  for (unsigned int j = 0; j < n; ++j)
    {
      const unsigned int c = indices[j];
      for (unsigned int i = 0; i < n; ++i)
        block(i, j) =
          compliance(indices[i], active[c] ? exerted[c] : measured[c]);
      if (active[c])
        block(j, j) *= 1 + own_compliance[c];
      else
        block(j, j) -= 1 / spring(c);
    }
  if (shared)
    {
      for (unsigned int i = 0; i < n; ++i)
        if (active[indices[i]])
          {
            block(i, n) = shared->measured[indices[i]];
            block(n, i) = shared->exerted[indices[i]];
          }
      block(n, n) = -shared->stiffness;
    }
  for (unsigned int s = 0; s < sides.size(); ++s)
    {
      const auto &[b, closed] = sides[s];
      for (const unsigned int k : known_springs)
        all[s].springs[k] = spring(k) * closed[k];
      for (unsigned int i = 0; i < n; ++i)
        {
          const unsigned int c = indices[i];
          right(i, s)          = active[c] ? b[c] : b[c] - closed[c];
          for (const unsigned int k : known_springs)
            if (all[s].springs[k] != 0)
              right(i, s) -= compliance(c, measured[k]) * all[s].springs[k];
        }
    }
  block.compute_lu_factorization();
  block.solve(right);
  for (unsigned int s = 0; s < sides.size(); ++s)
    {
      for (unsigned int i = 0; i < n; ++i)
        (active[indices[i]] ? all[s].multipliers : all[s].springs)[indices[i]] =
          right(i, s);
      if (shared)
        all[s].shared = right(n, s);
    }
  return all;
}



Vector<double>
Complementarity::displacements(const Solved &solved) const
{
  Vector<double> moved(products.m());
  const auto m     = static_cast<unsigned int>(products.m());
  const auto exert = [&](const VectorSum &vectors, const double force) {
    if (force != 0)
      for (const auto &[b, factor] : vectors)
        for (unsigned int a = 0; a < m; ++a)
          moved[a] += factor * force * products(a, b);
  };
  for (unsigned int j = 0; j < size(); ++j)
    exert(conditions.exerted[j], solved.multipliers[j]);
  for (unsigned int j = 0; j < solved.springs.size(); ++j)
    exert(conditions.measured[j], solved.springs[j]);
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
      for (const auto &[a, factor] : conditions.measured[i])
        gap[i] += factor * moved[a];
      gap[i] -= b[i];
      if (conditions.shared)
        gap[i] += conditions.shared->measured[i] * x;
    }
  return gap;
}



std::vector<unsigned int>
Complementarity::violations(const ActiveSet &active, const Side &side) const
{
  const auto solved  = solve(active, {side})[0];
  const auto &lambda = solved.multipliers;
  const Vector<double> gap =
    gaps(displacements(solved), solved.shared, side.required);
  const double allowed_pull = round_off * lambda.linfty_norm();
  const double allowed_gap  = round_off * side.required.linfty_norm();
  std::vector<unsigned int> violated;
  for (unsigned int i = 0; i < size(); ++i)
    if (!is_follower(i) &&
        (active[i] ? !(lambda[i] >= -allowed_pull) : !(gap[i] >= -allowed_gap)))
      violated.push_back(i);
  return violated;
}



ActiveSet
Complementarity::pivot(ActiveSet active, const Side &side) const
{
  const unsigned int most = 100 + 20 * size();
  for (unsigned int step = 0; step < most; ++step)
    {
      const auto violated = violations(active, side);
      if (violated.empty())
        return active;
      flip(active, violated.back());
    }
  throw SolverError(
    "There is no equilibrium with contact: the conditions of contact "
    "contradict each other, as they may with much friction. Lower "
    "Blade/Friction.");
}



ActiveSet
Complementarity::active_set(const double p, ActiveSet active) const
{
  const Side at_p = side(p);
  active.resize(size(), false);
  for (unsigned int i = 0; i < size(); ++i)
    if (is_follower(i))
      active[i] = active[i] && active[conditions.leader[i]];
  std::set<ActiveSet> known;
  while (known.insert(active).second)
    {
      const auto violated = violations(active, at_p);
      if (violated.empty())
        return active;
      for (const unsigned int i : violated)
        flip(active, i);
    }
  return pivot(std::move(active), at_p);
}



Complementarity::Piece
Complementarity::piece(const ActiveSet &active) const
{
  const LinearInParameter &required = conditions.required;
  const Side constant               = side(0);
  const Side slope{required.slope, Vector<double>(constant.closed.size())};
  const auto solved = solve(active, {constant, slope});
  Piece piece;
  piece.active        = active;
  piece.multipliers   = {solved[0].multipliers, solved[1].multipliers};
  piece.springs       = {solved[0].springs, solved[1].springs};
  piece.displacements = {displacements(solved[0]), displacements(solved[1])};
  piece.shared        = {{solved[0].shared, solved[1].shared}};
  piece.gaps          = {
             gaps(piece.displacements.constant, solved[0].shared, required.constant),
             gaps(piece.displacements.slope, solved[1].shared, required.slope)};
  for (unsigned int i = 0; i < size(); ++i)
    if (active[i])
      piece.gaps.constant[i] = piece.gaps.slope[i] = 0;
  return piece;
}



std::optional<Complementarity::Breakpoint>
Complementarity::end_of(const Piece &piece, const double p) const
{
  const auto falling = [&](const unsigned int i) -> const LinearInParameter & {
    return piece.active[i] ? piece.multipliers : piece.gaps;
  };
  std::array<double, 2> largest{};
  for (unsigned int i = 0; i < size(); ++i)
    if (!is_follower(i))
      largest[piece.active[i]] =
        std::max(largest[piece.active[i]], std::abs(falling(i).slope[i]));
  std::optional<Breakpoint> end;
  for (unsigned int i = 0; i < size(); ++i)
    {
      const double slope = falling(i).slope[i];
      if (is_follower(i) || slope >= -round_off * largest[piece.active[i]])
        continue;
      const double zero = p + std::max(falling(i)(i, p), 0.) / -slope;
      if (!end || zero < end->p)
        end = {zero, i};
    }
  return end;
}
} // namespace Setsudan
