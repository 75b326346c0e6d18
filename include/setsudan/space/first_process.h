// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <deal.II/base/mpi.h>

namespace Setsudan
{
/** What the first process finds, on all processes: where round-off decides, all
 * must decide alike. Collective.
 *
 * @param find is called on the first process; its result is one that
 *   boost::serialization knows. */
template <typename Find>
auto
of_first_process(const MPI_Comm communicator, const Find &find)
  -> decltype(find())
{
  using namespace dealii::Utilities::MPI;
  if (n_mpi_processes(communicator) == 1)
    return find();
  return broadcast(communicator,
                   this_mpi_process(communicator) == 0 ? find()
                                                       : decltype(find())());
}
} // namespace Setsudan
