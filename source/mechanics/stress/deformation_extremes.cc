// SPDX-License-Identifier: LGPL-2.1-or-later
#include <deal.II/base/mpi.h>

#include <setsudan/mechanics/cell_batches.h>
#include <setsudan/mechanics/strain_and_stress.h>
#include <setsudan/mechanics/stress/deformation_extremes.h>
#include <setsudan/mechanics/stress/grid_gradients.h>
#include <setsudan/mechanics/stress/stress_evaluator.h>

#include <boost/serialization/utility.hpp>

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>

namespace Setsudan
{
using namespace dealii;

namespace
{
/** The extremes of all processes. */
DeformationExtremes
of_all(const DeformationExtremes &own, const MPI_Comm communicator)
{
  DeformationExtremes all;
  all.min_jacobian = Utilities::MPI::min(own.min_jacobian, communicator);
  all.max_strain   = Utilities::MPI::max(own.max_strain, communicator);
  all.max_shear    = Utilities::MPI::max(own.max_shear, communicator);
  all.max_displacement =
    Utilities::MPI::max(own.max_displacement, communicator);
  return all;
}
} // namespace


namespace
{
/** Lower `min_jacobian` to the smallest determinant on the cell. */
template <int dim>
void
find_min_jacobian(const StressEvaluator<dim> &recovery, double &min_jacobian)
{
  for (unsigned int p = 0; p < recovery.n_points(); ++p)
    min_jacobian = std::min(
      min_jacobian,
      determinant(unit_symmetric_tensor<dim>() + recovery.gradient(p)));
}
} // namespace


template <int dim>
DeformationExtremes
find_extremes(const Discretization<dim> &discretization,
              const MaterialParameters<dim> &materials,
              const LA::Vector &displacement,
              const InternalVariables<dim> *internal)
{
  StressEvaluator<dim> at_nodes(
    discretization, materials, node_points(discretization));
  StressEvaluator<dim> at_gauss_points(
    discretization, materials, gauss_points(discretization), internal);
  DeformationExtremes extremes;
  for (const auto &cell : discretization.dof_handler.active_cell_iterators())
    if (cell->is_locally_owned())
      {
        at_nodes.reinit(cell, displacement);
        at_gauss_points.reinit(cell, displacement);
        find_min_jacobian(at_nodes, extremes.min_jacobian);
        find_min_jacobian(at_gauss_points, extremes.min_jacobian);
        for (unsigned int p = 0; p < at_gauss_points.n_points(); ++p)
          {
            for (const double principal :
                 eigenvalues(at_gauss_points.strain(p)))
              extremes.max_strain =
                std::max(extremes.max_strain, std::abs(principal));
            extremes.max_shear = std::max(
              extremes.max_shear, maximum_shear(at_gauss_points.stress(p)));
          }
        for (const auto &node : discretization.node_indices(cell))
          {
            Tensor<1, dim> u;
            for (unsigned int c = 0; c < dim; ++c)
              u[c] = displacement(node[c]);
            extremes.max_displacement =
              std::max(extremes.max_displacement, u.norm());
          }
      }
  return of_all(extremes, discretization.communicator);
}



namespace
{
/** Whether a place in a grid of 3^dim points is a node; of serendipity elements
 * it is where it is in the middle in one direction at most. */
template <int dim>
bool
is_node(const ElasticModel<dim> &model, unsigned int place)
{
  unsigned int n_middles = 0;
  for (unsigned int d = 0; d < dim; ++d, place /= 3)
    n_middles += place % 3 == 1;
  return n_middles <= 1 ||
         model.discretization.type != ElementType::serendipity;
}



/** Let a point's strain and shear count. Both have bounds that take less than
 * the principal values, which are hardly ever needed then. */
template <int dim>
void
include_strain(const Tensor<2, dim> &gradient,
               const double mu,
               DeformationExtremes &extremes)
{
  const SymmetricTensor<2, dim> strain = symmetrize(gradient);
  const double square                  = strain * strain;
  if (square > extremes.max_strain * extremes.max_strain)
    for (const double principal : eigenvalues(strain))
      extremes.max_strain = std::max(extremes.max_strain, std::abs(principal));
  const double trace      = dealii::trace(strain);
  const double distortion = square - trace * trace / 3;
  if (2 * mu * mu * distortion > extremes.max_shear * extremes.max_shear)
    {
      SymmetricTensor<2, 3> stress;
      for (unsigned int i = 0; i < dim; ++i)
        for (unsigned int j = 0; j <= i; ++j)
          stress[i][j] = 2 * mu * strain[i][j];
      extremes.max_shear = std::max(extremes.max_shear, maximum_shear(stress));
    }
}



/** The largest |sqrt(1 + x) - 1| of numbers x that are at most as large as a
 * bound in magnitude. */
double
bound_of_stretch(const double bound)
{
  return bound < 1 ? 1 - std::sqrt(1 - bound)
                   : std::max(1., std::sqrt(1 + bound) - 1);
}



/** The same under finite strain, in the displacement formulation. */
template <int dim>
void
include_finite_strain(const Tensor<2, dim> &gradient,
                      const Material &material,
                      DeformationExtremes &extremes)
{
  const Tensor<2, dim> F = gradient + unit_symmetric_tensor<dim>();
  const auto change =
    symmetrize(transpose(F) * F) - unit_symmetric_tensor<dim>();
  if (bound_of_stretch(change.norm()) > extremes.max_strain)
    for (const double principal : eigenvalues(strain_of(material, gradient)))
      extremes.max_strain = std::max(extremes.max_strain, std::abs(principal));
  const auto stress     = stress_of(material, gradient, Point<dim>(), {});
  const auto distortion = deviator(stress);
  if (distortion * distortion > 2 * extremes.max_shear * extremes.max_shear)
    extremes.max_shear = std::max(extremes.max_shear, maximum_shear(stress));
}



/** The largest displacement of this process's nodes. */
template <int dim>
double
largest_displacement(const LA::Vector &displacement)
{
  const auto &vector    = displacement.trilinos_vector();
  const double *const u = vector[0];
  double largest        = 0;
  // deal.II numbers the components of a node one after the other.
  for (int i = 0; i + dim <= vector.MyLength(); i += dim)
    {
      Tensor<1, dim> of_node;
      for (unsigned int c = 0; c < dim; ++c)
        of_node[c] = u[i + c];
      largest = std::max(largest, of_node.norm());
    }
  return largest;
}



/** Let the cells of a batch count. */
template <int dim>
void
include_batch(const ElasticModel<dim> &model,
              const GradientsOfBatch &gradients,
              DeformationExtremes &extremes)
{
  constexpr unsigned int n_points = Utilities::pow(3, dim);
  const CellBatch &batch          = gradients.batch;
  for (unsigned int lane = 0; lane < batch.n_cells; ++lane)
    {
      const Material &material =
        model.materials.of_element(model.discretization.element(
          model.batches().cells()[gradients.first_cell + lane]));
      for (unsigned int p = 0; p < 2 * n_points; ++p)
        {
          if (p < n_points && !is_node<dim>(model, p))
            continue;
          const auto gradient = gradients.at<dim>(p, lane);
          extremes.min_jacobian =
            std::min(extremes.min_jacobian,
                     determinant(unit_symmetric_tensor<dim>() + gradient));
          if (p < n_points)
            continue;
          if (!model.materials.finite_strain)
            include_strain(
              gradient, batch.moduli[gradients.n_lanes + lane], extremes);
          else
            include_finite_strain(gradient, material, extremes);
        }
    }
}



/** Whether gradients are all that strain and stress depend on, in a way that is
 * known here, and are found in batches. */
template <int dim>
bool
has_local_stress(const ElasticModel<dim> &model)
{
  return model.discretization.type != ElementType::linear &&
         (model.materials.is_hookean() ||
          (model.materials.finite_strain && !model.materials.any_is_mixed() &&
           model.internal.empty()));
}
} // namespace


template <int dim>
DeformationExtremes
find_extremes(const ElasticModel<dim> &model, const LA::Vector &displacement)
{
  const auto &discretization = model.discretization;
  if (!has_local_stress(model))
    return find_extremes(discretization,
                         model.materials,
                         discretization.with_ghosts(displacement),
                         &model.internal);
  auto u = model.batches().copy_in(displacement);
  u.update_ghost_values();
  DeformationExtremes extremes;
  visit_gradients<dim>(model, u, [&](const GradientsOfBatch &gradients) {
    include_batch<dim>(model, gradients, extremes);
  });
  extremes.max_displacement = largest_displacement<dim>(displacement);
  return of_all(extremes, discretization.communicator);
}



namespace
{
/** The cell of this process with the smallest determinant of the deformation
 * gradient at a node; none where it has no cells. */
template <int dim>
std::optional<typename Discretization<dim>::Cell>
most_pressed_cell(const ElasticModel<dim> &model,
                  const LA::Vector &displacement)
{
  auto u = model.batches().copy_in(displacement);
  u.update_ghost_values();
  double smallest = std::numeric_limits<double>::infinity();
  std::optional<unsigned int> number;
  visit_gradients<dim>(model, u, [&](const GradientsOfBatch &gradients) {
    for (unsigned int p = 0; p < Utilities::pow(3, dim); ++p)
      if (is_node<dim>(model, p))
        for (unsigned int lane = 0; lane < gradients.batch.n_cells; ++lane)
          if (const double ratio = determinant(unit_symmetric_tensor<dim>() +
                                               gradients.at<dim>(p, lane));
              !(ratio >= smallest))
            {
              smallest = ratio;
              number   = gradients.first_cell + lane;
            }
  });
  if (!number)
    return {};
  return model.batches().cells()[*number];
}
} // namespace


template <int dim>
SmallestVolume<dim>
find_smallest_volume(const ElasticModel<dim> &model,
                     const LA::Vector &displacement)
{
  const auto &discretization = model.discretization;
  const LA::Vector u         = discretization.with_ghosts(displacement);
  StressEvaluator<dim> at_nodes(
    discretization, model.materials, node_points(discretization));
  SmallestVolume<dim> smallest;
  const auto include = [&](const auto &cell) {
    at_nodes.reinit(cell, u);
    for (unsigned int p = 0; p < at_nodes.n_points(); ++p)
      if (const double ratio =
            determinant(unit_symmetric_tensor<dim>() + at_nodes.gradient(p));
          ratio < smallest.ratio)
        smallest = {ratio, discretization.element(cell), at_nodes.point(p)};
  };
  if (discretization.type != ElementType::linear)
    {
      if (const auto cell = most_pressed_cell(model, displacement))
        include(*cell);
    }
  else
    for (const auto &cell : discretization.dof_handler.active_cell_iterators())
      if (cell->is_locally_owned())
        include(cell);
  const auto of_processes = Utilities::MPI::all_gather(
    discretization.communicator,
    std::make_pair(smallest.ratio,
                   std::make_pair(smallest.element, smallest.node)));
  for (const auto &[ratio, where] : of_processes)
    if (ratio < smallest.ratio)
      smallest = {ratio, where.first, where.second};
  return smallest;
}



template SmallestVolume<2>
find_smallest_volume(const ElasticModel<2> &, const LA::Vector &);
template SmallestVolume<3>
find_smallest_volume(const ElasticModel<3> &, const LA::Vector &);
template DeformationExtremes
find_extremes(const Discretization<2> &,
              const MaterialParameters<2> &,
              const LA::Vector &,
              const InternalVariables<2> *);
template DeformationExtremes
find_extremes(const Discretization<3> &,
              const MaterialParameters<3> &,
              const LA::Vector &,
              const InternalVariables<3> *);
template DeformationExtremes
find_extremes(const ElasticModel<2> &, const LA::Vector &);
template DeformationExtremes
find_extremes(const ElasticModel<3> &, const LA::Vector &);
} // namespace Setsudan
