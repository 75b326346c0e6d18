// SPDX-License-Identifier: LGPL-2.1-or-later
#include <setsudan/contact/contact_path.h>
#include <setsudan/parameters/exceptions.h>
#include <setsudan/space/first_process.h>

#include <boost/serialization/utility.hpp>
#include <boost/serialization/vector.hpp>

#include <algorithm>
#include <cmath>
#include <string>

namespace Setsudan
{
using namespace dealii;

template <int dim>
ContactPath<dim>::ContactPath(std::unique_ptr<const ContactStage<dim>> own,
                              const BladeProfile &profile,
                              const SlidingBlade &sliding,
                              const double smallest_step)
  : stage(std::move(own))
  , basis(stage->basis)
  , profile(profile)
  , sliding(sliding)
  , smallest_step(smallest_step)
  , facets(2 * basis.hats().size(), 0)
  , slips(2 * basis.hats().size())
  , anchors(basis.n_board_corners())
{
}



template <int dim>
std::array<double, 2>
ContactPath<dim>::moved(
  const unsigned int h,
  const Wall wall,
  const typename ContactBasis<dim>::Component component) const
{
  const double area        = basis.hats()[h].area;
  const unsigned int place = stage->place_of_hat(h, wall, component);
  const auto &free         = stage->untouched.displacements;
  const auto &by_contact   = piece.displacements;
  return {{(free.constant[place] + moved_by_adhesion[place] +
            by_contact.constant[place]) /
             area,
           (free.slope[place] + by_contact.slope[place]) / area}};
}



template <int dim>
void
ContactPath<dim>::settle(const double travel)
{
  // A wall that goes back and forth between two facets stays on the second one.
  constexpr unsigned int most_back = 20;
  // Friction that is not settled all at once is one by one.
  constexpr unsigned int most_at_once = 30;
  const unsigned int most             = most_back + profile.facets.size() +
                            (has_turned ? most_at_once + 20 * slips.size() : 0);
  bool on_facets = false;
  has_stuck.assign(anchors.size(), false);
  for (unsigned int round = 0; round <= most; ++round)
    {
      take_piece(travel,
                 [&] { return problem->solution(travel, piece.active); });
      const auto flanks =
        update_facets(travel, 1e-2 * smallest_step, round < most_back);
      on_facets       = flanks.empty();
      const bool slip = on_facets && update_slips(travel, round > most_at_once);
      const bool grip = update_grips(travel), hold = update_holds();
      if (on_facets && !slip && !grip && !hold)
        return;
      if (slip || grip)
        remake_conditions();
      else if (!flanks.empty())
        take_facets(flanks);
    }
  if (on_facets)
    throw SolverError("At a travel of " + std::to_string(travel) +
                      " the walls of the cut neither stick to the blade nor "
                      "slip along it: with so much friction they spring to "
                      "another place. Lower Blade/Friction or Blade/Adhesion.");
  throw SolverError("The walls of the cut do not come to rest on the blade's "
                    "shoulder. Set Blade/Shoulder radius larger, or Blade/"
                    "Profile with more points.");
}



template <int dim>
void
ContactPath<dim>::take_piece(
  const double travel,
  const std::function<Complementarity::Piece()> &solution)
{
  auto [found, ends] = of_first_process(basis.communicator(), [&] {
    auto of_active = solution();
    std::vector<Complementarity::Breakpoint> end;
    if (const auto breakpoint = problem->end_of(of_active, travel, heading))
      end.push_back(*breakpoint);
    return std::make_pair(std::move(of_active), end);
  });
  piece              = std::move(found);
  energy_of_piece.reset();
  end_of_piece     = ends.empty()
                       ? heading * std::numeric_limits<double>::infinity()
                       : ends[0].p;
  ending_condition = ends.empty()
                       ? std::optional<unsigned int>()
                       : std::optional<unsigned int>(ends[0].condition);
  ending_slip.reset();
  find_end_of_facets(travel);
  find_end_of_sticking(travel);
}



template <int dim>
void
ContactPath<dim>::begin(const BladeMotion &motion,
                        const ContactPath *neighbour,
                        const std::vector<double> &measured)
{
  resting_shift = motion.shift;
  std::vector<bool> touched(facets.size(), false);
  if (neighbour != nullptr)
    {
      facets       = neighbour->facets;
      heading      = neighbour->heading;
      slips        = neighbour->slips;
      has_turned   = neighbour->has_turned;
      adhering     = neighbour->adhering;
      touched      = neighbour->touching();
      anchors      = neighbour->anchors;
      conditions   = neighbour->conditions;
      piece.active = neighbour->piece.active;
      remake_conditions();
    }
  else
    {
      const BladeContacts &earlier = motion.contacts;
      if (earlier.facets.size() == facets.size())
        {
          facets        = earlier.facets;
          resting_shift = earlier.resting_shift;
          heading       = earlier.heading;
          has_turned    = !earlier.slips.empty();
          if (has_turned)
            slips = earlier.slips;
          adhering = earlier.adhering;
        }
      begin_anchors(measured, earlier.board);
      make_conditions();
      if (earlier.active.size() == conditions.size())
        piece.active = earlier.active;
      else
        // The body lies on its board.
        for (const auto &condition : conditions)
          piece.active.push_back(
            condition.kind == Kind::board ||
            (condition.kind == Kind::grip && basis.board()->friction > 0));
    }
  settle(motion.travel);
  // Those of a path that is gone on with are known.
  if (adhering.empty() || neighbour != nullptr)
    update_adhesion(touched, motion.travel);
}



template <int dim>
double
ContactPath<dim>::head(const int way, const double travel)
{
  if (way == heading)
    return 0;
  const double before = energy()(travel);
  heading             = way;
  if (sliding.rubs())
    {
      has_turned = true;
      hold_walls(travel);
      remake_conditions();
    }
  settle(travel);
  return before - energy()(travel);
}



template <int dim>
double
ContactPath<dim>::shift(const double travel) const
{
  return resting_shift + piece.shared[0] + travel * piece.shared[1];
}



template <int dim>
void
ContactPath<dim>::change_condition(const unsigned int i,
                                   const double travel,
                                   const double beyond)
{
  problem->flip(piece.active, i);
  if (conditions[i].kind == Kind::board && piece.active[i] &&
      basis.board()->friction > 0)
    {
      update_grips(travel);
      remake_conditions();
    }
  take_piece(travel, [&] { return problem->piece(piece.active); });
  const double slope = heading * (piece.active[i] ? piece.multipliers.slope[i]
                                                  : piece.gaps.slope[i]);
  const bool others_slip = update_slips(travel, false);
  if (others_slip)
    remake_conditions();
  // Where many change at once they are found a little beyond.
  if (others_slip || slope < 0 || is_before(end_of_piece, beyond))
    {
      settle(beyond);
      if (is_before(end_of_piece, beyond))
        end_of_piece = beyond;
    }
  else if (update_grips(travel))
    {
      remake_conditions();
      settle(travel);
    }
}



template <int dim>
double
ContactPath<dim>::cross_end()
{
  const double travel = end_of_piece;
  Assert(std::isfinite(travel), ExcInternalError());
  const double before = energy()(travel);
  const double beyond = travel + heading * smallest_step;
  const auto touched  = sliding.adhesion > 0 ? touching() : std::vector<bool>();
  has_stuck.assign(anchors.size(), false);
  if (ending_condition)
    change_condition(*ending_condition, travel, beyond);
  else
    {
      const bool slips_now = ending_slip.has_value();
      if (slips_now)
        {
          const auto &flank = conditions[ending_slip->first];
          slips[place_of_wall(flank.place, flank.wall)].way =
            ending_slip->second;
          remake_conditions();
        }
      else
        // Where the front is straight all hats of a row do so together.
        take_facets(update_facets(travel, -smallest_step, false));
      settle(travel);
      if (slips_now && is_before(end_of_piece, beyond))
        end_of_piece = beyond;
    }
  update_adhesion(touched, beyond);
  // With friction the contacts may spring from one equilibrium to another.
  return before - energy()(travel);
}



template class ContactPath<2>;
template class ContactPath<3>;
} // namespace Setsudan
