// SPDX-License-Identifier: LGPL-2.1-or-later
#include <setsudan/mechanics/strain_and_stress.h>

#include <cmath>
#include <limits>
#include <optional>

namespace Setsudan
{
using namespace dealii;

template <int dim>
SymmetricTensor<2, dim>
strain_of(const Material &material, const Tensor<2, dim> &gradient)
{
  if (material.law->hyperelastic() == nullptr &&
      material.law->finite_strain() == nullptr)
    return symmetrize(gradient);
  const Tensor<2, dim> F = gradient + unit_symmetric_tensor<dim>();
  SymmetricTensor<2, dim> strain;
  for (const auto &[square, direction] :
       eigenvectors(symmetrize(transpose(F) * F),
                    SymmetricTensorEigenvectorMethod::jacobi))
    strain +=
      (std::sqrt(square) - 1) * symmetrize(outer_product(direction, direction));
  return strain;
}



namespace
{
/** The Cauchy stress of a hyperelastic law.
 *
 * @param mean_stress of a mixed material. */
SymmetricTensor<2, 3>
cauchy_stress(const HyperelasticLaw &law,
              const Hooke &at_rest,
              const Tensor<2, 3> &gradient,
              const std::optional<double> &mean_stress)
{
  const Tensor<2, 3> F          = gradient + unit_symmetric_tensor<3>();
  const SymmetricTensor<2, 3> C = symmetrize(transpose(F) * F);
  const double J                = determinant(F);
  if (!(J > 0))
    return std::numeric_limits<double>::quiet_NaN() *
           unit_symmetric_tensor<3>();
  if (const auto form = law.neo_hooke(); form && !mean_stress)
    {
      // The same, without the tangent.
      const auto &[lambda, mu] = at_rest;
      const auto terms         = neo_hooke_terms<double>(
        *form,
        mu,
        form->is_isochoric ? lambda + 2. / 3 * mu : lambda,
        J,
        std::log(J),
        std::pow(J, -2. / 3),
        trace(C));
      return (terms.one * symmetrize(F * transpose(F)) +
              terms.inverse * unit_symmetric_tensor<3>()) /
             J;
    }
  const auto S = mean_stress ? law.decoupled()->distortion(C, false).stress
                             : law.at(C).stress;
  auto stress  = symmetrize(F * S * transpose(F)) / J;
  if (mean_stress)
    stress += *mean_stress * unit_symmetric_tensor<3>();
  return stress;
}
} // namespace


template <int dim>
SymmetricTensor<2, 3>
stress_of(const Material &material,
          const Tensor<2, dim> &gradient,
          const Point<dim> &position,
          const LinearFunction<dim> &of_cell)
{
  if (const auto *const law = material.law->hyperelastic())
    return cauchy_stress(*law,
                         material.at_rest,
                         in_space(gradient),
                         material.is_mixed ? of_cell(position)
                                           : std::optional<double>());
  if (const auto *const stiffness = material.law->anisotropic_stiffness())
    return *stiffness * symmetrize(in_space(gradient));
  const SymmetricTensor<2, dim> strain = symmetrize(gradient);
  return material.is_mixed ? material.at_rest.stress(strain, of_cell(position))
                           : material.at_rest.stress(strain);
}



#define INSTANTIATE(dim)                                              \
  template SymmetricTensor<2, dim> strain_of(const Material &,        \
                                             const Tensor<2, dim> &); \
  template SymmetricTensor<2, 3> stress_of(const Material &,          \
                                           const Tensor<2, dim> &,    \
                                           const Point<dim> &,        \
                                           const LinearFunction<dim> &);

INSTANTIATE(2)
INSTANTIATE(3)

#undef INSTANTIATE
} // namespace Setsudan
