// SPDX-License-Identifier: LGPL-2.1-or-later
#include <setsudan/contact/contact_path.h>

#include <algorithm>
#include <cmath>

// The body on a board.

namespace Setsudan
{
using namespace dealii;

namespace
{
/** The part of the foundation's stiffness that is taken out of solutions. What
 * stays is less than any number of the results tells, and holds pieces while
 * their contacts are looked for. */
constexpr double part_taken_out = 1 - 1e-9;
} // namespace


template <int dim>
void
ContactPath<dim>::begin_grips(const std::vector<double> &measured,
                              const std::vector<double> &earlier)
{
  constexpr unsigned int n_along = dim - 1;
  places_before.assign(grips.size(), {});
  for (unsigned int i = 0; i < grips.size(); ++i)
    for (unsigned int c = 0; c < n_along; ++c)
      {
        if (!measured.empty())
          places_before[i][c] =
            measured[basis.vector_of_board_corner(i, c + 1)];
        if (earlier.size() == 2 * n_along * grips.size())
          {
            grips[i].anchor[c] = earlier[2 * (n_along * i + c)];
            grips[i].slip[c]   = earlier[2 * (n_along * i + c) + 1];
          }
        else
          grips[i].anchor[c] = places_before[i][c];
      }
}



template <int dim>
typename ContactPath<dim>::Condition
ContactPath<dim>::board_condition(const unsigned int i) const
{
  const auto &board  = *basis.board();
  const auto &corner = board.corners()[i];
  const auto place   = [&](const unsigned int direction) {
    return place_of[basis.vector_of_board_corner(i, direction)];
  };
  Condition condition;
  condition.kind     = Kind::board;
  condition.place    = i;
  condition.measured = {{{place(0), 1.}, {place(0), 0.}, {place(0), 0.}}};
  condition.exerted  = condition.measured;
  for (unsigned int c = 0; c + 1 < dim; ++c)
    condition.exerted[c + 1] = {place(c + 1),
                                board.friction * grips[i].slip[c]};
  condition.constant = -corner.hat.area * corner.gap;
  condition.force    = corner.hat.area;
  condition.spring   = part_taken_out * corner.stiffness;
  return condition;
}



template <int dim>
typename ContactPath<dim>::Condition
ContactPath<dim>::grip_condition(const unsigned int i,
                                 const unsigned int direction) const
{
  const auto &board = *basis.board();
  const unsigned int place =
    place_of[basis.vector_of_board_corner(i, direction)];
  Condition condition;
  condition.kind      = Kind::grip;
  condition.place     = i;
  condition.direction = direction;
  condition.measured  = {{{place, 1.}, {place, 0.}, {place, 0.}}};
  condition.exerted   = condition.measured;
  condition.constant  = grips[i].anchor[direction - 1];
  condition.spring    = part_taken_out * board.corners()[i].stiffness;
  return condition;
}



template <int dim>
void
ContactPath<dim>::add_board_conditions()
{
  for (unsigned int i = 0; i < basis.n_board_corners(); ++i)
    {
      const auto moves = [&](const unsigned int direction) {
        const unsigned int place =
          place_of[basis.vector_of_board_corner(i, direction)];
        return products(place, place) > 0;
      };
      // A corner that is supported along the normal is no matter of the board.
      if (!moves(0))
        continue;
      conditions.push_back(board_condition(i));
      for (unsigned int direction = 1; direction < dim; ++direction)
        if (moves(direction))
          conditions.push_back(grip_condition(i, direction));
    }
}



template <int dim>
std::optional<Foundation>
ContactPath<dim>::make_foundation() const
{
  if (basis.n_board_corners() == 0)
    return {};
  Foundation foundation{Vector<double>(conditions.size()),
                        Vector<double>(conditions.size())};
  for (unsigned int i = 0; i < conditions.size(); ++i)
    if (conditions[i].spring > 0)
      {
        foundation.stiffness[i] = conditions[i].spring;
        foundation.closed[i]    = conditions[i].constant;
      }
  return foundation;
}



template <int dim>
std::vector<unsigned int>
ContactPath<dim>::make_leaders() const
{
  if (basis.n_board_corners() == 0 && !has_turned)
    return {};
  std::vector<unsigned int> leaders;
  unsigned int last_board = 0;
  for (unsigned int i = 0; i < conditions.size(); ++i)
    {
      if (conditions[i].kind == Kind::board)
        last_board = i;
      // A wall sticks while its flank, the condition before, touches.
      leaders.push_back(conditions[i].kind == Kind::grip    ? last_board
                        : conditions[i].kind == Kind::stick ? i - 1
                                                            : i);
    }
  return leaders;
}



template <int dim>
std::array<double, dim - 1>
ContactPath<dim>::place_on_board(const unsigned int corner,
                                 const double travel) const
{
  std::array<double, dim - 1> measured{};
  for (unsigned int c = 0; c + 1 < dim; ++c)
    {
      const unsigned int place =
        place_of[basis.vector_of_board_corner(corner, c + 1)];
      measured[c] = untouched.displacements(place, travel) +
                    moved_by_adhesion[place] +
                    piece.displacements(place, travel);
    }
  return measured;
}



template <int dim>
std::vector<std::array<double, dim - 1>>
ContactPath<dim>::places_on_board(const double travel) const
{
  std::vector<std::array<double, dim - 1>> places;
  for (unsigned int i = 0; i < basis.n_board_corners(); ++i)
    places.push_back(place_on_board(i, travel));
  return places;
}



template <int dim>
std::pair<unsigned int, unsigned int>
ContactPath<dim>::grips_of(const unsigned int board) const
{
  unsigned int end = board + 1;
  while (end < conditions.size() && conditions[end].kind == Kind::grip)
    ++end;
  return {board + 1, end};
}



template <int dim>
Quadratic
ContactPath<dim>::excess_friction(const unsigned int board) const
{
  Quadratic excess;
  const auto add_square = [&](const unsigned int i, const double factor) {
    const double m0 = piece.multipliers.constant[i];
    const double m1 = piece.multipliers.slope[i];
    excess.c[0] += factor * m0 * m0;
    excess.c[1] += 2 * factor * m0 * m1;
    excess.c[2] += factor * m1 * m1;
  };
  const double friction = basis.board()->friction;
  add_square(board, -friction * friction);
  const auto [begin, end] = grips_of(board);
  for (unsigned int i = begin; i < end; ++i)
    add_square(i, 1);
  return excess;
}



template <int dim>
bool
ContactPath<dim>::let_slip(const unsigned int board, const double travel)
{
  auto &grip              = grips[conditions[board].place];
  double sum              = 0;
  const auto [begin, end] = grips_of(board);
  for (unsigned int i = begin; i < end; ++i)
    {
      const double friction                  = piece.multipliers(i, travel);
      grip.slip[conditions[i].direction - 1] = friction;
      sum += friction * friction;
    }
  if (sum == 0)
    return false;
  for (unsigned int i = begin; i < end; ++i)
    piece.active[i] = false;
  for (double &component : grip.slip)
    component /= std::sqrt(sum);
  return true;
}



template <int dim>
void
ContactPath<dim>::let_stick(const unsigned int board,
                            const std::array<double, dim - 1> &place)
{
  grips[conditions[board].place] = {place, {}};
  const auto [begin, end]        = grips_of(board);
  for (unsigned int i = begin; i < end; ++i)
    piece.active[i] = true;
}



template <int dim>
bool
ContactPath<dim>::update_grip(const unsigned int board, const double travel)
{
  // Of the square of the friction.
  constexpr double tolerance = 1e-9;
  // The way on counts where there is none from before to now.
  const double step         = 1e3 * smallest_step;
  const unsigned int corner = conditions[board].place;
  const auto [begin, end]   = grips_of(board);
  auto &slip                = grips[corner].slip;
  const auto place          = place_on_board(corner, travel + heading * step);
  double forward = 0, way = 0;
  for (unsigned int c = 0; c + 1 < dim; ++c)
    {
      const double moved = place[c] - places_before[corner][c];
      forward += slip[c] * moved;
      way += moved * moved;
    }
  if (grips[corner].slips())
    {
      // Friction acts against the way.
      if (forward <= 0)
        return false;
      let_stick(board, places_before[corner]);
      return true;
    }
  if (piece.active[begin])
    {
      const double most =
        basis.board()->friction * piece.multipliers(board, travel);
      return excess_friction(board)(travel) > tolerance * most * most &&
             let_slip(board, travel);
    }
  // It has come to the board; if it would be torn off again where it sticks it
  // slips.
  if (n_changes[corner] == 0)
    let_stick(board, place_on_board(corner, travel));
  else
    for (unsigned int c = 0; c + 1 < dim; ++c)
      slip[c] =
        way > 0 ? (places_before[corner][c] - place[c]) / std::sqrt(way) : 0.;
  return n_changes[corner] == 0 || way > 0;
}



template <int dim>
bool
ContactPath<dim>::update_grips(const double travel)
{
  // Among many corners one may go to and fro.
  constexpr unsigned int most_changes = 4;
  bool any                            = false;
  if (basis.n_board_corners() == 0 || basis.board()->friction == 0)
    return any;
  for (unsigned int i = 0; i < conditions.size(); ++i)
    {
      const unsigned int corner = conditions[i].place;
      if (conditions[i].kind != Kind::board ||
          grips_of(i).first == grips_of(i).second)
        continue;
      // In the end it may slip, but no more than Coulomb's friction holds it.
      const bool sticks = piece.active[i] && piece.active[grips_of(i).first];
      if (n_changes[corner] >= most_changes && !sticks)
        continue;
      bool changes = false;
      if (piece.active[i])
        changes = update_grip(i, travel);
      else if (grips[corner].slips())
        {
          grips[corner].slip = {};
          changes            = true;
        }
      n_changes[corner] += changes;
      any = any || changes;
    }
  return any;
}



template <int dim>
void
ContactPath<dim>::end_at_slip(const double travel)
{
  slipping_condition.reset();
  if (basis.n_board_corners() == 0 || basis.board()->friction == 0)
    return;
  for (unsigned int i = 0; i < conditions.size(); ++i)
    {
      if (conditions[i].kind != Kind::board || !piece.active[i] ||
          grips_of(i).first == grips_of(i).second ||
          !piece.active[grips_of(i).first])
        continue;
      // Far beyond the last change there is none.
      const double end = std::isfinite(end_of_piece)
                           ? end_of_piece
                           : travel + heading * 1e9 * smallest_step;
      // Over the way, on which the travel may fall.
      Quadratic excess = excess_friction(i);
      excess.c[1] *= heading;
      const double way = heading * travel;
      // Right at it the way on decides.
      if (excess.c[1] + 2 * way * excess.c[2] <= 0 && excess(way) >= 0)
        continue;
      const auto root = excess.first_root(way, heading * end);
      // A corner that comes off has neither pressure nor friction there.
      if (root &&
          is_before(heading * *root + heading * smallest_step, end_of_piece))
        {
          end_of_piece       = heading * *root;
          slipping_condition = i;
          ending_condition.reset();
        }
    }
}



template <int dim>
double
ContactPath<dim>::board_dissipation(
  const Condition &condition,
  const std::array<double, dim - 1> &begin,
  const std::array<double, dim - 1> &end) const
{
  double work = 0;
  for (unsigned int c = 0; c + 1 < dim; ++c)
    work -= condition.exerted[c + 1].second * (end[c] - begin[c]);
  return work;
}



template <int dim>
void
ContactPath<dim>::add_board_friction_to(const ContactPath &after,
                                        Quadratic &work) const
{
  for (const ContactPath *path : {this, &after})
    for (unsigned int i = 0; i < path->conditions.size(); ++i)
      {
        const Condition &condition = path->conditions[i];
        if (!path->piece.active[i] || condition.kind != Kind::board)
          continue;
        const auto slip_at = [&](const double travel) {
          return board_dissipation(
            condition,
            place_on_board(condition.place, travel),
            after.place_on_board(condition.place, travel));
        };
        const double slip0 = slip_at(0);
        const double slip1 = slip_at(1) - slip0;
        const double m0    = path->piece.multipliers.constant[i] / 2;
        const double m1    = path->piece.multipliers.slope[i] / 2;
        work.c[0] += m0 * slip0;
        work.c[1] += m0 * slip1 + m1 * slip0;
        work.c[2] += m1 * slip1;
      }
}



template <int dim>
std::vector<double>
ContactPath<dim>::state_of_grips() const
{
  std::vector<double> state;
  for (const auto &grip : grips)
    for (unsigned int c = 0; c + 1 < dim; ++c)
      {
        state.push_back(grip.anchor[c]);
        state.push_back(grip.slip[c]);
      }
  return state;
}



template <int dim>
Quadratic
ContactPath<dim>::board_force() const
{
  return sum_over(Kind::board, &Condition::force);
}



#define INSTANTIATE(dim)                                                      \
  template void ContactPath<dim>::begin_grips(const std::vector<double> &,    \
                                              const std::vector<double> &);   \
  template void ContactPath<dim>::add_board_conditions();                     \
  template std::optional<Foundation> ContactPath<dim>::make_foundation()      \
    const;                                                                    \
  template std::vector<unsigned int> ContactPath<dim>::make_leaders() const;  \
  template std::array<double, dim - 1> ContactPath<dim>::place_on_board(      \
    const unsigned int, const double) const;                                  \
  template std::pair<unsigned int, unsigned int> ContactPath<dim>::grips_of(  \
    const unsigned int) const;                                                \
  template void ContactPath<dim>::let_stick(                                  \
    const unsigned int, const std::array<double, dim - 1> &);                 \
  template std::vector<std::array<double, dim - 1>>                           \
  ContactPath<dim>::places_on_board(const double) const;                      \
  template bool ContactPath<dim>::let_slip(const unsigned int, const double); \
  template bool ContactPath<dim>::update_grip(const unsigned int,             \
                                              const double);                  \
  template bool ContactPath<dim>::update_grips(const double);                 \
  template void ContactPath<dim>::end_at_slip(const double);                  \
  template double ContactPath<dim>::board_dissipation(                        \
    const Condition &,                                                        \
    const std::array<double, dim - 1> &,                                      \
    const std::array<double, dim - 1> &) const;                               \
  template void ContactPath<dim>::add_board_friction_to(const ContactPath &,  \
                                                        Quadratic &) const;   \
  template std::vector<double> ContactPath<dim>::state_of_grips() const;      \
  template Quadratic ContactPath<dim>::board_force() const;

INSTANTIATE(2)
INSTANTIATE(3)

#undef INSTANTIATE
} // namespace Setsudan
