// SPDX-License-Identifier: LGPL-2.1-or-later
#include <deal.II/base/quadrature_lib.h>

#include <setsudan/material/finite_strain_law.h>
#include <setsudan/material/small_strain_law.h>
#include <setsudan/mechanics/strain_and_stress.h>
#include <setsudan/mechanics/stress/stress_evaluator.h>

#include <limits>
#include <optional>

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



namespace
{
/** What values at Gauss points count at a point of the reference cell, for the
 * linear function that is nearest to them. */
template <int dim>
std::vector<double>
weights_of_linear_fit(const Quadrature<dim> &gauss, const Point<dim> &point)
{
  // The second moment of the reference cell about its center.
  constexpr double moment = 1. / 12;
  Point<dim> center;
  for (unsigned int d = 0; d < dim; ++d)
    center[d] = 0.5;
  std::vector<double> weights;
  for (unsigned int q = 0; q < gauss.size(); ++q)
    weights.push_back(
      gauss.weight(q) *
      (1 + (point - center) * (gauss.point(q) - center) / moment));
  return weights;
}
} // namespace


template <int dim>
StressEvaluator<dim>::StressEvaluator(const Discretization<dim> &discretization,
                                      const MaterialParameters<dim> &materials,
                                      const Quadrature<dim> &points,
                                      const InternalVariables<dim> *variables)
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
  if (variables == nullptr || variables->empty())
    return;
  internal         = variables;
  const auto gauss = gauss_points(discretization);
  const bool same  = points.get_points() == gauss.get_points();
  for (unsigned int p = 0; p < points.size(); ++p)
    {
      internal_weights.push_back(weights_of_linear_fit(gauss, points.point(p)));
      for (unsigned int q = 0; same && q < gauss.size(); ++q)
        internal_weights[p][q] = p == q;
    }
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
  if (internal != nullptr && material->law->n_internal() > 0)
    return stress_with_memory(p);
  return stress_of(*material,
                   gradient(p),
                   point(p),
                   projected.value_or(LinearFunction<dim>()));
}



namespace
{
/** @param volume that is projected, of a mixed material. */
SymmetricTensor<2, 3>
cauchy_stress(const FiniteStrainLaw &law,
              const Tensor<2, 3> &gradient,
              const History &history,
              const std::optional<double> &volume)
{
  const Tensor<2, 3> F = gradient + unit_symmetric_tensor<3>();
  const double J       = determinant(F);
  if (!(J > 0) || (volume && !(*volume > 0)))
    return std::numeric_limits<double>::quiet_NaN() *
           unit_symmetric_tensor<3>();
  const auto response = law.respond(
    symmetrize(transpose(F) * F), volume.value_or(J), history, false);
  return symmetrize(F * response.distortion.stress * transpose(F)) / J +
         response.mean_stress * unit_symmetric_tensor<3>();
}
} // namespace


template <int dim>
SymmetricTensor<2, 3>
StressEvaluator<dim>::stress_with_memory(const unsigned int p) const
{
  const unsigned int cell = present->active_cell_index();
  const auto &weights     = internal_weights[p];
  std::vector<double> before(material->law->n_internal(), 0.),
    after(before.size());
  for (unsigned int q = 0; q < weights.size(); ++q)
    {
      const auto at_gauss_point = internal->present(cell, q);
      for (unsigned int i = 0; i < before.size(); ++i)
        before[i] += weights[q] * at_gauss_point[i];
    }
  const Tensor<2, 3> in_space = Setsudan::in_space(gradient(p));
  const History history{{before.data(), before.size()},
                        {after.data(), after.size()}};
  if (const auto *const law = material->law->finite_strain())
    return cauchy_stress(*law,
                         in_space,
                         history,
                         projected ? (*projected)(point(p))
                                   : std::optional<double>());
  if (projected)
    return material->law->small_strain()
      ->respond(symmetrize(in_space), (*projected)(point(p)), history)
      .stress;
  return symmetrize(material->law->evaluate(in_space, history, false).stress);
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
