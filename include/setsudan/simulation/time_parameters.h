// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <setsudan/parameters/parameters.h>

#include <utility>
#include <vector>

namespace Setsudan
{
/** Subsection `Time`: how long loads and supports act before the blade comes,
 * and how they change meanwhile. */
struct TimeParameters
{
  /** So long, in so many steps [time]. */
  struct Span
  {
    double duration;
    unsigned int n_steps;
  };

  std::vector<Span> spans;
  /** Times and factors; the first one is that of the beginning. Empty where
   * loads do not change. */
  std::vector<std::pair<double, double>> load_factors;
  /** By how much a displacement may change where a step is halved, relative to
   * the largest one; 0 for steps as they are given. */
  double tolerance;

  static void
  declare(dealii::ParameterHandler &handler);

  /** @throw SceneError for times that are none. */
  explicit TimeParameters(const Parameters &parameters);

  /** Whether time passes before the blade comes. */
  bool
  passes() const
  {
    return !spans.empty();
  }

  /** What loads and prescribed displacements are multiplied with. */
  double
  load_factor(const double time) const;

  /** How long all of it takes. */
  double
  duration() const;
};
} // namespace Setsudan
