// SPDX-License-Identifier: LGPL-2.1-or-later
#include <setsudan/contact/contact_path.h>

#include <algorithm>
#include <cmath>

namespace Setsudan
{
using namespace dealii;

namespace
{
/** A slip along the travel that differs by less is the same, relative to the
 * blade's way. */
constexpr double slip_tolerance = 1e-9;

/** Friction that differs by less is the same, relative to the largest: in
 * slender bodies that is round-off. */
constexpr double friction_tolerance = 1e-7;
} // namespace


template <int dim>
void
ContactPath<dim>::make_adhesion()
{
  adhesions.clear();
  moved_by_adhesion.assign(stage->products.m(), 0.);
  if (adhering.empty())
    return;
  for (const auto &flank : conditions)
    {
      const unsigned int wall = place_of_wall(flank.place, flank.wall);
      // A wall that sticks has its friction from its own condition.
      if (flank.kind != Kind::flank || !adhering[wall] || slips[wall].way == 0)
        continue;
      adhesions.emplace_back(stick_condition(flank.place, flank.wall),
                             slips[wall].way * sliding.adhesion);
      for (const auto &[b, factor] : adhesions.back().first.exerted)
        for (unsigned int a = 0; a < stage->products.m(); ++a)
          moved_by_adhesion[a] +=
            factor * adhesions.back().second * stage->products(a, b);
    }
}



template <int dim>
std::vector<bool>
ContactPath<dim>::touching() const
{
  std::vector<bool> walls(facets.size(), false);
  for (unsigned int i = 0; i < conditions.size(); ++i)
    if (conditions[i].kind == Kind::flank && piece.active[i])
      walls[place_of_wall(conditions[i].place, conditions[i].wall)] = true;
  return walls;
}



template <int dim>
void
ContactPath<dim>::update_adhesion(const std::vector<bool> &touched,
                                  const double travel)
{
  if (sliding.adhesion == 0)
    return;
  const auto touch  = touching();
  const auto before = adhering;
  adhering.resize(touch.size(), false);
  for (unsigned int wall = 0; wall < touch.size(); ++wall)
    if (touch[wall] != touched[wall])
      adhering[wall] = touch[wall];
  if (adhering == before)
    return;
  remake_conditions();
  settle(travel);
}



template <int dim>
bool
ContactPath<dim>::can_stick(const Condition &flank) const
{
  // Nothing moves a node that is supported.
  double compliance  = 0;
  const auto tangent = stick_condition(flank.place, flank.wall).measured;
  for (const auto &[a, factor] : tangent)
    for (const auto &[b, other] : tangent)
      compliance += factor * other * stage->products(a, b);
  return compliance > 0;
}



template <int dim>
void
ContactPath<dim>::stick(const unsigned int h,
                        const Wall wall,
                        const double travel)
{
  const Condition condition = stick_condition(h, wall);
  double place =
    condition.across * condition.measured[0].second * this->shift(travel) -
    condition.per_travel * travel;
  const auto [moved_at_0, rate] = moved_along_flank(condition);
  place += moved_at_0 + travel * rate;
  slips[place_of_wall(h, wall)] = {0, place};
}



template <int dim>
void
ContactPath<dim>::hold_walls(const double travel)
{
  for (unsigned int i = 0; i < conditions.size(); ++i)
    {
      const auto &condition = conditions[i];
      if (condition.kind != Kind::flank)
        continue;
      WallSlip &slip = slips[place_of_wall(condition.place, condition.wall)];
      if (!piece.active[i] || !can_stick(condition))
        slip.way = heading;
      else if (slip.way != 0)
        stick(condition.place, condition.wall, travel);
    }
}



template <int dim>
std::array<double, 2>
ContactPath<dim>::largest_friction(const unsigned int i) const
{
  const auto &condition = conditions[i];
  const bool adheres    = !adhering.empty() &&
                       adhering[place_of_wall(condition.place, condition.wall)];
  return {{sliding.friction * piece.multipliers.constant[i] +
             (adheres ? sliding.adhesion : 0.),
           sliding.friction * piece.multipliers.slope[i]}};
}



template <int dim>
std::optional<int>
ContactPath<dim>::other_way(const unsigned int i,
                            const double travel,
                            const double largest) const
{
  const auto &condition = conditions[i];
  const int way = slips[place_of_wall(condition.place, condition.wall)].way;
  if (!piece.active[i])
    return way == heading ? std::optional<int>() : heading;
  if (way != 0)
    {
      const auto along = moved(
        condition.place, condition.wall, ContactBasis<dim>::Component::along);
      if (way * heading * (1 - along[1]) >= -slip_tolerance)
        return {};
      return can_stick(condition) ? 0 : -way;
    }
  // What has come to touch since has no friction before it slips.
  if (!piece.active[i + 1])
    return heading;
  const auto [limit, rise] = largest_friction(i);
  const double theta       = piece.multipliers(i + 1, travel);
  const double rate        = heading * piece.multipliers.slope[i + 1];
  const double tolerance   = friction_tolerance * largest;
  const int sign = (std::abs(theta) > tolerance ? theta : rate) > 0 ? 1 : -1;
  const double beyond = sign * theta - (limit + travel * rise);
  // What has just begun to stick is at its limit.
  const bool rises = sign * rate - heading * rise >
                     slip_tolerance * (std::abs(rate) + std::abs(rise));
  return beyond > tolerance || (beyond > -tolerance && rises)
           ? sign
           : std::optional<int>();
}



template <int dim>
bool
ContactPath<dim>::update_slips(const double travel, const bool one)
{
  if (!has_turned)
    return false;
  double largest = 0;
  for (unsigned int i = 0; i < conditions.size(); ++i)
    if (conditions[i].kind == Kind::flank && piece.active[i])
      {
        const auto [limit, rise] = largest_friction(i);
        largest = std::max(largest, std::abs(limit + travel * rise));
      }
  bool any = false;
  for (unsigned int i = conditions.size(); i-- > 0;)
    {
      const auto &condition = conditions[i];
      if (condition.kind != Kind::flank)
        continue;
      const auto way = other_way(i, travel, largest);
      if (!way)
        continue;
      if (*way == 0)
        stick(condition.place, condition.wall, travel);
      else
        slips[place_of_wall(condition.place, condition.wall)].way = *way;
      any = true;
      if (one)
        return true;
    }
  return any;
}



template <int dim>
void
ContactPath<dim>::find_end_of_sticking(const double travel)
{
  for (unsigned int i = 0; i < conditions.size(); ++i)
    {
      if (conditions[i].kind != Kind::stick || !piece.active[i])
        continue;
      const auto [limit, rise] = largest_friction(i - 1);
      for (const int sign : {1, -1})
        {
          // What is left until it slips.
          const double left =
            limit + travel * rise - sign * piece.multipliers(i, travel);
          const double rate =
            heading * (rise - sign * piece.multipliers.slope[i]);
          if (rate >= -slip_tolerance * slip_tolerance *
                        (std::abs(rise) + std::abs(piece.multipliers.slope[i])))
            continue;
          const double p = travel + heading * std::max(left, 0.) / -rate;
          if (!is_before(p, end_of_piece))
            continue;
          end_of_piece = p;
          ending_condition.reset();
          ending_slip = {i - 1, sign};
        }
    }
}



#define INSTANTIATE(dim)                                                     \
  template void ContactPath<dim>::make_adhesion();                           \
  template std::vector<bool> ContactPath<dim>::touching() const;             \
  template void ContactPath<dim>::update_adhesion(const std::vector<bool> &, \
                                                  const double);             \
  template bool ContactPath<dim>::can_stick(const Condition &) const;        \
  template void ContactPath<dim>::stick(                                     \
    const unsigned int, const Wall, const double);                           \
  template void ContactPath<dim>::hold_walls(const double);                  \
  template std::array<double, 2> ContactPath<dim>::largest_friction(         \
    const unsigned int) const;                                               \
  template std::optional<int> ContactPath<dim>::other_way(                   \
    const unsigned int, const double, const double) const;                   \
  template bool ContactPath<dim>::update_slips(const double, const bool);    \
  template void ContactPath<dim>::find_end_of_sticking(const double);

INSTANTIATE(2)
INSTANTIATE(3)

#undef INSTANTIATE
} // namespace Setsudan
