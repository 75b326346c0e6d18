// SPDX-License-Identifier: LGPL-2.1-or-later
#include <deal.II/base/quadrature_lib.h>

#include <setsudan/mechanics/dilatation.h>

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
Dilatation<dim>::Dilatation(const Discretization<dim> &discretization)
  : type(discretization.type)
  , fe_values(discretization.mapping(),
              discretization.fe,
              QGauss<dim>(discretization.n_gauss_points()),
              update_gradients | update_JxW_values | update_quadrature_points)
  , divergences(fe_values.n_quadrature_points)
{
}



template <int dim>
LinearFunction<dim>
Dilatation<dim>::operator()(const Cell &cell, const LA::Vector &displacement)
{
  fe_values.reinit(cell);
  fe_values[FEValuesExtractors::Vector(0)].get_function_divergences(
    displacement, divergences);
  return dilatation_fit(type, fe_values)(divergences);
}



template LinearFit<2>
dilatation_fit(const ElementType, const FEValues<2> &);
template LinearFit<3>
dilatation_fit(const ElementType, const FEValues<3> &);
template class Dilatation<2>;
template class Dilatation<3>;
} // namespace Setsudan
