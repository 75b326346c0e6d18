// SPDX-License-Identifier: LGPL-2.1-or-later
#include <deal.II/base/quadrature_lib.h>

#include <setsudan/mechanics/law_integration.h>
#include <setsudan/mechanics/strain_and_stress.h>

#include <array>

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
  , fe_values(
      discretization.mapping(),
      discretization.fe,
      QGauss<dim>(discretization.n_gauss_points()),
      update_gradients | update_JxW_values |
        (materials.any_is_mixed() ? update_quadrature_points : update_default))
{
}



template <int dim>
typename LawIntegration<dim>::Gradients
LawIntegration<dim>::gradients_of(const LA::Vector &displacement) const
{
  std::vector<Tensor<2, dim>> values(fe_values.n_quadrature_points);
  fe_values[FEValuesExtractors::Vector(0)].get_function_gradients(displacement,
                                                                  values);
  Gradients gradients;
  for (const auto &value : values)
    gradients.push_back(in_space(value));
  return gradients;
}



namespace
{
/** The second Piola-Kirchhoff stress at a point, and how it grows with the
 * gradient. */
Tensor<2, 3>
extrapolated(const MaterialResponse &before,
             const Tensor<2, 3> &gradient,
             const Tensor<2, 3> &step)
{
  const Tensor<2, 3> inverse = invert(deformation_gradient(gradient));
  const Tensor<2, 3> stress  = inverse * before.stress;
  return stress + inverse * (double_contract<2, 0, 3, 1>(before.tangent, step) -
                             step * stress);
}
} // namespace


template <int dim>
std::vector<MaterialResponse>
LawIntegration<dim>::respond(const ConstitutiveLaw &law,
                             const unsigned int c,
                             const Gradients &gradients,
                             const Gradients *before,
                             const bool needs_tangent) const
{
  const auto *const elastic = before != nullptr ? law.hyperelastic() : nullptr;
  std::vector<MaterialResponse> responses;
  for (unsigned int q = 0; q < gradients.size(); ++q)
    {
      responses.push_back(
        law.evaluate(gradients[q], internal.history(c, q), needs_tangent));
      if (elastic == nullptr || !responses.back().energy.is_finite())
        continue;
      const auto change =
        extrapolated(elastic->respond((*before)[q]),
                     (*before)[q],
                     gradients[q] - (*before)[q]) -
        invert(deformation_gradient(gradients[q])) * responses.back().stress;
      for (unsigned int i = 0; i < 3; ++i)
        for (unsigned int j = 0; j < 3; ++j)
          for (unsigned int l = 0; l < 3; ++l)
            responses.back().tangent[i][j][i][l] += change[j][l];
    }
  return responses;
}



template <int dim>
void
LawIntegration<dim>::evaluate(const Cell &cell,
                              const LA::Vector &displacement,
                              const LA::Vector *before,
                              const bool needs_tangent)
{
  const Material &material = materials.of_element(discretization.element(cell));
  const auto *const elastic = material.law->hyperelastic();
  const auto *const decoupled =
    material.is_mixed && elastic != nullptr ? elastic->decoupled() : nullptr;
  const auto *const small =
    material.is_mixed ? material.law->small_strain() : nullptr;
  const auto *const finite =
    material.is_mixed ? material.law->finite_strain() : nullptr;
  fe_values.reinit(cell);
  forces         = 0;
  tangent        = 0;
  energy         = Energy();
  auto gradients = gradients_of(displacement);
  Gradients gradients_before;
  if (before != nullptr)
    gradients_before = gradients_of(*before);
  const Gradients *const from = before != nullptr ? &gradients_before : nullptr;
  std::vector<double> stiffness;
  std::vector<MaterialResponse> responses;
  const unsigned int c = cell->active_cell_index();
  if (decoupled != nullptr)
    responses =
      respond_mixed(*decoupled, gradients, from, needs_tangent, stiffness);
  else if (finite != nullptr)
    responses = respond_mixed(*finite, c, gradients, needs_tangent, stiffness);
  else if (small != nullptr)
    {
      responses = respond_mixed(*small, c, gradients, stiffness);
      // About which the change of volume is linear.
      gradients.assign(gradients.size(), Tensor<2, 3>());
    }
  else
    responses = respond(*material.law, c, gradients, from, needs_tangent);
  for (const auto &response : responses)
    if (!response.energy.is_finite())
      {
        energy = response.energy;
        return;
      }
  for (const unsigned int q : fe_values.quadrature_point_indices())
    {
      energy.add(fe_values.JxW(q), responses[q].energy);
      add_forces(q, responses[q].stress);
    }
  if (needs_tangent)
    add_tangents(responses);
  if (needs_tangent && !stiffness.empty())
    add_volume_stiffness(gradients, stiffness);
}



template <int dim>
void
LawIntegration<dim>::reinit(const Cell &cell, const LA::Vector &displacement)
{
  evaluate(cell, displacement, nullptr, false);
}



template <int dim>
void
LawIntegration<dim>::reinit_with_tangent(const Cell &cell,
                                         const LA::Vector &displacement,
                                         const LA::Vector *before)
{
  evaluate(cell, displacement, before, true);
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
LawIntegration<dim>::add_tangents(
  const std::vector<MaterialResponse> &responses)
{
  const auto &fe             = discretization.fe;
  const unsigned int n       = forces.size();
  const unsigned int n_nodes = n / dim;
  const unsigned int n_rates = responses.size() * dim;
  // A node's function has the same gradient in each direction in which it moves
  // the node.
  FullMatrix<double> gradients(n_nodes, n_rates);
  // Of each function the stress, one row of it for each such direction.
  std::array<FullMatrix<double>, dim> stresses;
  stresses.fill(FullMatrix<double>(n, n_rates));
  for (unsigned int q = 0; q < responses.size(); ++q)
    for (unsigned int a = 0; a < n; ++a)
      {
        const auto [i, node] = fe.system_to_component_index(a);
        const auto gradient  = fe_values.shape_grad(a, q);
        const auto &of_law   = responses[q].tangent[i];
        for (unsigned int l = 0; l < dim; ++l)
          {
            gradients(node, q * dim + l) = gradient[l];
            for (unsigned int k = 0; k < dim; ++k)
              {
                double stress = 0;
                for (unsigned int j = 0; j < dim; ++j)
                  stress += gradient[j] * of_law[j][k][l];
                stresses[k](a, q * dim + l) = stress * fe_values.JxW(q);
              }
          }
      }
  std::array<FullMatrix<double>, dim> products;
  products.fill(FullMatrix<double>(n, n_nodes));
  for (unsigned int k = 0; k < dim; ++k)
    stresses[k].mTmult(products[k], gradients);
  for (unsigned int b = 0; b < n; ++b)
    {
      const auto [k, node] = fe.system_to_component_index(b);
      for (unsigned int a = 0; a < n; ++a)
        tangent(a, b) += products[k](a, node);
    }
}



template class LawIntegration<2>;
template class LawIntegration<3>;
} // namespace Setsudan
