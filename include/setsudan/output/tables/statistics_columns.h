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

/** All columns, in their order.
 *
 * @param has_errors whether errors are estimated, which have columns then.
 * @param travels    whether the blade travels, which has columns too. */
std::vector<StatisticsColumn>
statistics_columns(const bool has_errors, const bool travels);

/** Write what the columns mean as a table in Markdown. */
void
document_columns(std::ostream &out);
} // namespace Setsudan
