// SPDX-License-Identifier: LGPL-2.1-or-later
#include <deal.II/base/quadrature_lib.h>

#include <setsudan/mechanics/strain_and_stress.h>
#include <setsudan/mechanics/stress/stress_evaluator.h>

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
StressEvaluator<dim>::StressEvaluator(const Discretization<dim> &discretization,
                                      const MaterialParameters<dim> &materials,
                                      const Quadrature<dim> &points)
  : discretization(discretization)
  , materials(materials)
  , weights(points.get_weights())
{
  const auto &element = discretization.fe.base_element(0);
  for (const auto &point : points.get_points())
    {
      function_values.emplace_back();
      function_gradients.emplace_back();
      for (unsigned int i = 0; i < element.n_dofs_per_cell(); ++i)
        {
          function_values.back().push_back(element.shape_value(i, point));
          function_gradients.back().push_back(element.shape_grad(i, point));
        }
    }
  if (materials.any_is_mixed())
    dilatation = std::make_unique<Dilatation<dim>>(discretization);
}



template <int dim>
void
StressEvaluator<dim>::reinit(const Cell &cell, const LA::Vector &displacement)
{
  indices   = discretization.node_indices(cell);
  positions = discretization.node_positions(cell);
  displacements.resize(indices.size());
  for (unsigned int i = 0; i < indices.size(); ++i)
    for (unsigned int c = 0; c < dim; ++c)
      displacements[i][c] = displacement(indices[i][c]);
  material = &materials.of_element(discretization.element(cell));
  present  = cell;
  field    = &displacement;
  projected.reset();
}



template <int dim>
unsigned int
StressEvaluator<dim>::n_points() const
{
  return function_values.size();
}



template <int dim>
Point<dim>
StressEvaluator<dim>::point(const unsigned int point) const
{
  Point<dim> position;
  for (unsigned int i = 0; i < positions.size(); ++i)
    position += function_values[point][i] * positions[i];
  return position;
}



template <int dim>
Tensor<2, dim>
StressEvaluator<dim>::jacobian(const unsigned int point) const
{
  Tensor<2, dim> sum;
  for (unsigned int i = 0; i < positions.size(); ++i)
    sum += outer_product(positions[i], function_gradients[point][i]);
  return sum;
}



template <int dim>
double
StressEvaluator<dim>::volume(const unsigned int point) const
{
  return determinant(jacobian(point)) * weights[point];
}



template <int dim>
Tensor<2, dim>
StressEvaluator<dim>::gradient(const unsigned int point) const
{
  Tensor<2, dim> sum;
  for (unsigned int i = 0; i < displacements.size(); ++i)
    sum += outer_product(displacements[i], function_gradients[point][i]);
  return sum * invert(jacobian(point));
}



template <int dim>
SymmetricTensor<2, dim>
StressEvaluator<dim>::strain(const unsigned int point) const
{
  return strain_of(*material, gradient(point));
}



template <int dim>
SymmetricTensor<2, 3>
StressEvaluator<dim>::stress(const unsigned int p) const
{
  if (material->is_mixed && !projected)
    projected = (*dilatation)(present, *material, *field);
  return stress_of(*material,
                   gradient(p),
                   point(p),
                   projected.value_or(LinearFunction<dim>()));
}



template <int dim>
std::vector<SymmetricTensor<2, 3>>
StressEvaluator<dim>::stresses() const
{
  std::vector<SymmetricTensor<2, 3>> result;
  for (unsigned int p = 0; p < n_points(); ++p)
    result.push_back(stress(p));
  return result;
}



template <int dim>
std::vector<Tensor<1, dim>>
StressEvaluator<dim>::values(const LA::Vector &field) const
{
  std::vector<Tensor<1, dim>> result(n_points());
  for (unsigned int i = 0; i < indices.size(); ++i)
    {
      Tensor<1, dim> at_node;
      for (unsigned int c = 0; c < dim; ++c)
        at_node[c] = field(indices[i][c]);
      for (unsigned int p = 0; p < result.size(); ++p)
        result[p] += function_values[p][i] * at_node;
    }
  return result;
}



template Quadrature<2>
node_points(const Discretization<2> &);
template Quadrature<3>
node_points(const Discretization<3> &);
template Quadrature<2>
gauss_points(const Discretization<2> &);
template Quadrature<3>
gauss_points(const Discretization<3> &);
template class StressEvaluator<2>;
template class StressEvaluator<3>;
} // namespace Setsudan
