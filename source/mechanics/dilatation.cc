// SPDX-License-Identifier: LGPL-2.1-or-later
#include <deal.II/base/quadrature_lib.h>

#include <setsudan/mechanics/dilatation.h>
#include <setsudan/mechanics/mixed_cell.h>

namespace Setsudan
{
using namespace dealii;

template <int dim>
LinearFit<dim>
dilatation_fit(const ElementType type, const FEValues<dim> &fe_values)
{
  return LinearFit<dim>(fe_values.get_quadrature_points(),
                        fe_values.get_JxW_values(),
                        type == ElementType::linear);
}



template <int dim>
MixedCell<dim>::MixedCell(const DecoupledLaw &law,
                          const LinearFit<dim> &fit,
                          const std::vector<Point<dim>> &points,
                          const std::vector<double> &volumes)
{
  const auto theta = fit(volumes);
  std::vector<double> stresses;
  for (const auto &point : points)
    {
      const double J = theta(point);
      is_valid       = is_valid && J > 0;
      if (!is_valid)
        return;
      energies.push_back(law.volumetric.value(J));
      stresses.push_back(law.volumetric.derivative(J));
      stiffness.push_back(law.volumetric.second_derivative(J));
    }
  mean_stress = fit(stresses);
}



template <int dim>
Dilatation<dim>::Dilatation(const Discretization<dim> &discretization)
  : type(discretization.type)
  , fe_values(discretization.mapping(),
              discretization.fe,
              QGauss<dim>(discretization.n_gauss_points()),
              update_gradients | update_JxW_values | update_quadrature_points)
  , divergences(fe_values.n_quadrature_points)
  , gradients(fe_values.n_quadrature_points)
{
}



template <int dim>
LinearFunction<dim>
Dilatation<dim>::operator()(const Cell &cell,
                            const Material &material,
                            const LA::Vector &displacement)
{
  const FEValuesExtractors::Vector components(0);
  fe_values.reinit(cell);
  const auto fit        = dilatation_fit(type, fe_values);
  const auto *const law = material.law->hyperelastic();
  if (law == nullptr && material.law->finite_strain() == nullptr)
    {
      fe_values[components].get_function_divergences(displacement, divergences);
      return fit(divergences);
    }
  fe_values[components].get_function_gradients(displacement, gradients);
  std::vector<double> volumes;
  for (const auto &gradient : gradients)
    volumes.push_back(determinant(gradient + unit_symmetric_tensor<dim>()));
  if (law == nullptr)
    return fit(volumes);
  const MixedCell<dim> mixed(
    *law->decoupled(), fit, fe_values.get_quadrature_points(), volumes);
  return mixed.mean_stress;
}



#define INSTANTIATE(dim)                                         \
  template LinearFit<dim> dilatation_fit(const ElementType,      \
                                         const FEValues<dim> &); \
  template struct MixedCell<dim>;                                \
  template class Dilatation<dim>;

INSTANTIATE(2)
INSTANTIATE(3)

#undef INSTANTIATE
} // namespace Setsudan
