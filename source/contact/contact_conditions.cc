// SPDX-License-Identifier: LGPL-2.1-or-later
#include <setsudan/contact/contact_path.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace Setsudan
{
using namespace dealii;

template <int dim>
bool
ContactCondition<dim>::is_same(const ContactCondition &other) const
{
  return kind == other.kind && place == other.place &&
         (!is_of_flank() || wall == other.wall) && direction == other.direction;
}



template <int dim>
double
ContactPath<dim>::tilt(const unsigned int h, const Wall wall) const
{
  return profile.presses_across ? 0. : profile.facets[facet(h, wall)].slope;
}



template <int dim>
typename ContactPath<dim>::Condition
ContactPath<dim>::flank_condition(const unsigned int h, const Wall wall) const
{
  using Component = typename ContactBasis<dim>::Component;
  const auto &hat = basis.hats()[h];
  const auto &[begin, half_thickness, slope] = profile.facets[facet(h, wall)];
  const double mu = slips[place_of_wall(h, wall)].way * sliding.friction /
                    std::sqrt(1 + sliding.slice * sliding.slice);
  const double tilt          = this->tilt(h, wall);
  const double length        = std::sqrt(1 + tilt * tilt);
  const double rubbed        = mu * sliding.slice * length;
  const unsigned int outward = stage->place_of_hat(h, wall, Component::outward);
  const unsigned int along   = stage->place_of_hat(h, wall, Component::along);
  const unsigned int aside   = sliding.rubs_aside()
                                 ? stage->place_of_hat(h, wall, Component::aside)
                                 : along;
  Condition condition;
  condition.kind     = Kind::flank;
  condition.place    = h;
  condition.wall     = wall;
  condition.measured = {{{outward, 1.}, {along, tilt}, {along, 0.}}};
  condition.exerted  = {
     {{outward, 1 - mu * tilt}, {along, tilt + mu}, {aside, rubbed}}};
  condition.area      = hat.area;
  condition.across    = wall == Wall::plus ? -hat.across : hat.across;
  const double offset = hat.outer ? hat.outer->offset : 0.;
  condition.constant =
    hat.area * (half_thickness - slope * (begin + hat.depth) - offset);
  condition.per_travel  = hat.area * slope;
  condition.force       = hat.area * (slope + mu);
  condition.unfelt      = hat.area * (slope - tilt);
  condition.friction    = hat.area * mu;
  condition.aside       = hat.area * rubbed;
  condition.dissipation = {
    {hat.area * mu * length * length, hat.area * rubbed}};
  return condition;
}



template <int dim>
typename ContactPath<dim>::Condition
ContactPath<dim>::stick_condition(const unsigned int h, const Wall wall) const
{
  using Component            = typename ContactBasis<dim>::Component;
  const auto &hat            = basis.hats()[h];
  const double tilt          = this->tilt(h, wall);
  const unsigned int outward = stage->place_of_hat(h, wall, Component::outward);
  const unsigned int along   = stage->place_of_hat(h, wall, Component::along);
  Condition condition;
  condition.kind        = Kind::stick;
  condition.place       = h;
  condition.wall        = wall;
  condition.measured    = {{{outward, -tilt}, {along, 1.}, {along, 0.}}};
  condition.exerted     = condition.measured;
  condition.across      = wall == Wall::plus ? -hat.across : hat.across;
  condition.constant    = slips[place_of_wall(h, wall)].anchor;
  condition.per_travel  = hat.area;
  condition.force       = hat.area;
  condition.friction    = hat.area;
  condition.dissipation = {{hat.area * (1 + tilt * tilt), 0.}};
  return condition;
}



template <int dim>
typename ContactPath<dim>::Condition
ContactPath<dim>::walls_condition(const unsigned int h) const
{
  using Component = typename ContactBasis<dim>::Component;
  Condition condition;
  condition.kind     = Kind::walls;
  condition.place    = h;
  condition.area     = basis.hats()[h].area;
  condition.force    = basis.split_area(h, stage->row);
  condition.constant = profile.keeps_apart * condition.force;
  if (basis.has_flanks())
    condition.measured = {
      {{stage->place_of_hat(h, Wall::minus, Component::outward), 1.},
       {stage->place_of_hat(h, Wall::plus, Component::outward), 1.},
       {0, 0.}}};
  else
    condition.measured = {
      {{stage->place_of[basis.first_vector_of_hat(h)], 1.}, {0, 0.}, {0, 0.}}};
  condition.exerted = condition.measured;
  return condition;
}



template <int dim>
typename ContactPath<dim>::Condition
ContactPath<dim>::earlier_walls_condition(const unsigned int corner) const
{
  const unsigned int place =
    stage->place_of[basis.first_vector_of_earlier_corners() + corner];
  Condition condition;
  condition.kind     = Kind::walls;
  condition.place    = basis.hats().size() + corner;
  condition.area     = basis.area_of_earlier_corner(corner);
  condition.measured = {{{place, 1.}, {place, 0.}, {place, 0.}}};
  condition.exerted  = condition.measured;
  return condition;
}



template <int dim>
typename ContactPath<dim>::Condition
ContactPath<dim>::edge_condition(const unsigned int node) const
{
  const unsigned int place = stage->place_of[basis.vector_of_edge_node(node)];
  const double drag        = sliding.drag();
  const double way         = 1 + drag * drag;
  Condition condition;
  condition.kind       = Kind::edge;
  condition.place      = node;
  condition.measured   = {{{place, 1.}, {place, 0.}, {place, 0.}}};
  condition.exerted    = condition.measured;
  condition.constant   = -basis.edge_nodes()[node].depth * way;
  condition.per_travel = way;
  condition.force      = 1;
  condition.aside      = drag;
  return condition;
}



template <int dim>
typename ContactPath<dim>::Condition
ContactPath<dim>::hold_condition(const unsigned int node) const
{
  const unsigned int place =
    stage->place_of[basis.vector_of_edge_node(node) + 1];
  Condition condition;
  condition.kind     = Kind::hold;
  condition.place    = node;
  condition.measured = {{{place, 1.}, {place, 0.}, {place, 0.}}};
  condition.exerted  = condition.measured;
  return condition;
}



template <int dim>
bool
ContactPath<dim>::update_holds()
{
  bool any = false;
  for (unsigned int i = 1; i < conditions.size(); ++i)
    if (conditions[i].kind == Kind::hold && piece.active[i - 1] &&
        !piece.active[i])
      any = piece.active[i] = true;
  return any;
}



template <int dim>
void
ContactPath<dim>::make_conditions()
{
  conditions.clear();
  conditions.reserve(stage->vector_at.size());
  for (unsigned int h = 0; h < basis.hats().size(); ++h)
    {
      const auto &hat = basis.hats()[h];
      if (!hat.is_there(stage->row) || (hat.outer && !stage->can_move(h)))
        continue;
      if (!profile.facets.empty())
        for (const Wall wall : {Wall::minus, Wall::plus})
          {
            if (!hat.is_of(wall))
              continue;
            conditions.push_back(flank_condition(h, wall));
            if (slips[place_of_wall(h, wall)].way == 0)
              conditions.push_back(stick_condition(h, wall));
          }
      // Elsewhere the flanks keep the walls apart, and nothing moves walls that
      // are supported.
      const unsigned int first = stage->place_of[basis.first_vector_of_hat(h)];
      if (may_meet(h) &&
          (basis.has_flanks() || stage->products(first, first) != 0))
        conditions.push_back(walls_condition(h));
    }
  for (unsigned int n = 0; n < basis.edge_nodes().size(); ++n)
    if (basis.edge_nodes()[n].row == stage->row)
      {
        const unsigned int place =
          stage->place_of[basis.vector_of_edge_node(n)];
        // Nothing moves a node that is supported.
        if (stage->products(place, place) == 0)
          continue;
        conditions.push_back(edge_condition(n));
        if (basis.edge_holds() && stage->products(place + 1, place + 1) != 0)
          conditions.push_back(hold_condition(n));
      }
  for (unsigned int i = 0; i < basis.n_earlier_corners(); ++i)
    {
      const unsigned int place =
        stage->place_of[basis.first_vector_of_earlier_corners() + i];
      if (stage->products(place, place) != 0)
        conditions.push_back(earlier_walls_condition(i));
    }
  add_board_conditions();
  make_adhesion();
  make_problem();
}



template <int dim>
std::array<double, 2>
ContactPath<dim>::required_by(const Condition &condition) const
{
  std::array<double, 2> required{{condition.constant, condition.per_travel}};
  for (const auto &[a, factor] : condition.measured)
    {
      required[0] -= factor * (stage->untouched.displacements.constant[a] +
                               moved_by_adhesion[a]);
      required[1] -= factor * stage->untouched.displacements.slope[a];
    }
  return required;
}



template <int dim>
void
ContactPath<dim>::make_problem()
{
  const unsigned int n = conditions.size();
  LinearInParameter required{Vector<double>(n), Vector<double>(n)};
  std::vector<VectorSum> measured, exerted;
  // Where both flanks touch, whether the walls do follows from that.
  std::vector<unsigned int> redundant;
  std::optional<SharedUnknown> blade;
  if (!sliding.is_guided)
    blade = {Vector<double>(n), Vector<double>(n), 0.};
  double softest = std::numeric_limits<double>::min();
  for (unsigned int i = 0; i < n; ++i)
    {
      measured.push_back(conditions[i].measured);
      exerted.push_back(conditions[i].exerted);
      const auto [constant, slope] = required_by(conditions[i]);
      required.constant[i]         = constant;
      required.slope[i]            = slope;
      if (conditions[i].kind == Kind::walls)
        redundant.push_back(i);
      if (!blade || !conditions[i].is_of_flank())
        continue;
      // The unknown is how far it goes from where it rested.
      const double across         = conditions[i].across;
      const double area           = basis.hats()[conditions[i].place].area;
      const auto &[out, pressure] = conditions[i].exerted[0];
      blade->measured[i]          = across * conditions[i].measured[0].second;
      blade->exerted[i]           = across * pressure;
      required.constant[i] -= blade->measured[i] * resting_shift;
      softest = std::max(softest, stage->products(out, out) / (area * area));
    }
  // Less than what any number of the results tells.
  if (blade)
    blade->stiffness = 1e-10 / softest;
  problem =
    std::make_unique<Complementarity>(stage->products,
                                      ContactConditions{std::move(measured),
                                                        std::move(exerted),
                                                        std::move(required),
                                                        std::move(blade),
                                                        std::move(redundant),
                                                        make_leaders(),
                                                        make_foundation()});
}



template <int dim>
void
ContactPath<dim>::remake_conditions()
{
  const auto others = std::move(conditions);
  const auto active = std::move(piece.active);
  make_conditions();
  piece.active.assign(conditions.size(), false);
  unsigned int o = 0;
  // Both are in the order of the hats.
  for (unsigned int i = 0; i < conditions.size(); ++i)
    {
      const auto same =
        std::find_if(others.begin() + o, others.end(), [&](const auto &other) {
          return conditions[i].is_same(other);
        });
      if (same != others.end())
        {
          o               = same - others.begin();
          piece.active[i] = active[o];
        }
      else if (conditions[i].kind == Kind::stick)
        piece.active[i] = piece.active[i - 1];
    }
}



#define INSTANTIATE(dim)                                                   \
  template bool ContactCondition<dim>::is_same(const ContactCondition &)   \
    const;                                                                 \
  template typename ContactPath<dim>::Condition                            \
  ContactPath<dim>::stick_condition(const unsigned int, const Wall) const; \
  template std::array<double, 2> ContactPath<dim>::required_by(            \
    const Condition &) const;                                              \
  template typename ContactPath<dim>::Condition                            \
  ContactPath<dim>::flank_condition(const unsigned int, const Wall) const; \
  template bool ContactPath<dim>::update_holds();                          \
  template void ContactPath<dim>::make_conditions();                       \
  template void ContactPath<dim>::remake_conditions();

INSTANTIATE(2)
INSTANTIATE(3)

#undef INSTANTIATE
} // namespace Setsudan
