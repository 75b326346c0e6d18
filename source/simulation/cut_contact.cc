// SPDX-License-Identifier: LGPL-2.1-or-later
#include <setsudan/simulation/cut_contact.h>

#include <algorithm>
#include <map>

namespace Setsudan
{
using namespace dealii;

namespace
{
template <int dim>
unsigned int
n_rows(const CutBody<dim> &body)
{
  return body.has_cut() ? body.seam().rows().size() : 0;
}

/** The depth of the shallowest row but the first. */
template <int dim>
double
shortest_row(const CutBody<dim> &body)
{
  double shortest = body.mesh().extent();
  if (!body.has_cut())
    return shortest;
  const auto &rows = body.seam().rows();
  for (unsigned int row = 1; row < rows.size(); ++row)
    shortest = std::min(shortest, rows[row].depth - rows[row - 1].depth);
  return shortest;
}
} // namespace


template <int dim>
ContactBasis<dim>
CutContact<dim>::make_basis(CutBody<dim> &body)
{
  if (!body.has_cut())
    return {body.communicator(), *body.board()};
  return {body.model(),
          body.surface(),
          body.seam(),
          body.cut().edge,
          body.scene().blade.sliding,
          body.earlier_cuts(),
          body.board()};
}



template <int dim>
CutContact<dim>::CutContact(CutBody<dim> &body,
                            const BladeProfile &profile,
                            const LA::Vector &displacement)
  : body(body)
  , profile(profile)
  , basis(make_basis(body))
  // With all rows split, which says whether all that is cut is held.
  , solver(body.condensed_solver(n_rows(body)))
  , step(1e-9 * shortest_row(body))
{
  for (unsigned int n = 0; n <= n_rows(body); ++n)
    n_free.push_back(body.condensed_solver(n)->n_free());
  compliance =
    solver->compliance(basis.vectors(), body.model().loads, body.model().lift);
  products.reinit(basis.vectors().size() + 1);
  if (!body.board())
    return;
  for (const auto &vector : basis.vectors())
    {
      measured.push_back(0);
      for (const auto &[unknown, factor] : vector)
        if (body.model().discretization.owned.is_element(unknown))
          measured.back() += factor * displacement(unknown);
    }
  Utilities::MPI::sum(measured, body.communicator(), measured);
}



template <int dim>
bool
CutContact<dim>::is_of(CutBody<dim> &now) const
{
  return solver == now.condensed_solver();
}



template <int dim>
void
CutContact<dim>::advance_products(const unsigned int n)
{
  if (n == n_summed)
    return;
  if (n < n_summed)
    {
      products = 0;
      n_summed = 0;
    }
  // Of one process, since round-off decides where contacts change.
  const MPI_Comm communicator = body.communicator();
  if (Utilities::MPI::this_mpi_process(communicator) == 0)
    compliance.add_products(n_summed, n, products);
  Utilities::MPI::broadcast(
    &products(0, 0), products.n_elements(), 0, communicator);
  n_summed = n;
}



template <int dim>
std::unique_ptr<ContactPath<dim>>
CutContact<dim>::path(const unsigned int n_split,
                      const unsigned int n_ahead,
                      const BladeMotion &motion,
                      const ContactPath<dim> *neighbour)
{
  return path(profile, n_split, n_ahead, motion, neighbour);
}



template <int dim>
std::unique_ptr<ContactPath<dim>>
CutContact<dim>::path_without_blade(const BladeMotion &motion,
                                    const ContactPath<dim> *neighbour)
{
  return path(no_profile, n_rows(body), 0, motion, neighbour);
}



template <int dim>
std::unique_ptr<ContactPath<dim>>
CutContact<dim>::path(const BladeProfile &of_blade,
                      const unsigned int n_split,
                      const unsigned int n_ahead,
                      const BladeMotion &motion,
                      const ContactPath<dim> *neighbour)
{
  advance_products(n_free[n_split]);
  auto path = std::make_unique<ContactPath<dim>>(basis,
                                                 of_blade,
                                                 body.scene().blade.sliding,
                                                 n_split,
                                                 n_ahead,
                                                 products,
                                                 compliance.work_in_lift,
                                                 step);
  path->begin(motion, neighbour, measured);
  return path;
}



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
BladeLoad<dim>
CutContact<dim>::blade_load(const ContactPath<dim> &path,
                            const unsigned int row,
                            const double travel) const
{
  BladeLoad<dim> blade = no_blade(body.model());
  if (!body.has_cut())
    return blade;
  // Behind the last row the blade stays with it.
  blade.row = std::min<unsigned int>(row, body.seam().rows().size() - 1);
  const auto forces =
    on_unknowns(path.forces(travel), 0, basis.vector_of_board_corner(0, 0));
  blade.nodal_forces = nodal_forces(forces);
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
                      path.board_force()(travel)};
  const auto &corners = body.board()->corners();
  for (unsigned int i = 0; i < corners.size(); ++i)
    {
      Tensor<1, dim> force;
      for (unsigned int d = 0; d < dim; ++d)
        force += forces[basis.vector_of_board_corner(i, d)] *
                 corners[i].hat.area * body.board()->directions()[d];
      if (force.norm() > 0)
        load.forces.push_back({corners[i].hat.center, force});
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
  return solve_state(
    body, blade_load(path, row, travel), 1, guess, board_load(path, travel));
}



template <int dim>
State<dim>
state_on_board(CutBody<dim> &body, const State<dim> &from)
{
  const BladeProfile no_blade;
  CutContact<dim> contact(body, no_blade, from.displacement);
  State<dim> state = contact.state(
    *contact.path_without_blade({}, nullptr), 0, 0, from.displacement);
  state.motion = from.motion;
  return state;
}



template class CutContact<2>;
template class CutContact<3>;
template State<2>
state_on_board(CutBody<2> &, const State<2> &);
template State<3>
state_on_board(CutBody<3> &, const State<3> &);
} // namespace Setsudan
