// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <setsudan/output/output_directory.h>
#include <setsudan/output/tables/event.h>
#include <setsudan/output/tables/statistics_columns.h>

#include <chrono>
#include <string>
#include <vector>

namespace Setsudan
{
/** The table statistics.csv, which is rewritten as a whole, at most ten times a
 * second. */
class Statistics
{
public:
  /** @param units what stands for L and F in the columns' units. */
  Statistics(const OutputParameters::Units units,
             const std::string &length_unit,
             const std::string &force_unit);

  void
  add(const Event &event, const OutputDirectory &directory);

  /** Write what has not been written yet. */
  void
  finish(const OutputDirectory &directory);

  /** All lines so far. */
  std::string table;

private:
  /** The names of the columns, with their units as they were asked for. */
  std::string
  header() const;

  std::vector<StatisticsColumn> columns;
  const OutputParameters::Units units;
  const std::string length_unit;
  const std::string force_unit;

  using Clock = std::chrono::steady_clock;

  bool is_written = true;
  Clock::time_point last_written;
};
} // namespace Setsudan
