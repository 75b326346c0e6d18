// SPDX-License-Identifier: LGPL-2.1-or-later
#include <deal.II/base/mpi.h>

#include <setsudan/mechanics/balance.h>

#include <optional>

namespace Setsudan
{
using namespace dealii;

template <int dim>
BodyBalance<dim>
check_balance(const ElasticModel<dim> &model,
              const LA::Vector &internal,
              const LA::Vector &applied,
              const std::vector<PointForce<dim>> &blade,
              const double wedge,
              const LA::Vector *displacement)
{
  const auto &discretization  = model.discretization;
  const MPI_Comm communicator = discretization.communicator;
  LA::Vector held             = internal;
  held -= applied;
  held = condense(model.hanging, held);
  std::optional<LA::Vector> moved;
  if (displacement != nullptr)
    {
      moved = applied;
      *moved += follower_forces(model, *displacement);
    }

  Resultant<dim> resultant(discretization);
  BodyBalance<dim> balance;
  const auto &dof_locations = discretization.dof_locations();
  unsigned int local        = 0;
  for (const auto index : discretization.owned)
    {
      auto [position, component] = dof_locations[local++];
      Tensor<1, dim> force;
      force[component] = moved ? (*moved)(index) : model.loads(index);
      // The components of a node follow each other.
      if (moved)
        for (unsigned int c = 0; c < dim; ++c)
          position[c] += (*displacement)(index - component + c);
      if (model.supported.is_element(index))
        {
          force[component] += held(index);
          (model.lift(index) == 0 ? balance.reaction
                                  : balance.clamp_force)[component] +=
            held(index);
        }
      if (force[component] != 0)
        resultant.add(position, force);
    }
  if (!moved && Utilities::MPI::this_mpi_process(communicator) == 0)
    for (const auto &[point, force] : blade)
      resultant.add(point, force);
  resultant.add_cancelling(wedge);
  resultant.sum_over_processes();
  static_cast<Balance &>(balance) = resultant.relative();
  balance.reaction    = Utilities::MPI::sum(balance.reaction, communicator);
  balance.clamp_force = Utilities::MPI::sum(balance.clamp_force, communicator);
  return balance;
}



template BodyBalance<2>
check_balance(const ElasticModel<2> &,
              const LA::Vector &,
              const LA::Vector &,
              const std::vector<PointForce<2>> &,
              const double,
              const LA::Vector *);
template BodyBalance<3>
check_balance(const ElasticModel<3> &,
              const LA::Vector &,
              const LA::Vector &,
              const std::vector<PointForce<3>> &,
              const double,
              const LA::Vector *);
} // namespace Setsudan
