// SPDX-License-Identifier: LGPL-2.1-or-later
#include <setsudan/output/tables/statistics.h>
#include <setsudan/output/tables/statistics_columns.h>

#include <ostream>

namespace Setsudan
{
using Units = OutputParameters::Units;

Statistics::Statistics(const Units units,
                       const std::string &length_unit,
                       const std::string &force_unit)
  : units(units)
  , length_unit(length_unit)
  , force_unit(force_unit)
{
}



std::string
Statistics::header() const
{
  std::string names, list;
  for (const auto &column : columns)
    {
      const std::string separator = names.empty() ? "" : ",";
      names += separator + column.name;
      list += separator;
      for (const char c : column.unit)
        list += c == 'L'   ? length_unit
                : c == 'F' ? force_unit
                           : std::string(1, c);
    }
  return (units == Units::comment ? "# units: " + list + "\n" : "") + names +
         "\n" + (units == Units::row ? list + "\n" : "");
}



void
Statistics::add(const Event &event, const OutputDirectory &directory)
{
  // They do not change within a run, whose rows may take a millisecond each.
  if (columns.empty())
    columns = statistics_columns(event);
  if (table.empty())
    table = header();
  std::string line;
  for (const auto &column : columns)
    line += (line.empty() ? "" : ",") + column.text(event);
  table += line + "\n";
  is_written = false;
  // Where rows are fast, to write the table would take longer than they do.
  if (Clock::now() - last_written >= std::chrono::milliseconds(100))
    finish(directory);
}



void
Statistics::finish(const OutputDirectory &directory)
{
  if (is_written)
    return;
  directory.write("statistics.csv", [&](std::ostream &out) { out << table; });
  is_written   = true;
  last_written = Clock::now();
}
} // namespace Setsudan
