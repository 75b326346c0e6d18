// SPDX-License-Identifier: LGPL-2.1-or-later
#include <setsudan/contact/contact_path.h>
#include <setsudan/parameters/exceptions.h>

#include <algorithm>
#include <cmath>

namespace Setsudan
{
using namespace dealii;

template <int dim>
bool
ContactPath<dim>::Condition::is_same(const Condition &other) const
{
  return kind == other.kind && place == other.place &&
         (kind != Kind::flank || wall == other.wall);
}



template <int dim>
ContactPath<dim>::ContactPath(const ContactBasis<dim> &basis,
                              const BladeProfile &profile,
                              const SlidingBlade &sliding,
                              const unsigned int row,
                              const unsigned int n_ahead,
                              const LAPACKFullMatrix<double> &all_products,
                              const std::vector<double> &work_in_lift,
                              const double smallest_step)
  : basis(basis)
  , profile(profile)
  , sliding(sliding)
  , row(row)
  , place_of(basis.vectors().size(), numbers::invalid_unsigned_int)
  , smallest_step(smallest_step)
  , facets(2 * basis.hats().size(), 0)
{
  std::vector<unsigned int> used;
  const auto use = [&](const unsigned int vector) {
    place_of[vector] = used.size();
    used.push_back(vector);
  };
  for (unsigned int h = 0; h < basis.hats().size(); ++h)
    if (basis.hats()[h].row < row + n_ahead)
      for (unsigned int i = 0; i < basis.n_vectors_of_hat(); ++i)
        use(basis.first_vector_of_hat(h) + i);
  for (unsigned int n = 0; n < basis.edge_nodes().size(); ++n)
    if (basis.edge_nodes()[n].row == row)
      use(basis.vector_of_edge_node(n));
  const unsigned int loads = basis.vectors().size();
  products.reinit(used.size());
  for (unsigned int j = 0; j < used.size(); ++j)
    {
      for (unsigned int i = 0; i < used.size(); ++i)
        products(i, j) = all_products(used[i], used[j]);
      displacement_at_rest.push_back(all_products(used[j], loads) +
                                     work_in_lift[used[j]]);
    }
  energy_at_rest = -all_products(loads, loads) / 2;
  double softest = std::numeric_limits<double>::min();
  for (unsigned int h = 0; h < basis.hats().size(); ++h)
    for (const Wall wall : {Wall::minus, Wall::plus})
      {
        const unsigned int place = place_of[basis.vector_of_hat(
          h, wall, ContactBasis<dim>::Component::outward)];
        if (place != numbers::invalid_unsigned_int)
          softest = std::max(softest,
                             products(place, place) /
                               (basis.hats()[h].area * basis.hats()[h].area));
      }
  weakest_guide = 1e-10 / softest;
}



template <int dim>
void
ContactPath<dim>::make_conditions()
{
  using Component = typename ContactBasis<dim>::Component;
  conditions.clear();
  const double mu =
    sliding.friction / std::sqrt(1 + sliding.slice * sliding.slice);
  for (unsigned int h = 0; h < basis.hats().size(); ++h)
    {
      const auto &hat = basis.hats()[h];
      if (hat.row >= row)
        continue;
      const auto vector = [&](const Wall wall, const Component component) {
        return place_of[basis.vector_of_hat(h, wall, component)];
      };
      bool may_meet = true;
      for (const Wall wall : {Wall::minus, Wall::plus})
        if (!profile.facets.empty())
          {
            const auto &[begin, half_thickness, slope] =
              profile.facets[facet(h, wall)];
            may_meet = may_meet && profile.is_tip(facet(h, wall));
            const unsigned int outward = vector(wall, Component::outward);
            const unsigned int along   = vector(wall, Component::along);
            const unsigned int aside =
              sliding.rubs_aside() ? vector(wall, Component::aside) : along;
            const double tilt   = profile.presses_across ? 0. : slope;
            const double length = std::sqrt(1 + tilt * tilt);
            const double rubbed = mu * sliding.slice * length;
            conditions.push_back(
              {Kind::flank,
               h,
               wall,
               {{{outward, 1.}, {along, tilt}, {along, 0.}}},
               {{{outward, 1 - mu * tilt},
                 {along, tilt + mu},
                 {aside, rubbed}}},
               hat.area * (half_thickness - slope * (begin + hat.depth)),
               hat.area * slope,
               hat.area * (slope + mu),
               hat.area * (slope - tilt),
               hat.area * mu,
               hat.area * rubbed,
               {{hat.area * mu * length * length, hat.area * rubbed}},
               wall == Wall::plus ? -hat.across : hat.across});
          }
      // Elsewhere the flanks keep the walls apart.
      const unsigned int minus = vector(Wall::minus, Component::outward);
      const unsigned int plus  = vector(Wall::plus, Component::outward);
      const VectorSum both     = {{{minus, 1.}, {plus, 1.}, {plus, 0.}}};
      if (may_meet)
        conditions.push_back({Kind::walls,
                              h,
                              Wall::minus,
                              both,
                              both,
                              0.,
                              0.,
                              0.,
                              0.,
                              0.,
                              0.,
                              {}});
    }
  for (unsigned int n = 0; n < basis.edge_nodes().size(); ++n)
    {
      const auto &node = basis.edge_nodes()[n];
      if (node.row != row)
        continue;
      const unsigned int place = place_of[basis.vector_of_edge_node(n)];
      const VectorSum dragged  = {{{place, 1.}, {place, 0.}, {place, 0.}}};
      const double drag        = sliding.drag();
      const double way         = 1 + drag * drag;
      // Nothing moves a node that is supported.
      if (products(place, place) > 0)
        conditions.push_back({Kind::edge,
                              n,
                              Wall::minus,
                              dragged,
                              dragged,
                              -node.depth * way,
                              way,
                              1.,
                              0.,
                              0.,
                              drag,
                              {},
                              0.});
    }
  make_problem();
}



template <int dim>
void
ContactPath<dim>::make_problem()
{
  const unsigned int n = conditions.size();
  LinearInParameter required{Vector<double>(n), Vector<double>(n)};
  std::vector<VectorSum> measured, exerted;
  std::optional<SharedUnknown> blade;
  if (!sliding.is_guided)
    blade = {Vector<double>(n), Vector<double>(n), weakest_guide};
  for (unsigned int i = 0; i < n; ++i)
    {
      measured.push_back(conditions[i].measured);
      exerted.push_back(conditions[i].exerted);
      required.constant[i] = conditions[i].constant;
      required.slope[i]    = conditions[i].per_travel;
      for (const auto &[a, factor] : conditions[i].measured)
        required.constant[i] -= factor * displacement_at_rest[a];
      if (!blade)
        continue;
      // The unknown is how far it goes from where it rested.
      required.constant[i] -= conditions[i].across * resting_shift;
      blade->measured[i] = conditions[i].across;
      blade->exerted[i] =
        conditions[i].across * conditions[i].exerted[0].second;
    }
  problem = std::make_unique<Complementarity>(products,
                                              std::move(measured),
                                              std::move(exerted),
                                              std::move(required),
                                              std::move(blade));
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
    }
}



template <int dim>
std::array<double, 2>
ContactPath<dim>::moved(
  const unsigned int h,
  const Wall wall,
  const typename ContactBasis<dim>::Component component) const
{
  const double area        = basis.hats()[h].area;
  const unsigned int place = place_of[basis.vector_of_hat(h, wall, component)];
  return {
    {(displacement_at_rest[place] + piece.displacements.constant[place]) / area,
     piece.displacements.slope[place] / area}};
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
      if (conditions[i].kind != Kind::flank)
        continue;
      const unsigned int h = conditions[i].place;
      const Wall wall      = conditions[i].wall;
      const auto behind    = distance_behind_edge(h, wall);
      const double s       = behind[0] + travel * behind[1];
      unsigned int &k      = facet(h, wall);
      if (k + 1 < profile.facets.size() &&
          s >= profile.facets[k + 1].begin + tolerance)
        {
          ++k;
          any = true;
        }
      else if (back && k > 0 && !piece.active[i] &&
               s < profile.facets[k].begin - tolerance)
        {
          --k;
          any = true;
        }
    }
  return any;
}



template <int dim>
void
ContactPath<dim>::settle(const double travel)
{
  // A wall that goes back and forth between two facets stays on the second one.
  constexpr unsigned int most_back = 20;
  const unsigned int most          = most_back + profile.facets.size();
  for (unsigned int round = 0; round <= most; ++round)
    {
      take_piece(travel, problem->active_set(travel, piece.active));
      if (!update_facets(travel, 1e-2 * smallest_step, round < most_back))
        return;
      remake_conditions();
    }
  throw SolverError("The walls of the cut do not come to rest on the blade's "
                    "shoulder. Set Blade/Shoulder radius larger, or Blade/"
                    "Profile with more points.");
}



template <int dim>
void
ContactPath<dim>::take_piece(const double travel, const ActiveSet &active)
{
  piece            = problem->piece(active);
  const auto end   = problem->end_of(piece, travel);
  end_of_piece     = end ? end->p : std::numeric_limits<double>::infinity();
  ending_condition = end ? std::optional<unsigned int>(end->condition)
                         : std::optional<unsigned int>();
  if (profile.facets.size() < 2)
    return;
  for (const auto &condition : conditions)
    {
      if (condition.kind != Kind::flank)
        continue;
      const unsigned int k = facet(condition.place, condition.wall);
      if (k + 1 == profile.facets.size())
        continue;
      const auto behind = distance_behind_edge(condition.place, condition.wall);
      if (behind[1] <= 0)
        continue;
      const double p =
        std::max((profile.facets[k + 1].begin - behind[0]) / behind[1], travel);
      if (p < end_of_piece)
        {
          end_of_piece = p;
          ending_condition.reset();
        }
    }
}



template <int dim>
void
ContactPath<dim>::begin(const BladeMotion &motion, const ContactPath *neighbour)
{
  resting_shift = motion.shift;
  if (neighbour != nullptr)
    {
      facets       = neighbour->facets;
      conditions   = neighbour->conditions;
      piece.active = neighbour->piece.active;
    }
  remake_conditions();
  settle(motion.travel);
}



template <int dim>
double
ContactPath<dim>::shift(const double travel) const
{
  return resting_shift + piece.shared[0] + travel * piece.shared[1];
}



template <int dim>
double
ContactPath<dim>::cross_end()
{
  const double travel = end_of_piece;
  Assert(std::isfinite(travel), ExcInternalError());
  const double before = energy()(travel);
  if (!ending_condition)
    {
      // Where the front is straight all hats of a row do so together.
      update_facets(travel, -smallest_step, false);
      remake_conditions();
      settle(travel);
      return before - energy()(travel);
    }
  const unsigned int i = *ending_condition;
  piece.active[i].flip();
  take_piece(travel, piece.active);
  const double slope =
    piece.active[i] ? piece.multipliers.slope[i] : piece.gaps.slope[i];
  // Where many change at once they are found a little beyond.
  if (slope < 0 || end_of_piece < travel + smallest_step)
    {
      settle(travel + smallest_step);
      end_of_piece = std::max(end_of_piece, travel + smallest_step);
    }
  return 0;
}



template class ContactPath<2>;
template class ContactPath<3>;
} // namespace Setsudan
