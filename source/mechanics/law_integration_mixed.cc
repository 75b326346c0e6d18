// SPDX-License-Identifier: LGPL-2.1-or-later
#include <setsudan/mechanics/dilatation.h>
#include <setsudan/mechanics/law_integration.h>
#include <setsudan/mechanics/mixed_cell.h>
#include <setsudan/mechanics/strain_and_stress.h>

#include <limits>

// The mixed formulation.

namespace Setsudan
{
using namespace dealii;

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
    result.push_back(determinant(deformation_gradient(gradient)));
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
        growth.push_back(
          scalar_product(cofactor(deformation_gradient((*before)[q])),
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
      const Tensor<2, 3> F          = deformation_gradient(gradients[q]);
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
      const Tensor<2, 3> F = deformation_gradient(gradients[q]);
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
      const Tensor<2, 3> F = deformation_gradient(gradients[q]);
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
    of_volume.push_back(cofactor(deformation_gradient(gradient)));
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



#define INSTANTIATE(dim)                                                     \
  template std::vector<MaterialResponse> LawIntegration<dim>::respond_mixed( \
    const DecoupledLaw &,                                                    \
    const Gradients &,                                                       \
    const Gradients *,                                                       \
    const bool,                                                              \
    std::vector<double> &) const;                                            \
  template std::vector<MaterialResponse> LawIntegration<dim>::respond_mixed( \
    const FiniteStrainLaw &,                                                 \
    const unsigned int,                                                      \
    const Gradients &,                                                       \
    const bool,                                                              \
    std::vector<double> &) const;                                            \
  template std::vector<MaterialResponse> LawIntegration<dim>::respond_mixed( \
    const SmallStrainLaw &,                                                  \
    const unsigned int,                                                      \
    const Gradients &,                                                       \
    std::vector<double> &) const;                                            \
  template void LawIntegration<dim>::add_volume_stiffness(                   \
    const Gradients &, const std::vector<double> &);

INSTANTIATE(2)
INSTANTIATE(3)

#undef INSTANTIATE
} // namespace Setsudan
