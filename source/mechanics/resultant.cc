// SPDX-License-Identifier: LGPL-2.1-or-later
#include <deal.II/base/mpi.h>
#include <deal.II/grid/grid_tools.h>

#include <setsudan/mechanics/resultant.h>

#include <algorithm>
#include <cmath>

namespace Setsudan
{
using namespace dealii;

template <int dim>
Resultant<dim>::Resultant(const Discretization<dim> &discretization)
  : communicator(discretization.communicator)
{
  // Every process holds all cells of the coarse mesh, and so all corners.
  const auto box =
    GridTools::compute_bounding_box(discretization.triangulation);
  center = box.center();
  for (unsigned int d = 0; d < dim; ++d)
    length = std::max(length, box.side_length(d));
}



template <int dim>
void
Resultant<dim>::add(const Point<dim> &point, const Tensor<1, dim> &force)
{
  const auto modes = rigid_modes(point, center, length);
  for (unsigned int m = 0; m < modes.size(); ++m)
    sums[m] += modes[m] * force;
  sums.back() += force.norm();
}



template <int dim>
void
Resultant<dim>::add_cancelling(const double magnitudes)
{
  sums.back() += magnitudes;
}



template <int dim>
void
Resultant<dim>::sum_over_processes()
{
  const auto own = sums;
  Utilities::MPI::sum(ArrayView<const double>(own.data(), own.size()),
                      communicator,
                      ArrayView<double>(sums.data(), sums.size()));
}



template <int dim>
Balance
Resultant<dim>::relative() const
{
  Balance balance;
  if (sums.back() > 0)
    for (unsigned int m = 0; m < n_rigid_modes<dim>; ++m)
      {
        double &residual =
          m < dim ? balance.force_residual : balance.moment_residual;
        residual = std::max(residual, std::abs(sums[m]) / sums.back());
      }
  return balance;
}



template class Resultant<2>;
template class Resultant<3>;
} // namespace Setsudan
