// SPDX-License-Identifier: LGPL-2.1-or-later
// A directory that cannot be written is refused, by all processes alike.

#include <setsudan/output/output_directory.h>

#include <deal.II/base/mpi.h>

#include <filesystem>
#include <fstream>
#include <string>

#include "../test_setup.h"

using namespace Setsudan;
using namespace dealii;

void
test(const std::string &path)
{
  unsigned int n_refusing = 0;
  std::string message;
  try
    {
      OutputDirectory directory(path, MPI_COMM_WORLD);
    }
  catch (const SceneError &error)
    {
      n_refusing = 1;
      message    = error.what();
    }
  n_refusing = Utilities::MPI::sum(n_refusing, MPI_COMM_WORLD);
  if (!is_first_process())
    return;
  const bool all =
    n_refusing == Utilities::MPI::n_mpi_processes(MPI_COMM_WORLD);
  std::cout << "'" << path << "' is refused by "
            << (all ? "all" : "FAILED, not all") << std::endl
            << message << std::endl;
}


int
main(int argc, char **argv)
{
  return run_test(argc, argv, [] {
    if (is_first_process())
      std::ofstream("a_file") << "in the way";
    MPI_Barrier(MPI_COMM_WORLD);
    test("a_file");
    test("a_file/below/it");
    test("/proc/nowhere");
  });
}
