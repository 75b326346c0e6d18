// SPDX-License-Identifier: LGPL-2.1-or-later
#include <deal.II/base/utilities.h>

#include <setsudan/parameters/lists.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <cstdlib>

namespace Setsudan
{
using namespace dealii;

std::string
short_text(const double value)
{
  char buffer[32];
  for (const int precision : {6, 15, 17})
    {
      std::snprintf(buffer, sizeof(buffer), "%.*g", precision, value);
      if (std::strtod(buffer, nullptr) == value)
        break;
    }
  return buffer;
}



std::vector<std::string>
split(const std::string &text, const char delimiter)
{
  std::vector<std::string> parts;
  for (const auto &part : Utilities::split_string_list(text, delimiter))
    if (!Utilities::trim(part).empty())
      parts.push_back(Utilities::trim(part));
  return parts;
}



std::vector<std::pair<std::string, std::string>>
split_items(const std::string &text, const char delimiter)
{
  std::vector<std::pair<std::string, std::string>> items;
  for (const auto &item : split(text, delimiter))
    {
      const auto colon = item.find(':');
      items.emplace_back(Utilities::trim(item.substr(0, colon)),
                         colon == std::string::npos
                           ? ""
                           : Utilities::trim(item.substr(colon + 1)));
    }
  return items;
}



bool
parse_numbers(const std::string &text, std::vector<double> &values)
{
  values.clear();
  for (const auto &part : split(text, ','))
    try
      {
        values.push_back(Utilities::string_to_double(part));
      }
    catch (const std::exception &)
      {
        return false;
      }
  return std::all_of(values.begin(), values.end(), [](const double value) {
    return std::isfinite(value);
  });
}
} // namespace Setsudan
