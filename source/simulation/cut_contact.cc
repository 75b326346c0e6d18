// SPDX-License-Identifier: LGPL-2.1-or-later
#include <setsudan/simulation/cut_contact.h>

#include <algorithm>
#include <map>

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
} // namespace


template <int dim>
CutContact<dim>::CutContact(CutBody<dim> &body, const BladeProfile &profile)
  : body(body)
  , profile(profile)
  , basis(body.model(),
          body.surface(),
          body.seam(),
          body.cut().edge,
          body.scene().blade.sliding,
          body.earlier_cuts())
  // With all rows split, which says whether all that is cut is held.
  , solver(body.condensed_solver(body.seam().rows().size()))
  , step(1e-9 * shortest_row(body.seam().rows(), body.mesh().extent()))
{
  for (unsigned int n = 0; n <= body.seam().rows().size(); ++n)
    n_free.push_back(body.condensed_solver(n)->n_free());
  compliance =
    solver->compliance(basis.vectors(), body.model().loads, body.model().lift);
  products.reinit(basis.vectors().size() + 1);
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
                                                 compliance.work_in_lift,
                                                 step);
  path->begin(motion, neighbour);
  return path;
}



template <int dim>
BladeLoad<dim>
CutContact<dim>::load(const ContactPath<dim> &path,
                      const unsigned int row,
                      const double travel) const
{
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



template class CutContact<2>;
template class CutContact<3>;
} // namespace Setsudan
