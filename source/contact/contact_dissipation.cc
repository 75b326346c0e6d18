// SPDX-License-Identifier: LGPL-2.1-or-later
#include <setsudan/contact/contact_path.h>

#include <array>
#include <utility>

// The energy that friction takes.

namespace Setsudan
{
template <int dim>
double
ContactPath<dim>::dissipation(const Condition &condition,
                              const double travel,
                              const double along,
                              const double aside) const
{
  return condition.dissipation[0] * (travel - along) +
         condition.dissipation[1] * (sliding.slice * travel - aside);
}



template <int dim>
double
ContactPath<dim>::friction_work(const double begin, const double end) const
{
  using Component     = typename ContactBasis<dim>::Component;
  const double travel = end - begin;
  double work         = 0;
  // For a multiplier of 1.
  const auto taken = [&](const Condition &condition) {
    const auto moves = [&](const Component component) {
      return travel * moved(condition.place, condition.wall, component)[1];
    };
    return dissipation(condition,
                       travel,
                       moves(Component::along),
                       sliding.rubs_aside() ? moves(Component::aside) : 0.);
  };
  // What adheres may have left the blade since the last breakpoint.
  for (const auto &[condition, strength] : adhesions)
    work += strength * travel *
            (condition.per_travel - moved_along_flank(condition)[1]);
  for (unsigned int i = 0; i < conditions.size(); ++i)
    {
      const Condition &condition = conditions[i];
      if (!piece.active[i])
        continue;
      const double mean =
        (piece.multipliers(i, begin) + piece.multipliers(i, end)) / 2;
      if (condition.is_of_flank() && sliding.rubs())
        work += mean * taken(condition);
      // The edge slips along the front as far as it does not grip.
      if (condition.kind == Kind::edge)
        work +=
          mean * condition.aside * (sliding.slice - sliding.drag()) * travel;
    }
  return work;
}



template <int dim>
Quadratic
ContactPath<dim>::friction_work_to(const ContactPath &after) const
{
  using Component = typename ContactBasis<dim>::Component;
  Quadratic work;
  if (!sliding.rubs())
    return work;
  // How far a component of a wall moves as rows split, over the travel.
  const auto moves = [&](const Condition &condition,
                         const Component component) {
    const auto before = moved(condition.place, condition.wall, component);
    const auto behind = after.moved(condition.place, condition.wall, component);
    return std::array<double, 2>{
      {behind[0] - before[0], behind[1] - before[1]}};
  };
  const auto add =
    [&](const Condition &condition, const double constant, const double slope) {
      const auto along   = moves(condition, Component::along);
      const auto aside   = sliding.rubs_aside()
                             ? moves(condition, Component::aside)
                             : std::array<double, 2>{};
      const double slip0 = dissipation(condition, 0, along[0], aside[0]);
      const double slip1 = dissipation(condition, 0, along[1], aside[1]);
      work.c[0] += constant / 2 * slip0;
      work.c[1] += constant / 2 * slip1 + slope / 2 * slip0;
      work.c[2] += slope / 2 * slip1;
    };
  for (const ContactPath *path : {this, &after})
    {
      const auto &[constant, slope] = path->piece.multipliers;
      for (unsigned int i = 0; i < path->conditions.size(); ++i)
        if (path->piece.active[i] && path->conditions[i].is_of_flank())
          add(path->conditions[i], constant[i], slope[i]);
      for (const auto &[condition, strength] : path->adhesions)
        {
          const auto before = moved_along_flank(condition),
                     behind = after.moved_along_flank(condition);
          work.c[0] -= strength / 2 * (behind[0] - before[0]);
          work.c[1] -= strength / 2 * (behind[1] - before[1]);
        }
    }
  return work;
}



template <int dim>
double
ContactPath<dim>::friction_work_to(const ContactPath &after,
                                   const double begin,
                                   const double end) const
{
  using Component = typename ContactBasis<dim>::Component;
  if (!sliding.rubs())
    return 0;
  const double travel = end - begin;
  const auto moves    = [&](const Condition &condition,
                         const Component component) {
    const auto before = moved(condition.place, condition.wall, component);
    const auto behind = after.moved(condition.place, condition.wall, component);
    return behind[0] + end * behind[1] - before[0] - begin * before[1];
  };
  double work = 0;
  for (const auto &[path, p] :
       {std::make_pair(this, begin), std::make_pair(&after, end)})
    for (unsigned int i = 0; i < path->conditions.size(); ++i)
      {
        const Condition &condition = path->conditions[i];
        if (!path->piece.active[i])
          continue;
        const double half = path->piece.multipliers(i, p) / 2;
        if (condition.is_of_flank())
          work += half * dissipation(condition,
                                     travel,
                                     moves(condition, Component::along),
                                     sliding.rubs_aside()
                                       ? moves(condition, Component::aside)
                                       : 0.);
        if (condition.kind == Kind::edge)
          work +=
            half * condition.aside * (sliding.slice - sliding.drag()) * travel;
      }
  return work;
}



#define INSTANTIATE(dim)                                                      \
  template double ContactPath<dim>::friction_work(const double, const double) \
    const;                                                                    \
  template Quadratic ContactPath<dim>::friction_work_to(const ContactPath &)  \
    const;                                                                    \
  template double ContactPath<dim>::friction_work_to(                         \
    const ContactPath &, const double, const double) const;

INSTANTIATE(2)
INSTANTIATE(3)

#undef INSTANTIATE
} // namespace Setsudan
