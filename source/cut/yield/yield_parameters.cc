// SPDX-License-Identifier: LGPL-2.1-or-later
#include <setsudan/cut/yield/yield_parameters.h>

#include <map>

namespace Setsudan
{
using namespace dealii;

namespace
{
using Criterion = YieldParameters::Criterion;

const std::map<std::string, Criterion> criteria = {
  {"maximum shear", Criterion::maximum_shear},
  {"mean shear", Criterion::mean_shear},
  {"von Mises", Criterion::von_mises},
  {"traction on the cut", Criterion::traction},
  {"energy release", Criterion::energy_release}};
} // namespace


void
YieldParameters::declare(ParameterHandler &handler)
{
  Setsudan::declare(
    handler,
    "Yield",
    "Criterion",
    "maximum shear",
    Patterns::Selection(
      "maximum shear|mean shear|von Mises|traction on the cut|energy release"),
    "What must exceed the requirement. maximum shear (Tresca), von Mises (as "
    "the "
    "shear that would give it, sqrt(J2)) and traction on the cut (the shear "
    "and the pull on its plane) are the largest of the elements that meet at "
    "the front's nodes; they grow as elements shrink, because the stress under "
    "a blade is singular. mean shear is the maximum shear averaged over "
    "Process zone around a node of the front, the largest of all. These are "
    "compared with Shear limit x (1 - Sharpness). energy release is the "
    "energy that splitting the row would release for each new area, compared "
    "with Material/Toughness x (1 - Sharpness).");
  Setsudan::declare(
    handler,
    "Yield",
    "Process zone",
    "0",
    Patterns::Double(),
    "Radius of the ball over which mean shear is averaged, "
    "with weights that fall to 0 at its surface; greater than "
    "0 with that criterion, and without meaning for others. The "
    "force that a row needs grows with it (doc/criteria.md) "
    "[length].");
  Setsudan::declare(handler,
                    "Yield",
                    "Check",
                    "every row",
                    Patterns::Selection("once|every row"),
                    "once: the first row's yield opens the cut, which then "
                    "runs through (as in the paper); every row: each row must "
                    "yield.");
}



YieldParameters::YieldParameters(const Parameters &parameters)
  : criterion(criteria.at(parameters.text("Yield", "Criterion")))
  , process_zone(criterion == Criterion::mean_shear
                   ? parameters.number("Yield", "Process zone")
                   : 0)
  , check(parameters.text("Yield", "Check") == "once" ? Check::once
                                                      : Check::every_row)
{
  parameters.require(criterion != Criterion::mean_shear || process_zone > 0,
                     "Yield",
                     "Process zone",
                     "a length greater than 0, with the criterion mean shear");
  parameters.require(parameters.number("Yield", "Process zone") >= 0,
                     "Yield",
                     "Process zone",
                     "0 or a length");
}



bool
YieldParameters::compares_energies() const
{
  return criterion == Criterion::energy_release;
}



std::string
YieldParameters::quantity() const
{
  return compares_energies() ? "energy release" : "cutting stress";
}



std::string
YieldParameters::unit(const std::string &force, const std::string &length) const
{
  return force + "/" + length + (compares_energies() ? "" : "^2");
}
} // namespace Setsudan
