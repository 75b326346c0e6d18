// SPDX-License-Identifier: LGPL-2.1-or-later
#include <deal.II/base/quadrature_lib.h>

#include <setsudan/mechanics/dilatation.h>
#include <setsudan/mechanics/law_integration.h>
#include <setsudan/mechanics/mixed_cell.h>
#include <setsudan/mechanics/strain_and_stress.h>

#include <array>
#include <cmath>
#include <limits>

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
/** The deformation gradient. */
Tensor<2, 3>
deformation(const Tensor<2, 3> &gradient)
{
  return gradient + unit_symmetric_tensor<3>();
}



/** The second Piola-Kirchhoff stress at a point, and how it grows with the
 * gradient. */
Tensor<2, 3>
extrapolated(const MaterialResponse &before,
             const Tensor<2, 3> &gradient,
             const Tensor<2, 3> &step)
{
  const Tensor<2, 3> inverse = invert(deformation(gradient));
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
        invert(deformation(gradients[q])) * responses.back().stress;
      for (unsigned int i = 0; i < 3; ++i)
        for (unsigned int j = 0; j < 3; ++j)
          for (unsigned int l = 0; l < 3; ++l)
            responses.back().tangent[i][j][i][l] += change[j][l];
    }
  return responses;
}



namespace
{
/** The derivative of J = det F by F. */
Tensor<2, 3>
cofactor(const Tensor<2, 3> &F)
{
  return determinant(F) * transpose(invert(F));
}



/** J at points. */
std::vector<double>
volumes(const std::vector<Tensor<2, 3>> &gradients)
{
  std::vector<double> result;
  for (const auto &gradient : gradients)
    result.push_back(determinant(deformation(gradient)));
  return result;
}



std::vector<MaterialResponse>
not_valid()
{
  MaterialResponse response;
  response.energy.potential = std::numeric_limits<double>::infinity();
  return {response};
}
} // namespace


template <int dim>
std::vector<MaterialResponse>
LawIntegration<dim>::respond_mixed(const DecoupledLaw &law,
                                   const Gradients &gradients,
                                   const Gradients *before,
                                   const bool needs_tangent,
                                   std::vector<double> &stiffness) const
{
  const auto &points = fe_values.get_quadrature_points();
  const auto fit     = dilatation_fit(discretization.type, fe_values);
  const auto J       = volumes(gradients);
  for (const double volume : J)
    if (!(volume > 0))
      return not_valid();
  const MixedCell<dim> mixed(law, fit, points, J);
  if (!mixed.is_valid)
    return not_valid();
  stiffness = mixed.stiffness;
  // The mean stress in the tangent.
  auto in_tangent = mixed.mean_stress;
  if (before != nullptr)
    {
      const MixedCell<dim> earlier(law, fit, points, volumes(*before));
      std::vector<double> growth;
      for (unsigned int q = 0; q < gradients.size(); ++q)
        growth.push_back(scalar_product(cofactor(deformation((*before)[q])),
                                        gradients[q] - (*before)[q]));
      const auto theta = fit(growth);
      for (unsigned int q = 0; q < growth.size(); ++q)
        growth[q] = earlier.stiffness[q] * theta(points[q]);
      const auto change = fit(growth);
      in_tangent        = earlier.mean_stress;
      in_tangent.value += change.value;
      in_tangent.slope += change.slope;
    }
  std::vector<MaterialResponse> responses;
  for (unsigned int q = 0; q < gradients.size(); ++q)
    {
      const Tensor<2, 3> F          = deformation(gradients[q]);
      const SymmetricTensor<2, 3> C = symmetrize(transpose(F) * F);
      const auto inverse_C          = invert(C);
      StrainEnergy energy           = law.distortion(C, needs_tangent);
      MaterialResponse response;
      response.energy = Energy::elastic(energy.value + mixed.energies[q]);
      response.stress =
        F * (energy.stress + mixed.mean_stress(points[q]) * J[q] * inverse_C);
      add_pressure(in_tangent(points[q]), 0, J[q], inverse_C, energy);
      if (needs_tangent)
        response.tangent =
          tangent_in_gradient(F, energy.stress, energy.tangent);
      responses.push_back(response);
    }
  return responses;
}



template <int dim>
std::vector<MaterialResponse>
LawIntegration<dim>::respond_mixed(const SmallStrainLaw &law,
                                   const unsigned int c,
                                   const Gradients &gradients,
                                   std::vector<double> &stiffness) const
{
  const auto &points = fe_values.get_quadrature_points();
  std::vector<double> divergences;
  for (const auto &gradient : gradients)
    divergences.push_back(trace(gradient));
  const auto theta =
    dilatation_fit(discretization.type, fe_values)(divergences);
  std::vector<MaterialResponse> responses;
  for (unsigned int q = 0; q < gradients.size(); ++q)
    {
      const auto response = law.respond(
        symmetrize(gradients[q]), theta(points[q]), internal.history(c, q));
      stiffness.push_back(response.lambda);
      responses.push_back({Tensor<2, 3>(response.stress),
                           Tensor<4, 3>(response.tangent),
                           response.energy});
    }
  return responses;
}



template <int dim>
std::vector<MaterialResponse>
LawIntegration<dim>::respond_mixed(const FiniteStrainLaw &law,
                                   const unsigned int c,
                                   const Gradients &gradients,
                                   const bool needs_tangent,
                                   std::vector<double> &stiffness) const
{
  const auto &points = fe_values.get_quadrature_points();
  const auto fit     = dilatation_fit(discretization.type, fe_values);
  const auto J       = volumes(gradients);
  const auto theta   = fit(J);
  std::vector<FiniteStrainLaw::Response> of_law;
  std::vector<double> mean_stresses;
  for (unsigned int q = 0; q < gradients.size(); ++q)
    {
      const double volume = theta(points[q]);
      if (!(J[q] > 0) || !(volume > 0))
        return not_valid();
      const Tensor<2, 3> F = deformation(gradients[q]);
      of_law.push_back(law.respond(symmetrize(transpose(F) * F),
                                   volume,
                                   internal.history(c, q),
                                   needs_tangent));
      mean_stresses.push_back(of_law.back().mean_stress);
      stiffness.push_back(of_law.back().stiffness);
    }
  const auto mean_stress = fit(mean_stresses);
  std::vector<MaterialResponse> responses;
  for (unsigned int q = 0; q < gradients.size(); ++q)
    {
      const Tensor<2, 3> F = deformation(gradients[q]);
      StrainEnergy &all    = of_law[q].distortion;
      add_pressure(mean_stress(points[q]),
                   0,
                   J[q],
                   invert(symmetrize(transpose(F) * F)),
                   all);
      responses.push_back({F * all.stress,
                           needs_tangent
                             ? tangent_in_gradient(F, all.stress, all.tangent)
                             : Tensor<4, 3>(),
                           of_law[q].energy});
    }
  return responses;
}



template <int dim>
void
LawIntegration<dim>::add_volume_stiffness(const Gradients &gradients,
                                          const std::vector<double> &stiffness)
{
  const auto &fe       = discretization.fe;
  const auto &points   = fe_values.get_quadrature_points();
  const auto fit       = dilatation_fit(discretization.type, fe_values);
  const unsigned int n = points.size();
  std::vector<Tensor<2, 3>> of_volume;
  for (const auto &gradient : gradients)
    of_volume.push_back(cofactor(deformation(gradient)));
  // What each function does to theta at each point.
  FullMatrix<double> growth(forces.size(), n), weighted(forces.size(), n);
  std::vector<double> of_function(n);
  for (unsigned int a = 0; a < forces.size(); ++a)
    {
      const unsigned int i = fe.system_to_component_index(a).first;
      for (unsigned int q = 0; q < n; ++q)
        {
          of_function[q] = 0;
          for (unsigned int j = 0; j < dim; ++j)
            of_function[q] +=
              of_volume[q][i][j] * fe_values.shape_grad(a, q)[j];
        }
      const auto theta = fit(of_function);
      for (unsigned int q = 0; q < n; ++q)
        {
          growth(a, q)   = theta(points[q]);
          weighted(a, q) = growth(a, q) * stiffness[q] * fe_values.JxW(q);
        }
    }
  weighted.mTmult(tangent, growth, true);
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
