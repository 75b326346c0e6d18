#include <deal.II/base/quadrature_lib.h>

#include <setsudan/elasticity/dilatation.h>

namespace Setsudan
{
using namespace dealii;

template <int dim>
Dilatation<dim>::Dilatation(const Discretization<dim> &discretization)
  : fe_values(discretization.mapping(),
              discretization.fe,
              QGauss<dim>(3),
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
  return LinearFit<dim>(fe_values.get_quadrature_points(),
                        fe_values.get_JxW_values())(divergences);
}



template class Dilatation<2>;
template class Dilatation<3>;
} // namespace Setsudan
