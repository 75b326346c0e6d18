// SPDX-License-Identifier: LGPL-2.1-or-later
#include <setsudan/material/cut_limit.h>

namespace Setsudan
{
using namespace dealii;

CutLimit::CutLimit(const double limit)
  : tensor(limit * unit_symmetric_tensor<3>())
  , is_isotropic(true)
{
}



CutLimit::CutLimit(const std::array<double, 3> &limits,
                   const MaterialAxes &axes)
  : is_isotropic(false)
{
  for (unsigned int i = 0; i < 3; ++i)
    tensor += limits[i] * symmetrize(outer_product(axes[i], axes[i]));
}



template <int dim>
double
CutLimit::across(const Tensor<1, dim> &normal) const
{
  // Without the round-off of a normal's length.
  if (is_isotropic)
    return tensor[0][0];
  double result = 0;
  for (unsigned int i = 0; i < dim; ++i)
    for (unsigned int j = 0; j < dim; ++j)
      result += normal[i] * tensor[i][j] * normal[j];
  return result;
}



double
CutLimit::smallest(const unsigned int dim) const
{
  if (is_isotropic)
    return tensor[0][0];
  if (dim == 3)
    return eigenvalues(tensor)[2];
  SymmetricTensor<2, 2> in_plane;
  for (unsigned int i = 0; i < 2; ++i)
    for (unsigned int j = 0; j <= i; ++j)
      in_plane[i][j] = tensor[i][j];
  return eigenvalues(in_plane)[1];
}



void
CutLimit::add(const double factor, const CutLimit &other)
{
  tensor += factor * other.tensor;
  is_isotropic = is_isotropic && other.is_isotropic;
}



template double
CutLimit::across(const Tensor<1, 2> &) const;
template double
CutLimit::across(const Tensor<1, 3> &) const;
} // namespace Setsudan
