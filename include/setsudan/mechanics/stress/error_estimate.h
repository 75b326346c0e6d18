// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <deal.II/lac/vector.h>

#include <setsudan/mechanics/stress/recovered_stress.h>

namespace Setsudan
{
/** How far a solved state may be from the exact one. */
struct ErrorEstimate
{
  /** The square of the error's energy norm in each cell of this process, by
   * its active index; 0 in the others. */
  dealii::Vector<double> squares;
  /** The strain energy of the error in relation to that of the state: by so
   * much the state's energy is too small (or, where displacements are
   * prescribed, too large). */
  double relative_energy = 0;
};

/**
 * The energy of the difference between the recovered stress and the elements'
 * own: the estimate of Zienkiewicz and Zhu (1987). Near singular points, such
 * as under a concentrated load, it is too small.
 *
 * @param displacement with ghosts.
 */
template <int dim>
ErrorEstimate
estimate_error(const ElasticModel<dim> &model,
               const RecoveredStress<dim> &recovered,
               const LA::Vector &displacement);
} // namespace Setsudan
