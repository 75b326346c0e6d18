#include <deal.II/base/quadrature_lib.h>

#include <setsudan/mechanics/stress/strain_recovery.h>

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
} // namespace Setsudan
