// SPDX-License-Identifier: LGPL-2.1-or-later
#include <setsudan/simulation/accuracy/accuracy_parameters.h>

namespace Setsudan
{
using namespace dealii;

void
AccuracyParameters::declare(ParameterHandler &handler)
{
  Setsudan::declare(handler,
                    "Accuracy",
                    "Estimate",
                    "false",
                    Patterns::Bool(),
                    "Whether the error of each state is estimated: the columns "
                    "energy_error and stress_error of the statistics, and the "
                    "field of that name in the frames.");
  Setsudan::declare(handler,
                    "Accuracy",
                    "Target",
                    "0",
                    Patterns::Double(),
                    "The relative error of Quantity for which elements are "
                    "refined beforehand; less than 1, and 0 if they stay as "
                    "they are [-].");
  Setsudan::declare(handler,
                    "Accuracy",
                    "Quantity",
                    "strain energy",
                    Patterns::Selection("strain energy|cutting stress"),
                    "What Target is for.");
  Setsudan::declare(
    handler,
    "Accuracy",
    "States",
    "both",
    Patterns::Selection("first row|middle row|both"),
    "Where Target is to be met: with the blade on the first row "
    "of the first cut, or on the one in its middle with all "
    "before it split, or both.");
  Setsudan::declare(handler,
                    "Accuracy",
                    "Width",
                    "0",
                    Patterns::Double(0),
                    "Only cells up to this distance from the cuts, the ways of "
                    "their fronts, are refined for Target; 0 stands for all "
                    "[length].");
  Setsudan::declare(handler,
                    "Accuracy",
                    "Maximum cells",
                    "20000",
                    Patterns::Integer(1),
                    "A target that needs more cells is given up, and the run "
                    "goes on with what was reached [-].");
}



AccuracyParameters::AccuracyParameters(const Parameters &parameters)
  : estimate(parameters.truth("Accuracy", "Estimate"))
  , target(parameters.number("Accuracy", "Target"))
  , quantity(parameters.text("Accuracy", "Quantity") == "strain energy"
               ? Quantity::strain_energy
               : Quantity::cutting_stress)
  , states(parameters.text("Accuracy", "States") == "first row"
             ? States::first_row
           : parameters.text("Accuracy", "States") == "middle row"
             ? States::middle_row
             : States::both)
  , width(parameters.number("Accuracy", "Width"))
  , max_cells(parameters.natural("Accuracy", "Maximum cells"))
{
  parameters.require(target >= 0 && target < 1,
                     "Accuracy",
                     "Target",
                     "a number from 0 to less than 1");
}



std::string
AccuracyParameters::quantity_name() const
{
  return quantity == Quantity::strain_energy ? "strain energy"
                                             : "cutting stress";
}
} // namespace Setsudan
