// SPDX-License-Identifier: LGPL-2.1-or-later
#include <setsudan/blade/blade_path.h>
#include <setsudan/parameters/lists.h>

#include <algorithm>
#include <cmath>

namespace Setsudan
{
using namespace dealii;

void
BladePath::declare(ParameterHandler &handler)
{
  Setsudan::declare(
    handler,
    "Blade",
    "Speed",
    "0",
    Patterns::Double(),
    "Of a blade that travels, which gives its way a time, or of the front of a "
    "cut through a viscous body under given forces; 0 if it is not known "
    "[length/time].");
  Setsudan::declare(
    handler,
    "Blade",
    "Travel",
    "",
    Patterns::Anything(),
    "Where the edge goes in each cut, along Direction from the entry: "
    "positions "
    "separated by commas, at each of which a state is recorded, as in '0.1, "
    "0.3, 0', which withdraws it in the end; or 'time : position', with times "
    "that ascend from '0 : 0', which give each way its speed. Empty: it is "
    "pushed until the cut is through [length] or [time : length].");
}



BladePath::BladePath(const Parameters &parameters, const bool travels)
  : speed(parameters.number("Blade", "Speed"))
{
  parameters.require(
    speed >= 0, "Blade", "Speed", "a number that is not negative");
  const std::string text = parameters.text("Blade", "Travel");
  if (text.empty())
    return;
  parameters.require(
    travels, "Blade", "Travel", "nothing where Blade/Drive is force");
  read_stops(parameters);
  check_stops(parameters);
}



void
BladePath::read_stops(const Parameters &parameters)
{
  const std::string text = parameters.text("Blade", "Travel");
  const bool is_table    = text.find(':') != std::string::npos;
  const auto require     = [&](const bool holds, const std::string &allowed) {
    parameters.require(holds, "Blade", "Travel", allowed);
  };
  double time = 0;
  for (const auto &[first, second] : split_items(text, ','))
    {
      std::vector<double> t, p;
      require(parse_numbers(is_table ? second : first, p) && p.size() == 1 &&
                (is_table ? parse_numbers(first, t) && t.size() == 1
                          : second.empty()),
              "either positions, or 'time : position' throughout, separated "
              "by commas");
      if (is_table && stops.empty())
        require(t[0] == 0 && p[0] == 0, "a table that begins with 0 : 0");
      else if (is_table)
        require(t[0] > time, "a table of times that ascend");
      stops.push_back({p[0], is_table ? t[0] - time : 0.});
      time = is_table ? t[0] : 0.;
    }
  if (!is_table)
    return;
  parameters.require(
    speed == 0, "Blade", "Speed", "0 where Blade/Travel is a table of times");
  // The blade is there when the cut begins.
  stops.erase(stops.begin());
}



void
BladePath::check_stops(const Parameters &parameters) const
{
  const auto require = [&](const bool holds, const std::string &allowed) {
    parameters.require(holds, "Blade", "Travel", allowed);
  };
  require(std::any_of(stops.begin(),
                      stops.end(),
                      [](const Stop &stop) { return stop.position > 0; }),
          "a path with a position of more than 0: with others the blade does "
          "not touch the body");
  require(stops[0].position > 0,
          "a path that begins forward, with a position of more than 0");
}



double
BladePath::begin_of(const unsigned int stop) const
{
  return stop == 0 ? 0. : stops[stop - 1].position;
}



double
BladePath::speed_to(const unsigned int stop) const
{
  if (stop >= stops.size() || stops[stop].duration == 0)
    return speed;
  return std::abs(stops[stop].position - begin_of(stop)) / stops[stop].duration;
}



bool
BladePath::has_times() const
{
  return speed > 0 || (!stops.empty() && stops[0].duration > 0);
}



bool
BladePath::turns() const
{
  for (unsigned int stop = 0; stop < stops.size(); ++stop)
    if (stops[stop].position < begin_of(stop))
      return true;
  return false;
}
} // namespace Setsudan
