// SPDX-License-Identifier: LGPL-2.1-or-later
#include <setsudan/contact/complementarity.h>

#include <Teuchos_BLAS.hpp>

// The linear system of an active set, and what its solution moves.

namespace Setsudan
{
using namespace dealii;

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



double
Complementarity::entry(const unsigned int row, const unsigned int column) const
{
  const auto &shared       = conditions.shared;
  const unsigned int n     = size();
  const bool of_multiplier = column < n;
  if (row == 2 * n && column == 2 * n)
    return -shared->stiffness;
  if (row == 2 * n)
    return of_multiplier ? shared->exerted[column] : 0.;
  if (column == 2 * n)
    return row < n ? shared->measured[row] : 0.;
  const auto &measured = conditions.measured[row % n];
  const auto &exerted =
    (of_multiplier ? conditions.exerted : conditions.measured)[column % n];
  double sum = 0;
  for (const auto &[b, force] : exerted)
    if (force != 0)
      for (const auto &[a, factor] : measured)
        if (factor != 0)
          sum += factor * force * products(a, b);
  if (row != column)
    return sum;
  return of_multiplier ? sum * (1 + own_compliance[row])
                       : sum - 1 / spring(row - n);
}



LAPACKFullMatrix<double>
Complementarity::right_hand_sides(const ActiveSet &active,
                                  const std::vector<Side> &sides,
                                  std::vector<Solved> &solved) const
{
  const unsigned int n_conditions = size();
  const auto &rows                = block.numbers();
  LAPACKFullMatrix<double> right(rows.size(), sides.size());
  for (unsigned int s = 0; s < sides.size(); ++s)
    {
      const auto &[b, closed] = sides[s];
      // The springs of active conditions are as long as the gap says.
      Vector<double> by_springs;
      for (unsigned int k = 0; k < closed.size(); ++k)
        if (active[k] && spring(k) > 0)
          {
            by_springs.grow_or_shrink(products.m());
            solved[s].springs[k] = spring(k) * closed[k];
            add_displacements(
              conditions.measured[k], solved[s].springs[k], by_springs);
          }
      for (unsigned int i = 0; i < rows.size(); ++i)
        {
          const unsigned int c = rows[i] % n_conditions;
          if (rows[i] == 2 * n_conditions)
            continue;
          right(i, s) = rows[i] < n_conditions ? b[c] : b[c] - closed[c];
          if (by_springs.size() > 0)
            right(i, s) -= measure(c, by_springs);
        }
    }
  return right;
}



std::vector<Complementarity::Solved>
Complementarity::solve(const ActiveSet &active,
                       const std::vector<Side> &sides) const
{
  const unsigned int n = size();
  std::vector<Solved> all(
    sides.size(),
    {Vector<double>(n), Vector<double>(conditions.foundation ? n : 0)});
  std::vector<unsigned int> unknowns;
  for (unsigned int i = 0; i < n; ++i)
    if (active[i] || spring(i) > 0)
      unknowns.push_back(active[i] ? i : n + i);
  if (unknowns.empty())
    return all;
  if (conditions.shared)
    unknowns.push_back(2 * n);
  block.take(
    unknowns,
    [&](const unsigned int row, const unsigned int column) {
      return entry(row, column);
    },
    is_definite);
  auto right = right_hand_sides(active, sides, all);
  block.solve(right);
  const auto &rows = block.numbers();
  for (unsigned int s = 0; s < sides.size(); ++s)
    for (unsigned int i = 0; i < rows.size(); ++i)
      if (rows[i] == 2 * n)
        all[s].shared = right(i, s);
      else
        (rows[i] < n ? all[s].multipliers : all[s].springs)[rows[i] % n] =
          right(i, s);
  return all;
}



Vector<double>
Complementarity::displacements(const Solved &solved) const
{
  const auto m = static_cast<unsigned int>(products.m());
  Vector<double> forces(m), moved(m);
  const auto exert = [&](const VectorSum &vectors, const double force) {
    for (const auto &[b, factor] : vectors)
      forces[b] += factor * force;
  };
  for (unsigned int j = 0; j < size(); ++j)
    if (solved.multipliers[j] != 0)
      exert(conditions.exerted[j], solved.multipliers[j]);
  for (unsigned int j = 0; j < solved.springs.size(); ++j)
    exert(conditions.measured[j], solved.springs[j]);
  // Hats that touch are neighbours: their columns follow each other.
  const Teuchos::BLAS<int, double> blas;
  for (unsigned int begin = 0, end = 0; begin < m; begin = end)
    {
      end = begin + 1;
      if (forces[begin] == 0)
        continue;
      while (end < m && forces[end] != 0)
        ++end;
      blas.GEMV(Teuchos::NO_TRANS,
                m,
                end - begin,
                1.,
                &products(0, begin),
                m,
                &forces[begin],
                1,
                1.,
                moved.begin(),
                1);
    }
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
} // namespace Setsudan
