// SPDX-License-Identifier: LGPL-2.1-or-later
#include <setsudan/solver/multigrid/constrained_stiffness.h>
#include <setsudan/space/reference_gradients.h>

#include <algorithm>

namespace Setsudan
{
using namespace dealii;

template <int dim>
ConstrainedStiffness<dim>::ConstrainedStiffness(
  const Discretization<dim> &discretization,
  const CellBatches<dim> &batches,
  const LocalConstraints &lines,
  std::shared_ptr<const Tangent> tangent)
  : batches(batches)
  , lines(lines)
  , tangent(std::move(tangent))
  , discretization(discretization)
  , displacement(batches.partitioner())
  , forces(batches.partitioner())
{
}



template <int dim>
types::global_dof_index
ConstrainedStiffness<dim>::m() const
{
  return discretization.dof_handler.n_dofs();
}



template <int dim>
double
ConstrainedStiffness<dim>::el(const types::global_dof_index,
                              const types::global_dof_index) const
{
  Assert(false, ExcMessage("The smoother has been given the diagonal."));
  return 0;
}



template <int dim>
void
ConstrainedStiffness<dim>::vmult(Vector &result, const Vector &vector) const
{
  const unsigned int n = vector.locally_owned_size();
  std::copy(vector.begin(), vector.begin() + n, displacement.begin());
  displacement.update_ghost_values();
  lines.distribute(displacement);
  forces = 0;
  batches.apply(displacement, forces, tangent.get());
  lines.condense(forces);
  displacement.zero_out_ghost_values();
  forces.compress(VectorOperation::add);
  std::copy(forces.begin(), forces.begin() + n, result.begin());
  for (const unsigned int place : lines.owned())
    result.local_element(place) = vector.local_element(place);
}



template <int dim>
void
ConstrainedStiffness<dim>::diagonal(Vector &result) const
{
  const auto &kernel   = batches.kernel;
  const auto gradients = reference_gradients(discretization.fe.base_element(0),
                                             discretization.n_gauss_points());
  const unsigned int n_nodes = batches.n_nodes();
  AlignedVector<double> of_batch(n_nodes * dim * kernel.n_lanes);
  forces               = 0;
  double *const values = forces.begin();
  for (unsigned int b = 0; b < batches.size(); ++b)
    {
      const CellBatch batch = batches.with_tangent(b, tangent.get());
      if (tangent || !batches.same_as_previous(b))
        kernel.integrate(
          batch, gradients.data(), n_nodes, true, of_batch.data());
      for (unsigned int node = 0; node < n_nodes; ++node)
        for (unsigned int lane = 0; lane < batch.n_cells; ++lane)
          for (unsigned int c = 0; c < dim; ++c)
            values[batch.nodes[node * kernel.n_lanes + lane] + c] +=
              of_batch[(node * dim + c) * kernel.n_lanes + lane];
    }
  lines.condense_diagonal(forces);
  forces.compress(VectorOperation::add);
  std::copy(forces.begin(),
            forces.begin() + forces.locally_owned_size(),
            result.begin());
  for (const unsigned int place : lines.owned())
    result.local_element(place) = 1;
}



template class ConstrainedStiffness<2>;
template class ConstrainedStiffness<3>;
} // namespace Setsudan
