// SPDX-License-Identifier: LGPL-2.1-or-later
#include <setsudan/solver/condensed/interface_system.h>

#include <algorithm>
#include <cmath>

namespace Setsudan
{
using namespace dealii;

namespace
{
// Ties are of factors about 1.
constexpr double round_off = 1e-13;
} // namespace


InterfaceSystem::InterfaceSystem(const std::vector<unsigned int> &unknowns,
                                 const SchurComplement &stiffness)
  : unknowns(unknowns)
  , stiffness(stiffness)
  , factor(unknowns.size())
{
}



bool
InterfaceSystem::columns_of(const Constraints &constraints,
                            std::vector<unsigned int> &free,
                            std::vector<Column> &columns) const
{
  const auto place_of = [&](const types::global_dof_index unknown) {
    const auto found =
      std::lower_bound(unknowns.begin(), unknowns.end(), unknown);
    return found != unknowns.end() && *found == unknown
             ? static_cast<int>(found - unknowns.begin())
             : -1;
  };
  std::vector<int> column_of(unknowns.size(), -1);
  for (unsigned int i = 0; i < unknowns.size(); ++i)
    if (!constraints.is_constrained(unknowns[i]))
      {
        column_of[i] = columns.size();
        free.push_back(i);
        columns.push_back({{i, 1.}});
      }
  for (unsigned int i = 0; i < unknowns.size(); ++i)
    if (column_of[i] < 0)
      for (const auto &[master, weight] :
           *constraints.get_constraint_entries(unknowns[i]))
        {
          const int place = place_of(master);
          if (place < 0 || column_of[place] < 0)
            return false;
          columns[column_of[place]].emplace_back(i, weight);
        }
  return true;
}



unsigned int
InterfaceSystem::n_that_fit(const std::vector<unsigned int> &free,
                            const std::vector<Column> &columns) const
{
  std::vector<int> column_of(unknowns.size(), -1);
  for (unsigned int c = 0; c < free.size(); ++c)
    column_of[free[c]] = c;
  // A displacement obeys the ties if it is what they make of its free unknowns.
  std::vector<double> rest(unknowns.size(), 0.);
  for (unsigned int c = 0; c < basis.size(); ++c)
    {
      if (column_of[free_unknowns[c]] < 0)
        return c;
      for (const auto &[i, value] : basis[c])
        rest[i] += value;
      for (const auto &[i, value] : basis[c])
        if (column_of[i] >= 0)
          for (const auto &[j, weight] : columns[column_of[i]])
            rest[j] -= weight * value;
      bool fits = true;
      for (const auto &[i, value] : basis[c])
        {
          if (column_of[i] >= 0)
            for (const auto &[j, weight] : columns[column_of[i]])
              {
                fits    = fits && std::abs(rest[j]) <= round_off;
                rest[j] = 0;
              }
          fits    = fits && std::abs(rest[i]) <= round_off;
          rest[i] = 0;
        }
      if (!fits)
        return c;
    }
  return basis.size();
}



bool
InterfaceSystem::place(const Constraints &stage)
{
  std::vector<unsigned int> free;
  std::vector<Column> columns;
  if (!columns_of(stage, free, columns))
    return false;
  const unsigned int n_kept = n_that_fit(free, columns);
  n_columns                 = free.size();
  // What a later stage has added does no harm.
  if (n_kept == n_columns)
    return true;
  factor.shrink(std::min(factor.size(), n_kept));
  free_unknowns.resize(n_kept);
  basis.resize(n_kept);
  std::vector<bool> is_known(unknowns.size(), false);
  for (const unsigned int i : free_unknowns)
    is_known[i] = true;
  for (unsigned int c = 0; c < n_columns; ++c)
    if (!is_known[free[c]])
      {
        free_unknowns.push_back(free[c]);
        basis.push_back(std::move(columns[c]));
      }
  return true;
}



bool
InterfaceSystem::append_stage(const Constraints &stage)
{
  return place(stage);
}



void
InterfaceSystem::factorize_stages()
{
  factorize(basis.size());
}



void
InterfaceSystem::factorize(const unsigned int n)
{
  if (n <= factor.size())
    return;
  factor.append(n - factor.size(),
                [&](const unsigned int row, const unsigned int column) {
                  double sum = 0;
                  for (const auto &[i, weight] : basis[row])
                    for (const auto &[j, other] : basis[column])
                      sum += weight * other * stiffness(i, j);
                  return sum;
                });
}



bool
InterfaceSystem::set_constraints(const Constraints &stage)
{
  if (!place(stage))
    return false;
  factorize(n_columns);
  return true;
}



std::vector<double>
InterfaceSystem::displacement(const double *forces) const
{
  std::vector<double> q(n_columns, 0.), u(unknowns.size(), 0.);
  for (unsigned int c = 0; c < n_columns; ++c)
    for (const auto &[i, weight] : basis[c])
      q[c] += weight * forces[i];
  factor.solve(q);
  for (unsigned int c = 0; c < n_columns; ++c)
    for (const auto &[i, weight] : basis[c])
      u[i] += weight * q[c];
  return u;
}



LAPACKFullMatrix<double>
InterfaceSystem::half_displacements(
  const std::vector<UnknownForces> &forces) const
{
  // The columns of Q in which an unknown of the interface is.
  std::vector<Column> columns_of_unknown(unknowns.size());
  for (unsigned int c = 0; c < factor.size(); ++c)
    for (const auto &[i, weight] : basis[c])
      columns_of_unknown[i].emplace_back(c, weight);
  LAPACKFullMatrix<double> y(factor.size(), forces.size());
  for (unsigned int f = 0; f < forces.size(); ++f)
    for (const auto &[i, force] : forces[f])
      for (const auto &[c, weight] : columns_of_unknown[i])
        y(c, f) += weight * force;
  factor.solve_lower(y);
  return y;
}
} // namespace Setsudan
