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
LawIntegration<dim>::reinit(const Cell &cell, const LA::Vector &displacement)
{
  const auto &fe       = discretization.fe;
  const unsigned int n = fe.n_dofs_per_cell();
  const ConstitutiveLaw &law =
    *materials.of_element(discretization.element(cell)).law;
  fe_values.reinit(cell);
  fe_values[FEValuesExtractors::Vector(0)].get_function_gradients(displacement,
                                                                  gradients);
  forces  = 0;
  tangent = 0;
  energy  = 0;
  for (const unsigned int q : fe_values.quadrature_point_indices())
    {
      Tensor<2, 3> gradient;
      for (unsigned int i = 0; i < dim; ++i)
        for (unsigned int j = 0; j < dim; ++j)
          gradient[i][j] = gradients[q][i][j];
      const unsigned int c = cell->active_cell_index();
      const auto response =
        law.evaluate(gradient, internal.before(c, q), internal.after(c, q));
      energy += response.energy * fe_values.JxW(q);
      for (unsigned int a = 0; a < n; ++a)
        {
          const unsigned int i  = fe.system_to_component_index(a).first;
          const auto &grad_of_a = fe_values.shape_grad(a, q);
          Tensor<2, 3> of_a;
          for (unsigned int j = 0; j < dim; ++j)
            {
              forces(a) +=
                response.stress[i][j] * grad_of_a[j] * fe_values.JxW(q);
              of_a += grad_of_a[j] * fe_values.JxW(q) * response.tangent[i][j];
            }
          for (unsigned int b = 0; b < n; ++b)
            {
              const unsigned int k  = fe.system_to_component_index(b).first;
              const auto &grad_of_b = fe_values.shape_grad(b, q);
              for (unsigned int l = 0; l < dim; ++l)
                tangent(a, b) += of_a[k][l] * grad_of_b[l];
            }
        }
    }
}



template class LawIntegration<2>;
template class LawIntegration<3>;
} // namespace Setsudan
