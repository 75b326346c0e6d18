// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <setsudan/output/tables/event.h>

#include <functional>
#include <iosfwd>
#include <string>
#include <vector>

namespace Setsudan
{
/** A column of statistics.csv. */
struct StatisticsColumn
{
  std::string name;
  /** In L and F, which stand for the scene's units of length and force; s is
   * seconds, and - a number without unit. */
  std::string unit;
  std::string meaning;
  std::function<std::string(const Event &)> text;
};

/** All columns of a run with events like this one, in their order: estimated
 * errors, a blade that travels and a board have columns where they are. */
std::vector<StatisticsColumn>
statistics_columns(const Event &event);

/** Write what the columns mean as a table in Markdown. */
void
document_columns(std::ostream &out);
} // namespace Setsudan
