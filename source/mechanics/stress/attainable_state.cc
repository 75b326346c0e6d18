// SPDX-License-Identifier: LGPL-2.1-or-later
#include <deal.II/base/mpi.h>

#include <setsudan/mechanics/stress/deformation_extremes.h>
#include <setsudan/mechanics/stress/stress_evaluator.h>

#include <vector>

// Whether a body can come from one state to another.

namespace Setsudan
{
using namespace dealii;

namespace
{
/** By the minors: deal.II's eigenvalues fail where two are the same up to
 * round-off. */
template <int dim>
bool
is_positive_definite(const SymmetricTensor<2, dim> &tensor)
{
  const double minor =
    tensor[0][0] * tensor[1][1] - tensor[0][1] * tensor[0][1];
  return tensor[0][0] > 0 && minor > 0 && determinant(tensor) > 0;
}



/** Whether the rotation of a deformation gradient is one by a right angle or
 * more. A shear, however large, has none of these. */
template <int dim>
bool
turns_by_right_angle(const Tensor<2, dim> &F)
{
  // Where no line turns that far the rotation does not either.
  return !is_positive_definite<dim>(symmetrize(F)) &&
         trace(project_onto_orthogonal_tensors(F)) <= dim - 2;
}
} // namespace


template <int dim>
bool
turns_over(const ElasticModel<dim> &model,
           const LA::Vector &from,
           const LA::Vector &to)
{
  const auto &discretization = model.discretization;
  const LA::Vector before    = discretization.with_ghosts(from);
  const LA::Vector behind    = discretization.with_ghosts(to);
  StressEvaluator<dim> at_nodes(
    discretization, model.materials, node_points(discretization));
  std::vector<Tensor<2, dim>> gradients(at_nodes.n_points());
  const Tensor<2, dim> one = unit_symmetric_tensor<dim>();
  bool found               = false;
  for (const auto &cell : discretization.dof_handler.active_cell_iterators())
    if (!found && cell->is_locally_owned())
      {
        at_nodes.reinit(cell, before);
        for (unsigned int p = 0; p < gradients.size(); ++p)
          gradients[p] = at_nodes.gradient(p);
        at_nodes.reinit(cell, behind);
        for (unsigned int p = 0; p < gradients.size(); ++p)
          found =
            found || turns_by_right_angle<dim>((one + at_nodes.gradient(p)) *
                                               invert(one + gradients[p]));
      }
  return Utilities::MPI::logical_or(found, discretization.communicator);
}



template <int dim>
bool
is_attainable(const ElasticModel<dim> &model,
              const LA::Vector &from,
              const LA::Vector &to)
{
  // Small strain knows no volume that it cannot go through.
  return !model.materials.finite_strain ||
         (find_smallest_volume(model, to).ratio > 0 &&
          !turns_over(model, from, to));
}



template bool
is_attainable(const ElasticModel<2> &, const LA::Vector &, const LA::Vector &);
template bool
is_attainable(const ElasticModel<3> &, const LA::Vector &, const LA::Vector &);
template bool
turns_over(const ElasticModel<2> &, const LA::Vector &, const LA::Vector &);
template bool
turns_over(const ElasticModel<3> &, const LA::Vector &, const LA::Vector &);
} // namespace Setsudan
