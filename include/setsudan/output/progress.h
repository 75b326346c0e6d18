// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <mpi.h>

#include <chrono>
#include <string>

namespace Setsudan
{
/**
 * What a run says on standard output, by the first process: lines that stay,
 * and one that shows where a cut stands. On a terminal that one is rewritten
 * in place; elsewhere it becomes a line for each row.
 */
class Progress
{
public:
  explicit Progress(const MPI_Comm communicator);

  ~Progress();

  /** A line that stays. */
  void
  info(const std::string &line);

  /** A line that stays and stands out. */
  void
  warn(const std::string &line);

  /** Where a cut stands, replacing the last such line on a terminal. */
  void
  show(const std::string &line);

  /** Seconds since the start. */
  double
  seconds() const;

  /** Count the seconds that the run took before it was resumed as well. */
  void
  continue_from(const double seconds);

  /** The time left after `done` of `all` equal parts since `begin`. */
  std::string
  time_left(const double begin,
            const unsigned int done,
            const unsigned int all) const;

private:
  void
  finish_shown_line();

  const std::chrono::steady_clock::time_point start;
  const bool speaks;
  const bool on_terminal;
  double seconds_before   = 0;
  std::size_t shown_width = 0;
};
} // namespace Setsudan
