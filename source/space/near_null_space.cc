// SPDX-License-Identifier: LGPL-2.1-or-later
#include <setsudan/space/near_null_space.h>
#include <setsudan/space/rigid_modes.h>

namespace Setsudan
{
using namespace dealii;

template <int dim>
std::vector<std::vector<double>>
rigid_modes_at(
  const std::vector<typename Discretization<dim>::DofLocation> &dof_locations)
{
  std::vector<std::vector<double>> modes(
    n_rigid_modes<dim>, std::vector<double>(dof_locations.size()));
  for (unsigned int i = 0; i < dof_locations.size(); ++i)
    {
      const auto motions =
        rigid_modes(dof_locations[i].position, Point<dim>(), 1.);
      for (unsigned int m = 0; m < modes.size(); ++m)
        modes[m][i] = motions[m][dof_locations[i].component];
    }
  return modes;
}



template std::vector<std::vector<double>>
rigid_modes_at<2>(const std::vector<Discretization<2>::DofLocation> &);
template std::vector<std::vector<double>>
rigid_modes_at<3>(const std::vector<Discretization<3>::DofLocation> &);
} // namespace Setsudan
