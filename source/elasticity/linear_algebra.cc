#include <setsudan/elasticity/linear_algebra.h>

namespace Setsudan
{
using namespace dealii;

LA::Vector
condense(const AffineConstraints<double> &constraints, const LA::Vector &forces)
{
  LA::Vector condensed(forces.locally_owned_elements(),
                       forces.get_mpi_communicator());
  for (const auto index : forces.locally_owned_elements())
    if (forces(index) != 0)
      constraints.distribute_local_to_global(index, forces(index), condensed);
  condensed.compress(VectorOperation::add);
  return condensed;
}
} // namespace Setsudan
