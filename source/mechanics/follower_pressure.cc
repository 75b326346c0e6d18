// SPDX-License-Identifier: LGPL-2.1-or-later
#include <deal.II/base/quadrature_lib.h>

#include <setsudan/mechanics/follower_pressure.h>

#include <vector>

namespace Setsudan
{
using namespace dealii;

template <int dim>
FollowerPressure<dim>::FollowerPressure(
  const Discretization<dim> &discretization,
  const LoadParameters<dim> &loads)
  : forces(discretization.fe.n_dofs_per_cell())
  , tangent(forces.size(), forces.size())
  , discretization(discretization)
  , loads(loads)
  , any(loads.has_pressure())
  , face_values(discretization.mapping(),
                discretization.fe,
                QGauss<dim - 1>(discretization.n_gauss_points()),
                update_values | update_gradients | update_JxW_values |
                  update_normal_vectors | update_quadrature_points)
{
}



template <int dim>
bool
FollowerPressure<dim>::reinit(const Cell &cell,
                              const LA::Vector &displacement,
                              const bool needs_tangent)
{
  bool has_pressure = false;
  if (any)
    for (const unsigned int face : cell->face_indices())
      if (cell->face(face)->at_boundary())
        {
          const auto load =
            loads.surface_loads.find({discretization.element(cell), face});
          if (load == loads.surface_loads.end() || load->second.pressure == 0)
            continue;
          if (!has_pressure)
            {
              forces    = 0;
              tangent   = 0;
              potential = 0;
            }
          has_pressure = true;
          face_values.reinit(cell, face);
          add_face(load->second.pressure, displacement, needs_tangent);
        }
  return has_pressure;
}



template <int dim>
void
FollowerPressure<dim>::add_face(const double pressure,
                                const LA::Vector &displacement,
                                const bool needs_tangent)
{
  const FEValuesExtractors::Vector components(0);
  const auto &fe = discretization.fe;
  std::vector<Tensor<1, dim>> values(face_values.n_quadrature_points);
  std::vector<Tensor<2, dim>> gradients(values.size());
  face_values[components].get_function_values(displacement, values);
  face_values[components].get_function_gradients(displacement, gradients);
  FullMatrix<double> of_face(forces.size(), forces.size());
  for (const unsigned int q : face_values.quadrature_point_indices())
    {
      const Tensor<2, dim> F = gradients[q] + unit_symmetric_tensor<dim>();
      const Tensor<2, dim> inverse_transposed = transpose(invert(F));
      const Tensor<1, dim> normal             = face_values.normal_vector(q);
      // n da, and what a change of F makes of it.
      const double J                 = determinant(F);
      const Tensor<1, dim> direction = inverse_transposed * normal;
      const double weight            = pressure * J * face_values.JxW(q);
      const Point<dim> position      = face_values.quadrature_point(q);
      potential += (weight * (direction * (position + values[q])) -
                    pressure * face_values.JxW(q) * (normal * position)) /
                   dim;
      for (unsigned int a = 0; a < forces.size(); ++a)
        {
          const unsigned int i = fe.system_to_component_index(a).first;
          const double value   = face_values.shape_value(a, q);
          forces(a) -= weight * direction[i] * value;
          if (!needs_tangent || value == 0)
            continue;
          for (unsigned int b = 0; b < forces.size(); ++b)
            {
              const unsigned int k = fe.system_to_component_index(b).first;
              const Tensor<1, dim> gradient =
                inverse_transposed * face_values.shape_grad(b, q);
              of_face(a, b) -=
                weight * value *
                (gradient[k] * direction[i] - gradient[i] * direction[k]);
            }
        }
    }
  if (needs_tangent)
    for (unsigned int a = 0; a < forces.size(); ++a)
      for (unsigned int b = 0; b < forces.size(); ++b)
        tangent(a, b) += (of_face(a, b) + of_face(b, a)) / 2;
}



template class FollowerPressure<2>;
template class FollowerPressure<3>;
} // namespace Setsudan
