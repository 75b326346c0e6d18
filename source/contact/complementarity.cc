// SPDX-License-Identifier: LGPL-2.1-or-later
#include <setsudan/contact/complementarity.h>
#include <setsudan/kernel/blas.h>
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
  , is_definite(!conditions.shared && !conditions.foundation &&
                conditions.measured == conditions.exerted)
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



void
Complementarity::replace(const unsigned int i,
                         const VectorSum &measured,
                         const VectorSum &exerted,
                         const std::array<double, 2> &required)
{
  conditions.measured[i]          = measured;
  conditions.exerted[i]           = exerted;
  conditions.required.constant[i] = required[0];
  conditions.required.slope[i]    = required[1];
  is_definite                     = is_definite && measured == exerted;
  block.forget(i);
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
  // The matrices are too small to be shared out among threads.
  const SingleThreadedBlas single_threaded;
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
