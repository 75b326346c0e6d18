// SPDX-License-Identifier: LGPL-2.1-or-later
#include <deal.II/base/mpi.h>

#include <setsudan/space/linear_algebra.h>

namespace Setsudan
{
using namespace dealii;

void
distribute(const AffineConstraints<double> &constraints, LA::Vector &vector)
{
  if (Utilities::MPI::n_mpi_processes(vector.get_mpi_communicator()) > 1)
    {
      constraints.distribute(vector);
      return;
    }
  double *const entries = vector.trilinos_vector()[0];
  for (const auto &line : constraints.get_lines())
    {
      double value = line.inhomogeneity;
      for (const auto &[index, weight] : line.entries)
        value += weight * entries[index];
      entries[line.index] = value;
    }
}



LA::Vector
condense(const AffineConstraints<double> &constraints, const LA::Vector &forces)
{
  LA::Vector condensed       = forces;
  condensed                  = 0;
  const auto [begin, end]    = forces.local_range();
  const double *const values = forces.trilinos_vector()[0];
  for (auto index = begin; index < end; ++index)
    if (const double force = values[index - begin]; force != 0)
      constraints.distribute_local_to_global(index, force, condensed);
  condensed.compress(VectorOperation::add);
  return condensed;
}
} // namespace Setsudan
