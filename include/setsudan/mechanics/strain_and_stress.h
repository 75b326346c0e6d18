// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <setsudan/material/material_parameters.h>
#include <setsudan/mechanics/linear_fit.h>

namespace Setsudan
{
/** A displacement gradient in space; the strain of a body in 2D is plane. */
template <int dim>
dealii::Tensor<2, 3>
in_space(const dealii::Tensor<2, dim> &gradient)
{
  dealii::Tensor<2, 3> result;
  for (unsigned int i = 0; i < dim; ++i)
    for (unsigned int j = 0; j < dim; ++j)
      result[i][j] = gradient[i][j];
  return result;
}

/** F = 1 + grad u. */
inline dealii::Tensor<2, 3>
deformation_gradient(const dealii::Tensor<2, 3> &gradient)
{
  return gradient + dealii::unit_symmetric_tensor<3>();
}

/** The strain at a point: small, or with finite strain U - 1, where F = R U
 * (Biot), whose principal values are those of elongations. */
template <int dim>
dealii::SymmetricTensor<2, dim>
strain_of(const Material &material, const dealii::Tensor<2, dim> &gradient);

/** The Cauchy stress at a point of a cell.
 *
 * @param of_cell what Dilatation says of it, for a material that is mixed. */
template <int dim>
dealii::SymmetricTensor<2, 3>
stress_of(const Material &material,
          const dealii::Tensor<2, dim> &gradient,
          const dealii::Point<dim> &position,
          const LinearFunction<dim> &of_cell);
} // namespace Setsudan
