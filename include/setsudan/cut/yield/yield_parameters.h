// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <setsudan/parameters/parameters.h>

#include <string>

namespace Setsudan
{
/** Subsection `Yield`: what must be reached for a row to be split. */
struct YieldParameters
{
  enum class Criterion
  {
    maximum_shear,
    mean_shear,
    von_mises,
    traction,
    energy_release
  };
  enum class Check
  {
    once,
    every_row
  };

  Criterion criterion;
  /** Radius of the process zone, for `mean_shear`. */
  double process_zone;
  Check check;

  static void
  declare(dealii::ParameterHandler &handler);

  explicit YieldParameters(const Parameters &parameters);

  /** Whether what drives and what is required are energies for an area and not
   * stresses: the body is compared with and without its next row, for which the
   * nodes must be duplicated already. */
  bool
  compares_energies() const;

  /** What is compared with the requirement, in words. */
  std::string
  quantity() const;

  /** Its unit, in those of force and length. */
  std::string
  unit(const std::string &force, const std::string &length) const;
};
} // namespace Setsudan
