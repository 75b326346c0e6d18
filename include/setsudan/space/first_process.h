// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <deal.II/base/mpi.h>

#include <setsudan/parameters/exceptions.h>

#include <boost/serialization/string.hpp>
#include <boost/serialization/utility.hpp>

#include <string>
#include <utility>

namespace Setsudan
{
/** What the first process finds, on all processes: where round-off decides, all
 * must decide alike. Collective.
 *
 * @param find is called on the first process; its result is one that
 *   boost::serialization knows.
 * @throw SolverError, NotDefiniteError on all processes, where it does. */
template <typename Find>
auto
of_first_process(const MPI_Comm communicator, const Find &find)
  -> decltype(find())
{
  using namespace dealii::Utilities::MPI;
  if (n_mpi_processes(communicator) == 1)
    return find();
  enum Outcome
  {
    found,
    failed,
    not_definite
  };
  std::pair<std::pair<int, std::string>, decltype(find())> all;
  auto &[outcome, result] = all;
  if (this_mpi_process(communicator) == 0)
    try
      {
        result = find();
      }
    catch (const NotDefiniteError &error)
      {
        outcome = {not_definite, error.what()};
      }
    catch (const SolverError &error)
      {
        outcome = {failed, error.what()};
      }
  all = broadcast(communicator, all);
  if (outcome.first == not_definite)
    throw NotDefiniteError(outcome.second);
  if (outcome.first == failed)
    throw SolverError(outcome.second);
  return std::move(result);
}
} // namespace Setsudan
