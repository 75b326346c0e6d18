// SPDX-License-Identifier: LGPL-2.1-or-later
#include <deal.II/base/mpi.h>

#include <setsudan/mechanics/law_kernel.h>
#include <setsudan/space/reference_gradients.h>

namespace Setsudan
{
using namespace dealii;

template <int dim>
bool
has_law_kernel(const ElasticModel<dim> &model)
{
  // A process without cells knows none that it does not know.
  return model.materials.finite_strain &&
         model.discretization.type != ElementType::linear &&
         !model.load_parameters.has_pressure() &&
         Utilities::MPI::min<int>(model.batches().is_neo_hookean(),
                                  model.discretization.communicator) == 1;
}



template <int dim>
InternalForces
evaluate_by_kernel(const ElasticModel<dim> &model,
                   const LA::Vector &displacement)
{
  auto &batches = model.batches();
  auto u        = batches.copy_in(displacement);
  u.update_ghost_values();
  typename CellBatches<dim>::Vector f(batches.partitioner());
  InternalForces result;
  result.energy = Energy::elastic(Utilities::MPI::sum(
    batches.add_neo_hooke(u, f), model.discretization.communicator));
  f.compress(VectorOperation::add);
  result.forces = batches.copy_out(f);
  return result;
}



template <int dim>
std::shared_ptr<const typename CellBatches<dim>::Tangent>
tangent_by_kernel(const ElasticModel<dim> &model,
                  const Linearization &linearization)
{
  auto &batches = model.batches();
  auto u        = batches.copy_in(*linearization.about);
  u.update_ghost_values();
  if (linearization.before == nullptr)
    return batches.tangent(u, nullptr);
  auto before = batches.copy_in(*linearization.before);
  before.update_ghost_values();
  return batches.tangent(u, &before);
}



template <int dim>
TangentMatrices<dim>::TangentMatrices(
  const ElasticModel<dim> &model,
  std::shared_ptr<const Tangent> tangent_of_body)
  : batches(model.batches())
  , tangent(std::move(tangent_of_body))
  , gradients(reference_gradients<dim>(model.discretization.fe.base_element(0),
                                       model.discretization.n_gauss_points()))
{
  const auto &fe       = model.discretization.fe;
  const unsigned int n = fe.n_dofs_per_cell();
  for (unsigned int i = 0; i < n; ++i)
    {
      const auto [component, node] = fe.system_to_component_index(i);
      places.push_back(node * dim + component);
    }
  of_batch.resize(n * n * batches.kernel.n_lanes);
  matrix.reinit(n, n);
}



template <int dim>
const FullMatrix<double> &
TangentMatrices<dim>::operator()(const unsigned int cell)
{
  // All batches but the last one are full.
  const unsigned int n       = places.size();
  const unsigned int n_lanes = batches.kernel.n_lanes;
  const unsigned int lane    = cell % n_lanes;
  if (present_batch != cell / n_lanes)
    {
      present_batch = cell / n_lanes;
      batches.kernel.integrate(
        batches.with_tangent(present_batch, tangent.get()),
        gradients.data(),
        n / dim,
        false,
        of_batch.data());
    }
  for (unsigned int i = 0; i < n; ++i)
    for (unsigned int j = 0; j < n; ++j)
      matrix(i, j) = of_batch[(places[i] * n + places[j]) * n_lanes + lane];
  return matrix;
}



#define INSTANTIATE(dim)                                                       \
  template bool has_law_kernel(const ElasticModel<dim> &);                     \
  template InternalForces evaluate_by_kernel(const ElasticModel<dim> &,        \
                                             const LA::Vector &);              \
  template std::shared_ptr<const CellBatches<dim>::Tangent> tangent_by_kernel( \
    const ElasticModel<dim> &, const Linearization &);                         \
  template class TangentMatrices<dim>;

INSTANTIATE(2)
INSTANTIATE(3)

#undef INSTANTIATE
} // namespace Setsudan
