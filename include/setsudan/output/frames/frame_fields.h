// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <deal.II/base/point.h>
#include <deal.II/base/symmetric_tensor.h>

#include <setsudan/output/frames/vtu.h>

#include <array>
#include <vector>

namespace Setsudan
{
/** The fields that a frame shows at its points; points are set one by one. */
template <int dim>
class FrameFields
{
public:
  explicit FrameFields(const unsigned int n_points);

  void
  set(const unsigned int point,
      const dealii::Point<dim> &position,
      const dealii::Tensor<1, dim> &displacement,
      const dealii::SymmetricTensor<2, dim> &strain,
      const dealii::SymmetricTensor<2, 3> &stress);

  /** Hand the fields over to a grid, and the positions in the precision that
   * they need: @param double_points says whether that is double. */
  void
  move_into(VtuGrid &grid, const bool double_points);

private:
  std::vector<double> positions;
  std::vector<float> displacements, stresses, strains, principal_stresses,
    maximum_shears, von_mises;
};
} // namespace Setsudan
