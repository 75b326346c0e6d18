// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <functional>
#include <stdexcept>
#include <string>

namespace Setsudan
{
/** A child process has ended without a result. The message tells why where that
 * was an exception. */
class ChildFailure : public std::runtime_error
{
public:
  enum class Reason
  {
    exception,
    exit,
    signal,
    time_limit
  };

  explicit ChildFailure(
    const Reason reason,
    const int signal_number    = 0,
    const std::string &message = "a child process has ended without a result");

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
 * @throw ChildFailure where the child ends before the work has, or the work
 * throws anything but std::bad_alloc.
 * @throw std::bad_alloc where the work does.
 * @throw std::runtime_error where no child can be started.
 */
std::string
run_in_child(const std::function<std::string()> &work, const double time_limit);
} // namespace Setsudan
