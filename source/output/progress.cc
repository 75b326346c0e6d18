// SPDX-License-Identifier: LGPL-2.1-or-later
#include <deal.II/base/mpi.h>

#include <setsudan/output/progress.h>

#include <cstdio>
#include <cstdlib>
#include <iostream>

#include <unistd.h>

namespace Setsudan
{
using namespace dealii;

// mpirun puts a terminal of its own between the program and a file.
Progress::Progress(const MPI_Comm communicator)
  : start(std::chrono::steady_clock::now())
  , speaks(Utilities::MPI::this_mpi_process(communicator) == 0)
  , on_terminal(isatty(STDOUT_FILENO) == 1 &&
                std::getenv("OMPI_COMM_WORLD_SIZE") == nullptr)
{
}



Progress::~Progress()
{
  finish_shown_line();
}



void
Progress::finish_shown_line()
{
  if (shown_width > 0)
    std::cout << std::endl;
  shown_width = 0;
}



void
Progress::info(const std::string &line)
{
  if (!speaks)
    return;
  finish_shown_line();
  std::cout << line << std::endl;
}



void
Progress::warn(const std::string &line)
{
  info("Warning: " + line);
}



void
Progress::show(const std::string &line)
{
  if (!speaks)
    return;
  if (!on_terminal)
    {
      std::cout << line << std::endl;
      return;
    }
  // Blanks cover what a longer line before has left.
  const std::size_t blanks =
    shown_width > line.size() ? shown_width - line.size() : 0;
  std::cout << '\r' << line << std::string(blanks, ' ') << std::flush;
  shown_width = line.size();
}



double
Progress::seconds() const
{
  return seconds_before +
         std::chrono::duration<double>(std::chrono::steady_clock::now() - start)
           .count();
}



void
Progress::continue_from(const double seconds)
{
  seconds_before = seconds;
}



std::string
Progress::time_left(const double begin,
                    const unsigned int done,
                    const unsigned int all) const
{
  const double left = (seconds() - begin) / done * (all - done);
  char text[32];
  if (left < 60)
    std::snprintf(text, sizeof(text), "%.1f s left", left);
  else
    std::snprintf(text, sizeof(text), "%.0f min left", left / 60);
  return text;
}
} // namespace Setsudan
