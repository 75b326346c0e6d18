// SPDX-License-Identifier: LGPL-2.1-or-later
#include <deal.II/base/mpi.h>

#include <setsudan/solver/condensed/unknown_forces.h>

namespace Setsudan
{
using namespace dealii;

LA::Vector
vector_of(const UnknownForces &forces, LA::Vector vector)
{
  for (const auto &[unknown, force] : forces)
    if (vector.in_local_range(unknown))
      vector(unknown) += force;
  vector.compress(VectorOperation::add);
  return vector;
}



std::vector<double>
work_of(const std::vector<UnknownForces> &forces,
        const LA::Vector &displacement)
{
  std::vector<double> work(forces.size(), 0.);
  for (unsigned int i = 0; i < forces.size(); ++i)
    for (const auto &[unknown, force] : forces[i])
      if (displacement.in_local_range(unknown))
        work[i] += force * displacement(unknown);
  Utilities::MPI::sum(work, displacement.get_mpi_communicator(), work);
  return work;
}



LA::Vector
spring_forces(const std::vector<UnknownForces> &springs,
              const LA::Vector &displacement)
{
  LA::Vector forces  = displacement;
  forces             = 0;
  const auto lengths = work_of(springs, displacement);
  for (unsigned int i = 0; i < springs.size(); ++i)
    for (const auto &[unknown, factor] : springs[i])
      if (forces.in_local_range(unknown))
        forces(unknown) += factor * lengths[i];
  forces.compress(VectorOperation::add);
  return forces;
}
} // namespace Setsudan
