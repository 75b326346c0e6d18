// SPDX-License-Identifier: LGPL-2.1-or-later
#include <setsudan/parameters/exceptions.h>
#include <setsudan/simulation/cut_contact.h>

#include <algorithm>
#include <map>
#include <sstream>

// The forces of contact on the body, and its state under them.

namespace Setsudan
{
using namespace dealii;

template <int dim>
std::map<types::global_dof_index, double>
CutContact<dim>::on_unknowns(const std::vector<double> &forces,
                             const unsigned int begin,
                             const unsigned int end) const
{
  std::map<types::global_dof_index, double> of_unknowns;
  for (unsigned int v = begin; v < end; ++v)
    if (forces[v] != 0)
      for (const auto &[unknown, factor] : basis.vectors()[v])
        of_unknowns[unknown] += factor * forces[v];
  return of_unknowns;
}



template <int dim>
LA::Vector
CutContact<dim>::nodal_forces(
  const std::map<types::global_dof_index, double> &forces) const
{
  LA::Vector vector = body.model().discretization.zero_vector();
  for (const auto &[unknown, force] : forces)
    if (body.model().discretization.owned.is_element(unknown))
      vector(unknown) = force;
  vector.compress(VectorOperation::insert);
  return vector;
}



template <int dim>
void
CutContact<dim>::add_outer_forces(std::vector<double> &of_vectors,
                                  BladeLoad<dim> &blade) const
{
  for (unsigned int h = 0; h < basis.hats().size(); ++h)
    {
      const auto &outer = basis.hats()[h].outer;
      if (!outer)
        continue;
      Tensor<1, dim> force;
      for (unsigned int v = basis.first_vector_of_hat(h);
           v < basis.first_vector_of_hat(h + 1);
           ++v)
        {
          // Components follow each other in all vectors.
          for (unsigned int i = 0; i < basis.vectors()[v].size(); ++i)
            force[i % dim] += basis.vectors()[v][i].second * of_vectors[v];
          of_vectors[v] = 0;
        }
      if (force.norm() > 0)
        blade.forces.push_back({outer->hat.center, force});
    }
}



template <int dim>
BladeLoad<dim>
CutContact<dim>::blade_load(const ContactPath<dim> &path,
                            const unsigned int row,
                            const double travel) const
{
  BladeLoad<dim> blade = no_blade(body.model());
  if (!body.has_cut())
    return blade;
  // Behind the last row the blade stays with it.
  blade.row       = std::min<unsigned int>(row, body.seam().rows().size() - 1);
  auto of_vectors = path.forces(travel);
  blade.nodal_forces = nodal_forces(
    on_unknowns(of_vectors, 0, basis.vector_of_board_corner(0, 0)));
  add_outer_forces(of_vectors, blade);
  const auto forces =
    on_unknowns(of_vectors, 0, basis.vector_of_board_corner(0, 0));
  for (const auto &pair : body.seam().pairs())
    for (const auto *side : {&pair.minus, &pair.plus})
      {
        Tensor<1, dim> force;
        for (unsigned int c = 0; c < dim; ++c)
          if (const auto found = forces.find((*side)[c]); found != forces.end())
            force[c] = found->second;
        if (force.norm() > 0 && (side == &pair.minus || pair.is_double()))
          blade.forces.push_back({pair.position, force});
      }
  return blade;
}



template <int dim>
std::optional<BoardLoad<dim>>
CutContact<dim>::board_load(const ContactPath<dim> &path,
                            const double travel) const
{
  if (!body.board())
    return {};
  const auto of_board = [&](const std::vector<double> &forces) {
    return nodal_forces(on_unknowns(
      forces, basis.vector_of_board_corner(0, 0), basis.vectors().size()));
  };
  const auto forces = path.forces(travel);
  BoardLoad<dim> load{of_board(forces),
                      of_board(path.foundation_forces(travel)),
                      {},
                      path.resultants().board(travel)};
  std::map<unsigned int, Tensor<1, dim>> of_piece;
  const auto &corners = body.board()->corners();
  for (unsigned int i = 0; i < corners.size(); ++i)
    {
      Tensor<1, dim> force;
      for (unsigned int d = 0; d < dim; ++d)
        force += forces[basis.vector_of_board_corner(i, d)] *
                 corners[i].hat.area * body.board()->directions()[d];
      if (force.norm() > 0)
        load.forces.push_back({corners[i].hat.center, force});
      of_piece[body.labels().piece[corners[i].hat.element]] += force;
    }
  const auto &normal = body.board()->directions()[0];
  for (const auto &[piece, force] : of_piece)
    {
      const double pressure = force * normal;
      const double friction = (force - pressure * normal).norm();
      const double part =
        friction > 0 ? friction / (body.board()->friction * pressure) : 0.;
      if (part > load.part_of_friction)
        {
          load.sliding_piece    = piece;
          load.part_of_friction = part;
        }
    }
  return load;
}



template <int dim>
State<dim>
CutContact<dim>::state(const ContactPath<dim> &path,
                       const unsigned int row,
                       const double travel,
                       const LA::Vector &guess) const
{
  if (!has_forces())
    {
      State<dim> state = solve_state(body,
                                     blade_load(path, row, travel),
                                     1,
                                     guess,
                                     board_load(path, travel));
      if (state.board)
        state.board->passed = depth_beyond_board(
          body.model(), body.scene().board, state.displacement);
      return state;
    }
  const State<dim> state =
    solve_state(body, pressing_blade(path, row, travel), travel, guess);
  check(path, state);
  return state;
}



template <int dim>
BladeLoad<dim>
CutContact<dim>::pressing_blade(const ContactPath<dim> &path,
                                const unsigned int row,
                                const double load_factor) const
{
  BladeLoad<dim> blade =
    row < n_rows(body) ? body.blade_on_row(row) : no_blade(body.model());
  blade.pressure = nodal_forces(
    on_unknowns(path.forces(load_factor), 0, basis.vectors().size()));
  // Behind the last row it is gone.
  if (blade.row)
    blade.opening_force = path.resultants().walls(load_factor);
  return blade;
}



template <int dim>
void
CutContact<dim>::check(const ContactPath<dim> &path,
                       const State<dim> &state) const
{
  const auto [missing, pull] = path.violation(
    work_of(basis.vectors(), state.displacement), state.load_factor);
  const double largest = state.displacement.linfty_norm();
  const double allowed = 1e-10 * std::max(profile.keeps_apart, largest) +
                         10 * state.quality.estimated_relative_error * largest;
  if (missing <= allowed && pull <= 1e-10)
    return;
  std::ostringstream message;
  message << "The contact of the walls with the blade does not hold: they come "
             "nearer to each other than they may, by "
          << missing << ", which must not exceed " << allowed
          << ", or are pulled by " << pull
          << " of the largest pressure. The solution is not to be trusted.";
  throw InvariantError(message.str());
}



#define INSTANTIATE(dim)                                                   \
  template std::map<types::global_dof_index, double>                       \
  CutContact<dim>::on_unknowns(                                            \
    const std::vector<double> &, const unsigned int, const unsigned int)   \
    const;                                                                 \
  template LA::Vector CutContact<dim>::nodal_forces(                       \
    const std::map<types::global_dof_index, double> &) const;              \
  template void CutContact<dim>::add_outer_forces(std::vector<double> &,   \
                                                  BladeLoad<dim> &) const; \
  template BladeLoad<dim> CutContact<dim>::blade_load(                     \
    const ContactPath<dim> &, const unsigned int, const double) const;     \
  template std::optional<BoardLoad<dim>> CutContact<dim>::board_load(      \
    const ContactPath<dim> &, const double) const;                         \
  template State<dim> CutContact<dim>::state(const ContactPath<dim> &,     \
                                             const unsigned int,           \
                                             const double,                 \
                                             const LA::Vector &) const;    \
  template BladeLoad<dim> CutContact<dim>::pressing_blade(                 \
    const ContactPath<dim> &, const unsigned int, const double) const;     \
  template void CutContact<dim>::check(const ContactPath<dim> &,           \
                                       const State<dim> &) const;

INSTANTIATE(2)
INSTANTIATE(3)

#undef INSTANTIATE
} // namespace Setsudan
