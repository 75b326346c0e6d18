// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <functional>
#include <stdexcept>
#include <string>

namespace Setsudan
{
/** A child process has ended without a result. */
class ChildFailure : public std::runtime_error
{
public:
  enum class Reason
  {
    exit,
    signal,
    time_limit
  };

  ChildFailure(const Reason reason, const int signal_number = 0);

  const Reason reason;
  /** Where a signal has ended it. */
  const int signal_number;
};

/**
 * Let a child process do some work, which may call exit(), crash or never end,
 * and hand its result back. The child has no input, says nothing, and ends with
 * its parent. It must not use MPI.
 *
 * @param time_limit in seconds.
 * @throw ChildFailure where the child ends before the work has.
 * @throw std::runtime_error, std::bad_alloc where the work does.
 */
std::string
run_in_child(const std::function<std::string()> &work, const double time_limit);
} // namespace Setsudan
