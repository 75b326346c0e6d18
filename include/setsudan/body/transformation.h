// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <deal.II/base/point.h>
#include <deal.II/base/tensor.h>

#include <setsudan/body/body.h>
#include <setsudan/parameters/parameters.h>

namespace Setsudan
{
/** How a body is brought to its place: scaled, then rotated about the origin,
 * then moved. */
template <int dim>
struct Transformation
{
  /** The matrix of scaling and rotation. */
  dealii::Tensor<2, dim> matrix;
  dealii::Tensor<1, dim> translation;

  static void
  declare(dealii::ParameterHandler &handler);

  explicit Transformation(const Parameters &parameters);

  void
  apply(Body<dim> &body) const;
};
} // namespace Setsudan
