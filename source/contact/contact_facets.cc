// SPDX-License-Identifier: LGPL-2.1-or-later
#include <setsudan/contact/contact_path.h>

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
bool
ContactPath<dim>::update_facets(const double travel,
                                const double tolerance,
                                const bool back)
{
  bool any = false;
  for (unsigned int i = 0; i < conditions.size(); ++i)
    {
      if (conditions[i].kind != Kind::flank || keeps_facet(conditions[i]))
        continue;
      const unsigned int h = conditions[i].place;
      const Wall wall      = conditions[i].wall;
      const auto behind    = distance_behind_edge(h, wall);
      const double s       = behind[0] + travel * behind[1];
      unsigned int &k      = facet(h, wall);
      const bool is_past   = k + 1 < profile.facets.size() &&
                           s >= profile.facets[k + 1].begin + tolerance;
      const bool is_ahead = k > 0 && s < profile.facets[k].begin - tolerance;
      const bool adheres =
        !adhering.empty() && adhering[place_of_wall(h, wall)];
      const bool may_turn = back && !piece.active[i] && !adheres;
      if (is_past && (heading > 0 || may_turn))
        {
          ++k;
          any = true;
        }
      else if (is_ahead && (heading < 0 || may_turn))
        {
          --k;
          any = true;
        }
    }
  return any;
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
  template bool ContactPath<dim>::update_facets(                      \
    const double, const double, const bool);                          \
  template void ContactPath<dim>::find_end_of_facets(const double);

INSTANTIATE(2)
INSTANTIATE(3)

#undef INSTANTIATE
} // namespace Setsudan
