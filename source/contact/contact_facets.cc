// SPDX-License-Identifier: LGPL-2.1-or-later
#include <setsudan/contact/contact_path.h>

#include <algorithm>
#include <tuple>

namespace Setsudan
{
using namespace dealii;

template <int dim>
std::array<double, 2>
ContactPath<dim>::moved_along_flank(const Condition &stick) const
{
  using Component  = typename ContactBasis<dim>::Component;
  const auto along = moved(stick.place, stick.wall, Component::along);
  const auto out   = moved(stick.place, stick.wall, Component::outward);
  const auto tilt  = -stick.measured[0].second;
  const auto area  = basis.hats()[stick.place].area;
  return {
    {area * (along[0] - tilt * out[0]), area * (along[1] - tilt * out[1])}};
}



template <int dim>
std::array<double, 2>
ContactPath<dim>::distance_behind_edge(const unsigned int h,
                                       const Wall wall) const
{
  if (profile.presses_across)
    return {{-basis.hats()[h].depth, 1.}};
  const auto along = moved(h, wall, ContactBasis<dim>::Component::along);
  return {{-basis.hats()[h].depth - along[0], 1 - along[1]}};
}



template <int dim>
std::vector<unsigned int>
ContactPath<dim>::update_facets(const double travel,
                                const double tolerance,
                                const bool back)
{
  std::vector<unsigned int> changed;
  for (unsigned int i = 0; i < conditions.size(); ++i)
    {
      if (conditions[i].kind != Kind::flank || keeps_facet(conditions[i]))
        continue;
      const unsigned int h = conditions[i].place;
      const Wall wall      = conditions[i].wall;
      unsigned int &k      = facet(h, wall);
      const bool adheres =
        !adhering.empty() && adhering[place_of_wall(h, wall)];
      const bool may_turn = back && !piece.active[i] && !adheres;
      const bool has_next =
        k + 1 < profile.facets.size() && (heading > 0 || may_turn);
      const bool has_last = k > 0 && (heading < 0 || may_turn);
      if (!has_next && !has_last)
        continue;
      const auto behind = distance_behind_edge(h, wall);
      const double s    = behind[0] + travel * behind[1];
      if (has_next && s >= profile.facets[k + 1].begin + tolerance)
        {
          ++k;
          changed.push_back(i);
        }
      else if (has_last && s < profile.facets[k].begin - tolerance)
        {
          --k;
          changed.push_back(i);
        }
    }
  return changed;
}



template <int dim>
bool
ContactPath<dim>::may_meet(const unsigned int h) const
{
  const auto &hat = basis.hats()[h];
  if (hat.outer)
    return false;
  for (const Wall wall : {Wall::minus, Wall::plus})
    if (!profile.facets.empty() && hat.is_of(wall) &&
        !profile.is_tip(facet(h, wall)))
      return false;
  return true;
}



template <int dim>
bool
ContactPath<dim>::changes_alone(const unsigned int flank) const
{
  const auto &[h, wall] =
    std::tie(conditions[flank].place, conditions[flank].wall);
  // Behind its flanks, and what sticks, is the condition of a hat's walls.
  unsigned int next = flank + 1;
  while (next < conditions.size() && conditions[next].is_of_flank() &&
         conditions[next].place == h)
    ++next;
  const bool could_meet = next < conditions.size() &&
                          conditions[next].kind == Kind::walls &&
                          conditions[next].place == h;
  return slips[place_of_wall(h, wall)].way != 0 && could_meet == may_meet(h);
}



template <int dim>
void
ContactPath<dim>::take_facets(const std::vector<unsigned int> &flanks)
{
  if (!sliding.is_guided || !adhering.empty() ||
      !std::all_of(flanks.begin(), flanks.end(), [&](const unsigned int i) {
        return changes_alone(i);
      }))
    return remake_conditions();
  for (const unsigned int i : flanks)
    {
      Condition &condition = conditions[i];
      condition            = flank_condition(condition.place, condition.wall);
      problem->replace(
        i, condition.measured, condition.exerted, required_by(condition));
    }
}



template <int dim>
bool
ContactPath<dim>::keeps_facet(const Condition &flank) const
{
  // It moves with the blade.
  return !profile.presses_across &&
         slips[place_of_wall(flank.place, flank.wall)].way == 0;
}



template <int dim>
void
ContactPath<dim>::find_end_of_facets(const double travel)
{
  for (const auto &condition : conditions)
    {
      if (condition.kind != Kind::flank || keeps_facet(condition))
        continue;
      const unsigned int k    = facet(condition.place, condition.wall);
      const unsigned int next = heading > 0 ? k + 1 : k;
      if (next == 0 || next == profile.facets.size())
        continue;
      const auto behind = distance_behind_edge(condition.place, condition.wall);
      if (behind[1] <= 0)
        continue;
      double p = (profile.facets[next].begin - behind[0]) / behind[1];
      if (is_before(p, travel))
        p = travel;
      if (is_before(p, end_of_piece))
        {
          end_of_piece = p;
          ending_condition.reset();
        }
    }
}



#define INSTANTIATE(dim)                                              \
  template std::array<double, 2> ContactPath<dim>::moved_along_flank( \
    const Condition &) const;                                         \
  template std::vector<unsigned int> ContactPath<dim>::update_facets( \
    const double, const double, const bool);                          \
  template bool ContactPath<dim>::may_meet(const unsigned int) const; \
  template void ContactPath<dim>::take_facets(                        \
    const std::vector<unsigned int> &);                               \
  template void ContactPath<dim>::find_end_of_facets(const double);

INSTANTIATE(2)
INSTANTIATE(3)

#undef INSTANTIATE
} // namespace Setsudan
