// SPDX-License-Identifier: LGPL-2.1-or-later
#include <setsudan/solver/multigrid/local_constraints.h>

namespace Setsudan
{
using namespace dealii;

LocalConstraints::LocalConstraints(const AffineConstraints<double> &constraints,
                                   const Partitioner &partitioner)
  : starts(1, 0)
{
  const unsigned int n_owned = partitioner.locally_owned_size();
  const unsigned int n_known = n_owned + partitioner.n_ghost_indices();
  is_line.assign(n_known, false);
  for (unsigned int place = 0; place < n_known; ++place)
    {
      const auto index = partitioner.local_to_global(place);
      if (!constraints.is_constrained(index))
        continue;
      places.push_back(place);
      is_line[place] = true;
      if (place < n_owned)
        owned_places.push_back(place);
      for (const auto &[master, weight] :
           *constraints.get_constraint_entries(index))
        entries.push_back({partitioner.global_to_local(master), weight});
      starts.push_back(entries.size());
    }
}



void
LocalConstraints::distribute(Vector &vector) const
{
  double *const values = vector.begin();
  for (unsigned int line = 0; line < places.size(); ++line)
    {
      double value = 0;
      for (unsigned int e = starts[line]; e < starts[line + 1]; ++e)
        value += entries[e].weight * values[entries[e].place];
      values[places[line]] = value;
    }
}



void
LocalConstraints::hand_over(Vector &forces, const unsigned int power) const
{
  double *const values = forces.begin();
  for (unsigned int line = 0; line < places.size(); ++line)
    {
      const double force   = values[places[line]];
      values[places[line]] = 0;
      for (unsigned int e = starts[line]; e < starts[line + 1]; ++e)
        values[entries[e].place] +=
          (power == 1 ? entries[e].weight
                      : entries[e].weight * entries[e].weight) *
          force;
    }
}



void
LocalConstraints::condense(Vector &forces) const
{
  hand_over(forces, 1);
}



void
LocalConstraints::condense_diagonal(Vector &diagonal) const
{
  hand_over(diagonal, 2);
}



bool
LocalConstraints::is_constrained(const unsigned int place) const
{
  return is_line[place];
}



const std::vector<unsigned int> &
LocalConstraints::owned() const
{
  return owned_places;
}
} // namespace Setsudan
