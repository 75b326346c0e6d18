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
Complementarity::measure(const unsigned int i,
                         const Vector<double> &displacements) const
{
  double sum = 0;
  for (const auto &[a, factor] : conditions.measured[i])
    sum += factor * displacements[a];
  return sum;
}



void
Complementarity::add_displacements(const VectorSum &vectors,
                                   const double force,
                                   Vector<double> &displacements) const
{
  const auto m         = static_cast<unsigned int>(products.m());
  double *const result = displacements.begin();
  for (const auto &[b, factor] : vectors)
    if (const double f = factor * force; f != 0)
      {
        const double *const column = &products(0, b);
        for (unsigned int a = 0; a < m; ++a)
          result[a] += f * column[a];
      }
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
  Vector<double> moved(products.m());
  for (unsigned int j = 0; j < n; ++j)
    {
      const unsigned int c = indices[j];
      moved                = 0;
      add_displacements(active[c] ? exerted[c] : measured[c], 1, moved);
      for (unsigned int i = 0; i < n; ++i)
        block(i, j) = measure(indices[i], moved);
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
      Vector<double> by_springs(known_springs.empty() ? 0 : products.m());
      for (const unsigned int k : known_springs)
        {
          all[s].springs[k] = spring(k) * closed[k];
          add_displacements(measured[k], all[s].springs[k], by_springs);
        }
      for (unsigned int i = 0; i < n; ++i)
        {
          const unsigned int c = indices[i];
          right(i, s)          = active[c] ? b[c] : b[c] - closed[c];
          if (!known_springs.empty())
            right(i, s) -= measure(c, by_springs);
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
  for (unsigned int j = 0; j < size(); ++j)
    add_displacements(conditions.exerted[j], solved.multipliers[j], moved);
  for (unsigned int j = 0; j < solved.springs.size(); ++j)
    add_displacements(conditions.measured[j], solved.springs[j], moved);
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
      gap[i] = measure(i, moved) - b[i];
      if (conditions.shared)
        gap[i] += conditions.shared->measured[i] * x;
    }
  return gap;
}



std::vector<unsigned int>
Complementarity::violations(const ActiveSet &active,
                            const Vector<double> &lambda,
                            const Vector<double> &gap,
                            const Vector<double> &required) const
{
  const double allowed_pull = round_off * lambda.linfty_norm();
  const double allowed_gap  = round_off * required.linfty_norm();
  std::vector<unsigned int> violated;
  for (unsigned int i = 0; i < size(); ++i)
    if (!is_follower(i) &&
        (active[i] ? !(lambda[i] >= -allowed_pull) : !(gap[i] >= -allowed_gap)))
      violated.push_back(i);
  return violated;
}



Complementarity::Piece
Complementarity::pivot(ActiveSet active, const double p) const
{
  const unsigned int most = 100 + 20 * size();
  for (unsigned int step = 0; step < most; ++step)
    {
      auto [piece, violated] = try_at(active, p);
      if (violated.empty())
        return piece;
      flip(active, violated.back());
    }
  throw SolverError(
    "There is no equilibrium with contact: the conditions of contact "
    "contradict each other, as they may with much friction. Lower "
    "Blade/Friction or Blade/Adhesion.");
}



ActiveSet
Complementarity::active_set(const double p, ActiveSet guess) const
{
  return solution(p, std::move(guess)).active;
}



Complementarity::Piece
Complementarity::solution(const double p, ActiveSet active) const
{
  active.resize(size(), false);
  for (unsigned int i = 0; i < size(); ++i)
    if (is_follower(i))
      active[i] = active[i] && active[conditions.leader[i]];
  std::set<ActiveSet> known;
  while (known.insert(active).second)
    {
      auto [piece, violated] = try_at(active, p);
      if (violated.empty())
        return piece;
      for (const unsigned int i : violated)
        flip(active, i);
    }
  return pivot(std::move(active), p);
}



Complementarity::Piece
Complementarity::piece(const ActiveSet &active) const
{
  return try_at(active, 0).piece;
}



Complementarity::Tried
Complementarity::try_at(const ActiveSet &active, const double p) const
{
  const LinearInParameter &required = conditions.required;
  if (size() == 0)
    {
      Piece untouched;
      untouched.displacements = {Vector<double>(products.m()),
                                 Vector<double>(products.m())};
      return {untouched, {}};
    }
  const Side at_p = side(p);
  const Side slope{required.slope, Vector<double>(at_p.closed.size())};
  auto solved = solve(active, {at_p, slope});
  std::array<Vector<double>, 2> moved{
    {displacements(solved[0]), displacements(solved[1])}};
  std::array<Vector<double>, 2> gap{
    {gaps(moved[0], solved[0].shared, at_p.required),
     gaps(moved[1], solved[1].shared, required.slope)}};
  for (unsigned int i = 0; i < size(); ++i)
    if (active[i])
      gap[0][i] = gap[1][i] = 0;
  const auto linear = [p](Vector<double> &value, Vector<double> &slope) {
    if (slope.size() > 0)
      value.add(-p, slope);
    return LinearInParameter{std::move(value), std::move(slope)};
  };
  auto violated =
    violations(active, solved[0].multipliers, gap[0], at_p.required);
  Piece piece;
  piece.active = active;
  piece.shared = {{solved[0].shared - p * solved[1].shared, solved[1].shared}};
  piece.multipliers   = linear(solved[0].multipliers, solved[1].multipliers);
  piece.springs       = linear(solved[0].springs, solved[1].springs);
  piece.displacements = linear(moved[0], moved[1]);
  piece.gaps          = linear(gap[0], gap[1]);
  return {std::move(piece), std::move(violated)};
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
    if (!is_follower(i))
      largest[piece.active[i]] =
        std::max(largest[piece.active[i]], std::abs(falling(i).slope[i]));
  std::optional<Breakpoint> end;
  for (unsigned int i = 0; i < size(); ++i)
    {
      const double slope = heading * falling(i).slope[i];
      if (is_follower(i) || slope >= -round_off * largest[piece.active[i]])
        continue;
      const double zero = p + heading * std::max(falling(i)(i, p), 0.) / -slope;
      if (!end || heading * (zero - end->p) < 0)
        end = {zero, i};
    }
  return end;
}
} // namespace Setsudan
