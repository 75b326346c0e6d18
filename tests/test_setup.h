// SPDX-License-Identifier: LGPL-2.1-or-later
// What every unit test begins with: MPI, a fixed number format, and failures
// that are printed where numdiff sees them.
#pragma once

#include <deal.II/base/mpi.h>
#include <deal.II/base/multithread_info.h>

#include <exception>
#include <functional>
#include <iomanip>
#include <iostream>
#include <string>

/** Run `test` under MPI; print what it throws, and return the exit status. */
inline int
run_test(int argc, char **argv, const std::function<void()> &test)
{
  dealii::Utilities::MPI::MPI_InitFinalize mpi(argc, argv, 1);
  std::cout << std::setprecision(6);
  try
    {
      test();
    }
  catch (const std::exception &exception)
    {
      std::cout << "FAILED: " << exception.what() << std::endl;
      return 1;
    }
  return 0;
}

/** Whether this process is the one that prints. */
inline bool
is_first_process()
{
  return dealii::Utilities::MPI::this_mpi_process(MPI_COMM_WORLD) == 0;
}

/** Print a line, by the first process. */
inline void
say(const std::string &line)
{
  if (is_first_process())
    std::cout << line << std::endl;
}

/** Print `name`, and whether `error` is below `tolerance`; the value itself is
 * printed only where it is not, so that round-off does not matter. */
inline void
check_below(const std::string &name, const double error, const double tolerance)
{
  std::cout << name << ": ";
  if (error <= tolerance)
    std::cout << "below " << tolerance << std::endl;
  else
    std::cout << "FAILED, " << error << " exceeds " << tolerance << std::endl;
}

/** check_below() of the largest error of all processes; the first one prints
 * it. */
inline void
check_below_on_all(const std::string &name,
                   const double error,
                   const double tolerance = 1e-12)
{
  const double largest = dealii::Utilities::MPI::max(error, MPI_COMM_WORLD);
  if (is_first_process())
    check_below(name, largest, tolerance);
}
