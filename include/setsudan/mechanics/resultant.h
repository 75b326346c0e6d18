// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <setsudan/space/discretization.h>
#include <setsudan/space/rigid_modes.h>

#include <array>

namespace Setsudan
{
/** How far forces are from cancelling, relative to their sizes. */
struct Balance
{
  double force_residual  = 0;
  double moment_residual = 0;
};

/** The sum of forces and of their moments about the body's centre. */
template <int dim>
class Resultant
{
public:
  explicit Resultant(const Discretization<dim> &discretization);

  void
  add(const dealii::Point<dim> &point, const dealii::Tensor<1, dim> &force);

  /** Add the magnitudes of forces that are known to cancel. */
  void
  add_cancelling(const double magnitudes);

  /** Add what all processes have added; called once, by all of them. */
  void
  sum_over_processes();

  /** Resultant force and moment over the sum of all forces' magnitudes; the
   * moment's arms are measured in body lengths. */
  Balance
  relative() const;

private:
  const MPI_Comm communicator;
  dealii::Point<dim> center;
  double length = 0;
  /** The work of the forces in the rigid motions, which is their resultant;
   * behind it the sum of their magnitudes. */
  std::array<double, n_rigid_modes<dim> + 1> sums{};
};
} // namespace Setsudan
