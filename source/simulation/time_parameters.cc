// SPDX-License-Identifier: LGPL-2.1-or-later
#include <setsudan/parameters/lists.h>
#include <setsudan/simulation/time_parameters.h>

#include <algorithm>
#include <cmath>

namespace Setsudan
{
using namespace dealii;

void
TimeParameters::declare(ParameterHandler &handler)
{
  Setsudan::declare(
    handler,
    "Time",
    "Steps",
    "",
    Patterns::Anything(),
    "'duration : number of steps', several separated by ';', as "
    "in '1 : 20; 100 : 10': how long loads and supports act "
    "before the blade comes. Empty: no time passes "
    "[time] : [-].");
  Setsudan::declare(handler,
                    "Time",
                    "Load factor",
                    "",
                    Patterns::Anything(),
                    "'time : factor', several separated by ';', as in '0 : 0; "
                    "1 : 1': what all of subsection Load and "
                    "Support/Displacements are multiplied with meanwhile, "
                    "linear between these and constant behind them. Empty: 1 "
                    "[time] : [-].");
  Setsudan::declare(handler,
                    "Time",
                    "Tolerance",
                    "0",
                    Patterns::Double(),
                    "With it steps are chosen by the program, and those of "
                    "Time/Steps are the longest: each is made a second time in "
                    "two halves, and shortened until the displacements of both "
                    "differ by this part of the largest one at most. 0: steps "
                    "as they are given [-].");
}



namespace
{
/** Pairs 'first : second', separated by ';'. */
std::vector<std::pair<double, double>>
read_table(const Parameters &parameters,
           const std::string &name,
           const std::string &allowed)
{
  std::vector<std::pair<double, double>> table;
  for (const auto &[before, behind] :
       split_items(parameters.text("Time", name), ';'))
    {
      std::vector<double> first, second;
      parameters.require(parse_numbers(before, first) && first.size() == 1 &&
                           parse_numbers(behind, second) && second.size() == 1,
                         "Time",
                         name,
                         allowed);
      table.emplace_back(first[0], second[0]);
    }
  return table;
}
} // namespace


TimeParameters::TimeParameters(const Parameters &parameters)
  : tolerance(parameters.number("Time", "Tolerance"))
{
  const std::string steps = "'duration : number of steps', separated by ';', "
                            "with durations greater than 0 and whole numbers "
                            "of steps, at least 1";
  constexpr double most_steps = 1e6;
  for (const auto &[duration, n] : read_table(parameters, "Steps", steps))
    {
      parameters.require(duration > 0 && n >= 1 && n <= most_steps &&
                           n == std::floor(n),
                         "Time",
                         "Steps",
                         steps);
      spans.push_back({duration, static_cast<unsigned int>(n)});
    }
  const std::string factors = "'time : factor', separated by ';', with times "
                              "that ascend from 0";
  load_factors              = read_table(parameters, "Load factor", factors);
  for (unsigned int i = 0; i < load_factors.size(); ++i)
    parameters.require(i == 0
                         ? load_factors[i].first == 0
                         : load_factors[i].first > load_factors[i - 1].first,
                       "Time",
                       "Load factor",
                       factors);
  parameters.require(tolerance >= 0 && tolerance < 1,
                     "Time",
                     "Tolerance",
                     "a number that is not negative and less than 1");
  for (const auto &[given, name] :
       {std::make_pair(!load_factors.empty(), "Load factor"),
        std::make_pair(tolerance > 0, "Tolerance")})
    parameters.require(
      passes() || !given,
      "Time",
      name,
      std::string(tolerance > 0 && name[0] == 'T' ? "0" : "nothing") +
        " where Time/Steps is empty");
}



double
TimeParameters::load_factor(const double time) const
{
  if (load_factors.empty())
    return 1;
  const auto next = std::upper_bound(
    load_factors.begin(),
    load_factors.end(),
    time,
    [](const double t, const auto &entry) { return t < entry.first; });
  const auto &[begin, at_begin] = *(next - 1);
  if (next == load_factors.end())
    return at_begin;
  return at_begin +
         (next->second - at_begin) * (time - begin) / (next->first - begin);
}



double
TimeParameters::duration() const
{
  double sum = 0;
  for (const auto &span : spans)
    sum += span.duration;
  return sum;
}
} // namespace Setsudan
