// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <setsudan/cut/seam/seam_cells.h>
#include <setsudan/cut/yield/yield_parameters.h>
#include <setsudan/mechanics/stress/recovered_stress.h>

#include <vector>

namespace Setsudan
{
/** The stress at a point at or near the front. */
struct FrontStress
{
  dealii::SymmetricTensor<2, 3> stress;
  /** Of the material there, across the cut. */
  double shear_limit;
  /** Unit normal of the cut, at its nodes. */
  dealii::Tensor<1, 3> normal = {};
  /** The process zone that the point belongs to, and its weight there. */
  unsigned int zone = 0;
  double weight     = 1;
};

/** The stresses that decide whether a row yields, in so far as this process has
 * them. They are linear in the displacement. */
struct FrontStresses
{
  std::vector<FrontStress> samples;
  /** The number of process zones over which samples are averaged; 0 if each
   * sample stands for itself. */
  unsigned int n_zones = 0;
};

/**
 * The stresses at the nodes of a row's front, one for each cell that meets
 * there, or those in process zones around them.
 *
 * @param cells        those that meet the seam.
 * @param displacement with ghosts.
 * @param recovered the stress to take instead of the elements' own, or nothing.
 * @throw CutError where a process zone is too small for the cells.
 */
template <int dim>
FrontStresses
front_stresses(const ElasticModel<dim> &model,
               const Seam<dim> &seam,
               const SeamCells<dim> &cells,
               const Row &row,
               const YieldParameters &yield,
               const LA::Vector &displacement,
               const RecoveredStress<dim> *recovered = nullptr);

} // namespace Setsudan
