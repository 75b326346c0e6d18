// SPDX-License-Identifier: LGPL-2.1-or-later
#include <deal.II/base/quadrature_lib.h>

#include <setsudan/mechanics/law_integration.h>

namespace Setsudan
{
using namespace dealii;

template <int dim>
LawIntegration<dim>::LawIntegration(const Discretization<dim> &discretization,
                                    const MaterialParameters<dim> &materials,
                                    InternalVariables<dim> &internal)
  : forces(discretization.fe.n_dofs_per_cell())
  , tangent(forces.size(), forces.size())
  , discretization(discretization)
  , materials(materials)
  , internal(internal)
  , fe_values(discretization.mapping(),
              discretization.fe,
              QGauss<dim>(discretization.n_gauss_points()),
              update_gradients | update_JxW_values)
  , gradients(fe_values.n_quadrature_points)
{
}



template <int dim>
void
LawIntegration<dim>::reinit(const Cell &cell,
                            const LA::Vector &displacement,
                            const bool needs_tangent)
{
  const ConstitutiveLaw &law =
    *materials.of_element(discretization.element(cell)).law;
  fe_values.reinit(cell);
  fe_values[FEValuesExtractors::Vector(0)].get_function_gradients(displacement,
                                                                  gradients);
  forces               = 0;
  tangent              = 0;
  energy               = 0;
  const unsigned int c = cell->active_cell_index();
  for (const unsigned int q : fe_values.quadrature_point_indices())
    {
      Tensor<2, 3> gradient;
      for (unsigned int i = 0; i < dim; ++i)
        for (unsigned int j = 0; j < dim; ++j)
          gradient[i][j] = gradients[q][i][j];
      const auto response =
        law.evaluate(gradient, internal.before(c, q), internal.after(c, q));
      energy += response.energy * fe_values.JxW(q);
      add_forces(q, response.stress);
      if (needs_tangent)
        add_tangent(q, response.tangent);
    }
}



template <int dim>
void
LawIntegration<dim>::add_forces(const unsigned int q,
                                const Tensor<2, 3> &stress)
{
  for (unsigned int a = 0; a < forces.size(); ++a)
    for (unsigned int j = 0; j < dim; ++j)
      forces(a) +=
        stress[discretization.fe.system_to_component_index(a).first][j] *
        fe_values.shape_grad(a, q)[j] * fe_values.JxW(q);
}



template <int dim>
void
LawIntegration<dim>::add_tangent(const unsigned int q,
                                 const Tensor<4, 3> &of_law)
{
  const auto &fe = discretization.fe;
  for (unsigned int a = 0; a < forces.size(); ++a)
    {
      const unsigned int i = fe.system_to_component_index(a).first;
      Tensor<2, 3> of_a;
      for (unsigned int j = 0; j < dim; ++j)
        of_a += fe_values.shape_grad(a, q)[j] * fe_values.JxW(q) * of_law[i][j];
      for (unsigned int b = 0; b < forces.size(); ++b)
        for (unsigned int l = 0; l < dim; ++l)
          tangent(a, b) += of_a[fe.system_to_component_index(b).first][l] *
                           fe_values.shape_grad(b, q)[l];
    }
}



template class LawIntegration<2>;
template class LawIntegration<3>;
} // namespace Setsudan
