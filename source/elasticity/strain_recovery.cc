#include <deal.II/base/mpi.h>
#include <deal.II/base/quadrature_lib.h>

#include <setsudan/elasticity/strain_recovery.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace Setsudan
{
using namespace dealii;

template <int dim>
Quadrature<dim>
node_points(const Discretization<dim> &discretization)
{
  return Quadrature<dim>(discretization.nodes());
}



template <int dim>
Quadrature<dim>
gauss_points(const Discretization<dim> &discretization)
{
  return QGauss<dim>(discretization.n_gauss_points());
}



template <int dim>
StrainRecovery<dim>::StrainRecovery(const Discretization<dim> &discretization,
                                    const MaterialParameters<dim> &materials,
                                    const Quadrature<dim> &points,
                                    const UpdateFlags flags)
  : discretization(discretization)
  , materials(materials)
  , fe_values(
      discretization.mapping(),
      discretization.fe,
      points,
      update_gradients | flags |
        (materials.any_is_mixed() ? update_quadrature_points : update_default))
  , gradients(points.size())
{
  if (materials.any_is_mixed())
    dilatation = std::make_unique<Dilatation<dim>>(discretization);
}



template <int dim>
void
StrainRecovery<dim>::reinit(const Cell &cell, const LA::Vector &displacement)
{
  fe_values.reinit(cell);
  fe_values[FEValuesExtractors::Vector(0)].get_function_gradients(displacement,
                                                                  gradients);
  material = &materials.of_element(discretization.element(cell));
  if (material->is_mixed)
    dilatation_of_cell = (*dilatation)(cell, displacement);
}



template <int dim>
unsigned int
StrainRecovery<dim>::n_points() const
{
  return gradients.size();
}



template <int dim>
const FEValues<dim> &
StrainRecovery<dim>::values() const
{
  return fe_values;
}



template <int dim>
const Point<dim> &
StrainRecovery<dim>::point(const unsigned int point) const
{
  return fe_values.quadrature_point(point);
}



template <int dim>
double
StrainRecovery<dim>::volume(const unsigned int point) const
{
  return fe_values.JxW(point);
}



template <int dim>
const Tensor<2, dim> &
StrainRecovery<dim>::gradient(const unsigned int point) const
{
  return gradients[point];
}



template <int dim>
SymmetricTensor<2, dim>
StrainRecovery<dim>::strain(const unsigned int point) const
{
  return symmetrize(gradients[point]);
}



template <int dim>
SymmetricTensor<2, 3>
StrainRecovery<dim>::stress(const unsigned int point) const
{
  if (material->is_mixed)
    return material->hooke.stress(
      strain(point), dilatation_of_cell(fe_values.quadrature_point(point)));
  return material->hooke.stress(strain(point));
}



namespace
{
/** Lower `min_jacobian` to the smallest determinant on the cell. */
template <int dim>
void
find_min_jacobian(const StrainRecovery<dim> &recovery, double &min_jacobian)
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
              const LA::Vector &displacement)
{
  StrainRecovery<dim> at_nodes(
    discretization, materials, node_points(discretization));
  StrainRecovery<dim> at_gauss_points(
    discretization, materials, gauss_points(discretization));
  DeformationExtremes extremes{std::numeric_limits<double>::max(), 0, 0, 0};
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
  const MPI_Comm communicator = discretization.communicator;
  return {Utilities::MPI::min(extremes.min_jacobian, communicator),
          Utilities::MPI::max(extremes.max_strain, communicator),
          Utilities::MPI::max(extremes.max_shear, communicator),
          Utilities::MPI::max(extremes.max_displacement, communicator)};
}



template Quadrature<2>
node_points(const Discretization<2> &);
template Quadrature<3>
node_points(const Discretization<3> &);
template Quadrature<2>
gauss_points(const Discretization<2> &);
template Quadrature<3>
gauss_points(const Discretization<3> &);
template class StrainRecovery<2>;
template class StrainRecovery<3>;
template DeformationExtremes
find_extremes(const Discretization<2> &,
              const MaterialParameters<2> &,
              const LA::Vector &);
template DeformationExtremes
find_extremes(const Discretization<3> &,
              const MaterialParameters<3> &,
              const LA::Vector &);
} // namespace Setsudan
