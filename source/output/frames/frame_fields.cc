// SPDX-License-Identifier: LGPL-2.1-or-later
#include <setsudan/output/frames/frame_fields.h>

#include <algorithm>
#include <cmath>

namespace Setsudan
{
using namespace dealii;

template <int dim>
FrameFields<dim>::FrameFields(const unsigned int n_points)
  : positions(3 * n_points)
  , displacements(3 * n_points)
  , stresses(6 * n_points)
  , strains(6 * n_points)
  , principal_stresses(3 * n_points)
  , maximum_shears(n_points)
  , von_mises(n_points)
{
}

namespace
{
/** Write a symmetric tensor's components in VTK's order. */
template <int dim>
void
write_components(const SymmetricTensor<2, dim> &tensor, float *const components)
{
  constexpr unsigned int order[6][2] = {
    {0, 0}, {1, 1}, {2, 2}, {0, 1}, {1, 2}, {0, 2}};
  for (unsigned int i = 0; i < 6; ++i)
    if (order[i][0] < dim && order[i][1] < dim)
      components[i] = tensor[order[i][0]][order[i][1]];
}
} // namespace



template <int dim>
void
FrameFields<dim>::set(const unsigned int point,
                      const Point<dim> &position,
                      const Tensor<1, dim> &displacement,
                      const SymmetricTensor<2, dim> &strain,
                      const SymmetricTensor<2, 3> &stress)
{
  for (unsigned int c = 0; c < dim; ++c)
    {
      positions[3 * point + c]     = position[c];
      displacements[3 * point + c] = displacement[c];
    }
  write_components(strain, &strains[6 * point]);
  write_components(stress, &stresses[6 * point]);
  // Up to the digits that a frame has, in a fraction of the time that
  // maximum_shear() takes.
  const auto principal = eigenvalues(stress);
  std::copy(principal.begin(), principal.end(), &principal_stresses[3 * point]);
  maximum_shears[point] = (principal[0] - principal[2]) / 2;
  von_mises[point]      = std::sqrt(1.5) * deviator(stress).norm();
}



template <int dim>
void
FrameFields<dim>::move_into(VtuGrid &grid, const bool double_points)
{
  if (double_points)
    grid.points = std::move(positions);
  else
    grid.points = std::vector<float>(positions.begin(), positions.end());
  grid.point_data = {
    {"displacement", 3, std::move(displacements), {"X", "Y", "Z"}},
    {"stress", 6, std::move(stresses), symmetric_components},
    {"strain", 6, std::move(strains), symmetric_components},
    {"principal_stress", 3, std::move(principal_stresses), {"1", "2", "3"}},
    {"maximum_shear", 1, std::move(maximum_shears)},
    {"von_Mises", 1, std::move(von_mises)}};
}



template class FrameFields<2>;
template class FrameFields<3>;
} // namespace Setsudan
