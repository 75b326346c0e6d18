// SPDX-License-Identifier: LGPL-2.1-or-later
#include <setsudan/parameters/exceptions.h>
#include <setsudan/simulation/cut_contact.h>

#include <algorithm>
#include <map>
#include <sstream>

namespace Setsudan
{
using namespace dealii;

namespace
{
/** The depth of the shallowest row but the first. */
double
shortest_row(const std::vector<Row> &rows, const double whole)
{
  double shortest = whole;
  for (unsigned int row = 1; row < rows.size(); ++row)
    shortest = std::min(shortest, rows[row].depth - rows[row - 1].depth);
  return shortest;
}



/** A parameter of a path that is small: of the travel, beside a row; of the
 * load factor, beside the scene's loads. */
template <int dim>
double
small_step(const CutBody<dim> &body)
{
  return 1e-9 * (body.scene().blade.travels
                   ? shortest_row(body.seam().rows(), body.mesh().extent())
                   : std::max(1., body.scene().division.max_load_factor));
}



/** How many rows may be split while the blade presses. Under forces it is gone
 * behind the last one, which only an energy is asked for. */
template <int dim>
unsigned int
last_stage(const CutBody<dim> &body)
{
  const unsigned int n_rows = body.seam().rows().size();
  return body.scene().blade.travels || body.scene().yield.compares_energies()
           ? n_rows
           : n_rows - 1;
}



template <int dim>
TouchingBlade
touching_blade(const BladeParameters<dim> &blade, const BladeProfile &profile)
{
  return {blade.sliding,
          !profile.facets.empty(),
          blade.travels,
          blade.travels ? 0. : blade.thickness};
}



/** The scene's forces on the edge while the first rows are split, the same on
 * all processes. */
template <int dim>
UnknownForces
forces_on_edge(const CutBody<dim> &body, const unsigned int n_split)
{
  unsigned int row          = n_split;
  const unsigned int n_rows = body.seam().rows().size();
  while (row < n_rows && body.is_left_out(row))
    ++row;
  UnknownForces here, all;
  if (row == n_rows)
    return all;
  const auto blade = body.blade_on_row(row);
  for (const auto unknown : body.model().discretization.owned)
    if (blade.nodal_forces(unknown) != 0)
      here.emplace_back(unknown, blade.nodal_forces(unknown));
  for (const auto &of_process :
       Utilities::MPI::all_gather(body.communicator(), here))
    all.insert(all.end(), of_process.begin(), of_process.end());
  return all;
}
} // namespace


template <int dim>
CutContact<dim>::CutContact(CutBody<dim> &body, const BladeProfile &profile)
  : body(body)
  , profile(profile)
  , basis(body.model(),
          body.surface(),
          body.seam(),
          body.cut().edge,
          touching_blade(body.scene().blade, profile),
          body.earlier_cuts())
  // With all rows split, which says whether all that is cut is held.
  , solver(body.condensed_solver(last_stage(body)))
  , step(small_step(body))
{
  auto vectors = basis.vectors();
  for (unsigned int n = 0; n <= last_stage(body); ++n)
    {
      n_free.push_back(body.condensed_solver(n)->n_free());
      if (!body.scene().blade.travels)
        vectors.push_back(forces_on_edge(body, n));
    }
  compliance =
    solver->compliance(vectors, body.model().loads, body.model().lift);
  products.reinit(vectors.size() + 1);
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
  advance_products(n_free[n_split]);
  auto path = std::make_unique<ContactPath<dim>>(basis,
                                                 profile,
                                                 body.scene().blade.sliding,
                                                 n_split,
                                                 n_ahead,
                                                 products,
                                                 untouched(n_split),
                                                 step);
  path->begin(motion, neighbour);
  return path;
}



template <int dim>
UntouchedBody
CutContact<dim>::untouched(const unsigned int n_split) const
{
  const unsigned int n = basis.vectors().size(), loads = products.n() - 1;
  UntouchedBody result{{Vector<double>(n), Vector<double>(n)}, {}};
  const auto &in_lift = compliance.work_in_lift;
  result.energy.c[0]  = -products(loads, loads) / 2;
  for (unsigned int v = 0; v < n; ++v)
    result.displacements.constant[v] = products(v, loads) + in_lift[v];
  if (body.scene().blade.travels)
    return result;
  const unsigned int edge = n + n_split;
  for (unsigned int v = 0; v < n; ++v)
    result.displacements.slope[v] = products(v, edge);
  result.energy.c[1] = -products(loads, edge) - in_lift[edge];
  result.energy.c[2] = -products(edge, edge) / 2;
  return result;
}



template <int dim>
LA::Vector
CutContact<dim>::pressure(const ContactPath<dim> &path,
                          const double travel) const
{
  LA::Vector forces     = body.model().discretization.zero_vector();
  const auto of_vectors = path.forces(travel);
  for (unsigned int v = 0; v < of_vectors.size(); ++v)
    if (of_vectors[v] != 0)
      for (const auto &[unknown, factor] : basis.vectors()[v])
        if (body.model().discretization.owned.is_element(unknown))
          forces(unknown) += factor * of_vectors[v];
  forces.compress(VectorOperation::add);
  return forces;
}



template <int dim>
BladeLoad<dim>
CutContact<dim>::load(const ContactPath<dim> &path,
                      const unsigned int row,
                      const double travel) const
{
  if (!body.scene().blade.travels)
    {
      BladeLoad<dim> blade = row < body.seam().rows().size()
                               ? body.blade_on_row(row)
                               : no_blade(body.model());
      blade.pressure       = pressure(path, travel);
      blade.opening_force  = path.walls_force()(travel);
      return blade;
    }
  BladeLoad<dim> blade = no_blade(body.model());
  // Behind the last row the blade stays with it.
  blade.row = std::min<unsigned int>(row, body.seam().rows().size() - 1);
  std::map<types::global_dof_index, double> forces;
  const auto of_vectors = path.forces(travel);
  for (unsigned int v = 0; v < of_vectors.size(); ++v)
    if (of_vectors[v] != 0)
      for (const auto &[unknown, factor] : basis.vectors()[v])
        forces[unknown] += factor * of_vectors[v];
  for (const auto &[unknown, force] : forces)
    if (body.model().discretization.owned.is_element(unknown))
      blade.nodal_forces(unknown) = force;
  blade.nodal_forces.compress(VectorOperation::insert);
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
State<dim>
CutContact<dim>::solve(const ContactPath<dim> &path,
                       const unsigned int row,
                       const double travel,
                       const LA::Vector &guess) const
{
  const bool travels = body.scene().blade.travels;
  State<dim> state =
    solve_state(body, load(path, row, travel), travels ? 1 : travel, guess);
  if (!travels)
    check(path, state);
  return state;
}



template <int dim>
void
CutContact<dim>::check(const ContactPath<dim> &path,
                       const State<dim> &state) const
{
  std::vector<double> measured;
  for (const auto &vector : basis.vectors())
    {
      measured.push_back(0);
      for (const auto &[unknown, factor] : vector)
        if (body.model().discretization.owned.is_element(unknown))
          measured.back() += factor * state.displacement(unknown);
    }
  Utilities::MPI::sum(measured, body.communicator(), measured);
  const auto [missing, pull] = path.violation(measured, state.load_factor);
  const double largest       = state.displacement.linfty_norm();
  const double allowed =
    1e-10 * std::max(body.scene().blade.thickness, largest) +
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



template class CutContact<2>;
template class CutContact<3>;
} // namespace Setsudan
