// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <setsudan/parameters/parameters.h>

#include <string>

namespace Setsudan
{
/** Subsection `Accuracy`: whether errors are estimated, and how small they are
 * to be. */
struct AccuracyParameters
{
  enum class Quantity
  {
    strain_energy,
    cutting_stress
  };

  /** In which states of the first cut the target is to be met. */
  enum class States
  {
    first_row,
    middle_row,
    both
  };

  bool estimate;
  /** The relative error that elements are refined for; 0 if they are not. */
  double target;
  Quantity quantity;
  States states;
  /** Up to which distance from the cuts cells are refined for it; 0 for all
   * cells. */
  double width;
  unsigned int max_cells;

  static void
  declare(dealii::ParameterHandler &handler);

  explicit AccuracyParameters(const Parameters &parameters);

  /** The quantity in words. */
  std::string
  quantity_name() const;
};
} // namespace Setsudan
