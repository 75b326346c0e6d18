// SPDX-License-Identifier: LGPL-2.1-or-later
#include <deal.II/base/mpi.h>

#include <setsudan/solver/assembled_solver.h>
#include <setsudan/solver/softest_mode.h>

#include <boost/serialization/utility.hpp>

#include <cmath>
#include <utility>

namespace Setsudan
{
using namespace dealii;

template <int dim>
SoftestMode<dim>
softest_mode(const ElasticModel<dim> &model,
             const AffineConstraints<double> &constraints,
             const SolverParameters &parameters,
             const LA::Vector &displacement)
{
  constexpr unsigned int n_iterations = 30;
  const auto &discretization          = model.discretization;
  LA::Vector mode                     = discretization.zero_vector();
  // It has something of every eigenvector.
  for (const auto index : discretization.owned)
    mode(index) = 1 + std::sin(1. + index);
  mode.compress(VectorOperation::insert);
  AssembledSolver<dim> inverse(
    model, constraints, parameters, SolverKind::indefinite);
  inverse.linearize({&displacement});
  SolveQuality quality;
  for (unsigned int i = 0; i < n_iterations; ++i)
    {
      mode = inverse.increment(mode, mode, quality);
      mode /= mode.l2_norm();
    }
  std::pair<double, std::pair<Point<dim>, Tensor<1, dim>>> largest;
  const auto &locations = discretization.dof_locations();
  unsigned int local    = 0;
  Tensor<1, dim> of_node;
  for (const auto index : discretization.owned)
    {
      const auto &[position, component] = locations[local++];
      of_node[component]                = mode(index);
      // The components of a node follow each other.
      if (component == dim - 1 && of_node.norm() > largest.first)
        largest = {of_node.norm(), {position, of_node / of_node.norm()}};
    }
  for (const auto &other :
       Utilities::MPI::all_gather(discretization.communicator, largest))
    if (other.first > largest.first)
      largest = other;
  return {largest.second.first, largest.second.second};
}



template SoftestMode<2>
softest_mode(const ElasticModel<2> &,
             const AffineConstraints<double> &,
             const SolverParameters &,
             const LA::Vector &);
template SoftestMode<3>
softest_mode(const ElasticModel<3> &,
             const AffineConstraints<double> &,
             const SolverParameters &,
             const LA::Vector &);
} // namespace Setsudan
