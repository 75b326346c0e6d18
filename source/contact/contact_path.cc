// SPDX-License-Identifier: LGPL-2.1-or-later
#include <setsudan/contact/contact_path.h>
#include <setsudan/parameters/exceptions.h>
#include <setsudan/space/first_process.h>

#include <boost/serialization/utility.hpp>
#include <boost/serialization/vector.hpp>

#include <algorithm>
#include <cmath>

namespace Setsudan
{
using namespace dealii;

template <int dim>
ContactPath<dim>::ContactPath(const ContactBasis<dim> &basis,
                              const BladeProfile &profile,
                              const SlidingBlade &sliding,
                              const unsigned int row,
                              const unsigned int n_ahead,
                              const LAPACKFullMatrix<double> &all_products,
                              const UntouchedBody &without_contact,
                              const double smallest_step)
  : basis(basis)
  , profile(profile)
  , sliding(sliding)
  , row(row)
  , place_of(basis.vectors().size(), numbers::invalid_unsigned_int)
  , smallest_step(smallest_step)
  , facets(2 * basis.hats().size(), 0)
  , grips(basis.n_board_corners())
{
  const auto use = [&](const unsigned int vector) {
    place_of[vector] = vector_at.size();
    vector_at.push_back(vector);
  };
  for (unsigned int h = 0; h < basis.hats().size(); ++h)
    if (basis.hats()[h].row < row + n_ahead)
      for (unsigned int i = 0; i < basis.n_vectors_of_hat(); ++i)
        use(basis.first_vector_of_hat(h) + i);
  for (unsigned int n = 0; n < basis.edge_nodes().size(); ++n)
    if (basis.edge_nodes()[n].row == row)
      use(basis.vector_of_edge_node(n));
  for (unsigned int i = 0; i < basis.n_earlier_corners(); ++i)
    use(basis.first_vector_of_earlier_corners() + i);
  for (unsigned int i = 0; i < dim * basis.n_board_corners(); ++i)
    use(basis.vector_of_board_corner(0, 0) + i);
  const unsigned int n = vector_at.size();
  products.reinit(n);
  untouched = {{Vector<double>(n), Vector<double>(n)}, without_contact.energy};
  auto &[constant, slope] = untouched.displacements;
  for (unsigned int j = 0; j < n; ++j)
    {
      for (unsigned int i = 0; i < n; ++i)
        products(i, j) = all_products(vector_at[i], vector_at[j]);
      constant[j] = without_contact.displacements.constant[vector_at[j]];
      slope[j]    = without_contact.displacements.slope[vector_at[j]];
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
  const unsigned int place = place_of_hat(h, wall, component);
  const auto &free         = untouched.displacements;
  const auto &by_contact   = piece.displacements;
  return {{(free.constant[place] + by_contact.constant[place]) / area,
           (free.slope[place] + by_contact.slope[place]) / area}};
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
      take_piece(travel,
                 [&] { return problem->solution(travel, piece.active); });
      const bool moves =
        update_facets(travel, 1e-2 * smallest_step, round < most_back);
      const bool slips = update_grips(travel, round == 0);
      if (!moves && !slips)
        return;
      remake_conditions();
    }
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
  const auto [found, ends] = of_first_process(basis.communicator(), [&] {
    const auto of_active = solution();
    std::vector<Complementarity::Breakpoint> end;
    if (const auto breakpoint = problem->end_of(of_active, travel))
      end.push_back(*breakpoint);
    return std::make_pair(of_active, end);
  });
  piece                    = found;
  end_of_piece =
    ends.empty() ? std::numeric_limits<double>::infinity() : ends[0].p;
  ending_condition = ends.empty()
                       ? std::optional<unsigned int>()
                       : std::optional<unsigned int>(ends[0].condition);
  end_at_slip(travel);
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
          slipping_condition.reset();
        }
    }
}



template <int dim>
void
ContactPath<dim>::begin(const BladeMotion &motion,
                        const ContactPath *neighbour,
                        const std::vector<double> &measured)
{
  resting_shift = motion.shift;
  if (neighbour != nullptr)
    {
      facets       = neighbour->facets;
      grips        = neighbour->grips;
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
        }
      begin_grips(measured, earlier.board);
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
  if (slipping_condition)
    {
      let_slip(*slipping_condition, travel);
      remake_conditions();
      settle(travel);
      return before - energy()(travel);
    }
  if (!ending_condition)
    {
      // Where the front is straight all hats of a row do so together.
      update_facets(travel, -smallest_step, false);
      remake_conditions();
      settle(travel);
      return before - energy()(travel);
    }
  const unsigned int i = *ending_condition;
  problem->flip(piece.active, i);
  if (conditions[i].kind == Kind::board && piece.active[i] &&
      basis.board()->friction > 0)
    {
      let_stick(i, travel);
      remake_conditions();
    }
  take_piece(travel, [&] { return problem->piece(piece.active); });
  const double slope =
    piece.active[i] ? piece.multipliers.slope[i] : piece.gaps.slope[i];
  // Where many change at once they are found a little beyond.
  if (slope < 0 || end_of_piece < travel + smallest_step)
    {
      settle(travel + smallest_step);
      end_of_piece = std::max(end_of_piece, travel + smallest_step);
    }
  else if (update_grips(travel, true))
    {
      remake_conditions();
      settle(travel);
    }
  // With friction the contacts may spring from one equilibrium to another.
  return before - energy()(travel);
}



template class ContactPath<2>;
template class ContactPath<3>;
} // namespace Setsudan
