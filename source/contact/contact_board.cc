// SPDX-License-Identifier: LGPL-2.1-or-later
#include <setsudan/contact/contact_path.h>

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
ContactPath<dim>::begin_anchors(const std::vector<double> &measured,
                                const std::vector<double> &earlier)
{
  constexpr unsigned int n_along = dim - 1;
  for (unsigned int i = 0; i < anchors.size(); ++i)
    for (unsigned int c = 0; c < n_along; ++c)
      if (earlier.size() == n_along * anchors.size())
        anchors[i][c] = earlier[n_along * i + c];
      else if (!measured.empty())
        anchors[i][c] = measured[basis.vector_of_board_corner(i, c + 1)];
}



template <int dim>
typename ContactPath<dim>::Condition
ContactPath<dim>::board_condition(const unsigned int i) const
{
  const auto &board  = *basis.board();
  const auto &corner = board.corners()[i];
  const auto place   = [&](const unsigned int direction) {
    return stage->place_of[basis.vector_of_board_corner(i, direction)];
  };
  Condition condition;
  condition.kind     = Kind::board;
  condition.place    = i;
  condition.measured = {{{place(0), 1.}, {place(0), 0.}, {place(0), 0.}}};
  condition.exerted  = condition.measured;
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
    stage->place_of[basis.vector_of_board_corner(i, direction)];
  Condition condition;
  condition.kind      = Kind::grip;
  condition.place     = i;
  condition.direction = direction;
  condition.measured  = {{{place, 1.}, {place, 0.}, {place, 0.}}};
  condition.exerted   = condition.measured;
  condition.constant  = anchors[i][direction - 1];
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
          stage->place_of[basis.vector_of_board_corner(i, direction)];
        return stage->products(place, place) > 0;
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
  if (basis.n_board_corners() == 0 && !has_turned && !basis.edge_holds())
    return {};
  std::vector<unsigned int> leaders;
  unsigned int last_board = 0;
  for (unsigned int i = 0; i < conditions.size(); ++i)
    {
      if (conditions[i].kind == Kind::board)
        last_board = i;
      // A wall sticks while its flank, the condition before, touches; and so
      // does the edge hold.
      leaders.push_back(conditions[i].kind == Kind::grip ? last_board
                        : conditions[i].kind == Kind::stick ||
                            conditions[i].kind == Kind::hold
                          ? i - 1
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
        stage->place_of[basis.vector_of_board_corner(corner, c + 1)];
      measured[c] = stage->untouched.displacements(place, travel) +
                    moved_by_adhesion[place] +
                    piece.displacements(place, travel);
    }
  return measured;
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
bool
ContactPath<dim>::update_grips(const double travel)
{
  bool any = false;
  if (basis.n_board_corners() == 0 || basis.board()->friction == 0)
    return any;
  for (unsigned int i = 0; i < conditions.size(); ++i)
    {
      if (conditions[i].kind != Kind::board || !piece.active[i])
        continue;
      const unsigned int corner = conditions[i].place;
      const auto [begin, end]   = grips_of(i);
      if (begin == end || piece.active[begin] || has_stuck[corner])
        continue;
      anchors[corner] = place_on_board(corner, travel);
      for (unsigned int grip = begin; grip < end; ++grip)
        piece.active[grip] = true;
      has_stuck[corner] = true;
      any               = true;
    }
  return any;
}



template <int dim>
std::vector<double>
ContactPath<dim>::state_of_anchors() const
{
  std::vector<double> state;
  for (const auto &anchor : anchors)
    state.insert(state.end(), anchor.begin(), anchor.end());
  return state;
}



#define INSTANTIATE(dim)                                                      \
  template void ContactPath<dim>::begin_anchors(const std::vector<double> &,  \
                                                const std::vector<double> &); \
  template void ContactPath<dim>::add_board_conditions();                     \
  template std::optional<Foundation> ContactPath<dim>::make_foundation()      \
    const;                                                                    \
  template std::vector<unsigned int> ContactPath<dim>::make_leaders() const;  \
  template std::pair<unsigned int, unsigned int> ContactPath<dim>::grips_of(  \
    const unsigned int) const;                                                \
  template std::array<double, dim - 1> ContactPath<dim>::place_on_board(      \
    const unsigned int, const double) const;                                  \
  template bool ContactPath<dim>::update_grips(const double);                 \
  template std::vector<double> ContactPath<dim>::state_of_anchors() const;

INSTANTIATE(2)
INSTANTIATE(3)

#undef INSTANTIATE
} // namespace Setsudan
