// SPDX-License-Identifier: LGPL-2.1-or-later
#include <setsudan/material/material.h>

namespace Setsudan
{
using namespace dealii;

Hooke::Hooke(const double youngs_modulus, const double poissons_ratio)
  : lambda(youngs_modulus * poissons_ratio /
           ((1 + poissons_ratio) * (1 - 2 * poissons_ratio)))
  , mu(youngs_modulus / (2 * (1 + poissons_ratio)))
{
}



template <int dim>
SymmetricTensor<2, 3>
Hooke::stress(const SymmetricTensor<2, dim> &strain) const
{
  return stress(strain, trace(strain));
}



template <int dim>
SymmetricTensor<2, 3>
Hooke::stress(const SymmetricTensor<2, dim> &strain,
              const double dilatation) const
{
  SymmetricTensor<2, 3> stress;
  for (unsigned int i = 0; i < dim; ++i)
    for (unsigned int j = i; j < dim; ++j)
      stress[i][j] = 2 * mu * strain[i][j];
  for (unsigned int i = 0; i < 3; ++i)
    stress[i][i] += lambda * dilatation;
  return stress;
}



double
maximum_shear(const SymmetricTensor<2, 3> &stress)
{
  // The closed form of eigenvalues() loses half of the digits where two of them
  // are equal, as in any uniaxial stress.
  const auto principal =
    eigenvectors(stress, SymmetricTensorEigenvectorMethod::jacobi);
  return (principal[0].first - principal[2].first) / 2;
}



template SymmetricTensor<2, 3>
Hooke::stress(const SymmetricTensor<2, 2> &) const;
template SymmetricTensor<2, 3>
Hooke::stress(const SymmetricTensor<2, 3> &) const;
template SymmetricTensor<2, 3>
Hooke::stress(const SymmetricTensor<2, 2> &, const double) const;
template SymmetricTensor<2, 3>
Hooke::stress(const SymmetricTensor<2, 3> &, const double) const;
} // namespace Setsudan
