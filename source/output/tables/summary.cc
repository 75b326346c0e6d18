// SPDX-License-Identifier: LGPL-2.1-or-later
#include <setsudan/output/tables/summary.h>

#include <algorithm>
#include <cmath>
#include <ostream>

namespace Setsudan
{
namespace
{
/** A number with the digits of statistics.csv; JSON has none that is not
 * finite.
 */
void
write_number(const std::string &name,
             const std::optional<double> number,
             std::ostream &out)
{
  out << '"' << name << "\": ";
  if (number && std::isfinite(*number))
    out << *number;
  else
    out << "null";
}
} // namespace



void
Summary::add(const Event &event)
{
  n_states   = event.frame + 1;
  n_pieces   = event.pieces;
  max_strain = std::max(max_strain, event.max_strain);
  if (event.motion)
    {
      travels = true;
      work    = event.motion->work;
    }
  if (event.name == "yield")
    add_yield(event);
}



void
Summary::add_yield(const Event &event)
{
  const auto motion = event.motion.value_or(BladeMotion());
  if (n_yields == 0)
    first_yield = event.motion ? motion.travel : event.load_factor;
  else if (event.cut == last_yield.cut)
    {
      steady_work += motion.work - last_yield.work;
      steady_travel += motion.travel - last_yield.travel;
    }
  last_yield = {event.cut, motion.travel, motion.work};
  ++n_yields;
}



std::optional<double>
Summary::mean_force() const
{
  if (!(steady_travel > 0))
    return {};
  return steady_work / steady_travel;
}



void
Summary::write(const Circumstances &circumstances,
               const OutputDirectory &directory) const
{
  directory.write("summary.json", [&](std::ostream &out) {
    out.precision(12);
    out << '{';
    write_number("first_yield",
                 n_yields > 0 ? std::optional<double>(first_yield)
                              : std::nullopt,
                 out);
    out << ", ";
    write_number("mean_force", mean_force(), out);
    out << ", ";
    write_number(
      "work", travels ? std::optional<double>(work) : std::nullopt, out);
    out << ", ";
    write_number("max_strain", max_strain, out);
    out << ", \"doubtful_states\": " << circumstances.n_doubtful_states
        << ", \"frames\": " << n_states << ", \"pieces\": " << n_pieces
        << ", \"processes\": " << circumstances.n_processes << ", ";
    out.precision(4);
    write_number("seconds", circumstances.seconds, out);
    out << "}\n";
  });
}
} // namespace Setsudan
