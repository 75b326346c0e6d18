// SPDX-License-Identifier: LGPL-2.1-or-later
#include <deal.II/base/mpi.h>

#include <setsudan/solver/multigrid/coarse_correction.h>

#include <cmath>

namespace Setsudan
{
using namespace dealii;

template <int dim>
CoarseCorrection<dim>::CoarseCorrection(
  const ElasticModel<dim> &model,
  const AffineConstraints<double> &constraints,
  const LocalConstraints &lines,
  std::shared_ptr<const typename CellBatches<dim>::Tangent> tangent)
  : space(model, constraints, lines)
  , stiffness(space.stiffness(std::move(tangent)).matrix())
  , coarse_forces(space.partitioner())
  , correction(space.partitioner())
{
  solver.initialize(*stiffness, space.rigid_modes());
}



template <int dim>
bool
CoarseCorrection<dim>::is_compatible_with(const LocalConstraints &others,
                                          const CellBatches<dim> &batches) const
{
  const auto [begin, end] = space.partitioner()->local_range();
  for (auto number = begin; number < end; ++number)
    correction.local_element(number - begin) = std::sin(1. + 7. * number);
  Vector displacement(batches.partitioner());
  space.prolongate_and_add(displacement, correction, nullptr);
  displacement.update_ghost_values();
  Vector obeying(displacement);
  obeying.update_ghost_values();
  others.distribute(obeying);
  double difference = 0;
  for (unsigned int at = 0; at < displacement.locally_owned_size(); ++at)
    difference = std::max(
      difference,
      std::abs(obeying.local_element(at) - displacement.local_element(at)));
  return Utilities::MPI::max(
           difference, batches.partitioner()->get_mpi_communicator()) < 1e-10;
}



template <int dim>
void
CoarseCorrection<dim>::add(Vector &displacement,
                           const Vector &forces,
                           const LocalConstraints &now) const
{
  space.restrict_forces(coarse_forces, forces);
  solver.vmult(correction, coarse_forces);
  space.prolongate_and_add(displacement, correction, &now);
}



template class CoarseCorrection<2>;
template class CoarseCorrection<3>;
} // namespace Setsudan
