// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <setsudan/cut/yield/front_stresses.h>

#include <vector>

namespace Setsudan
{
/** A ball around a node of the front. */
template <int dim>
struct ProcessZone
{
  dealii::Point<dim> center;
  /** Unit normal of the cut there. */
  dealii::Tensor<1, dim> normal;
};

/**
 * The stresses in balls around points, weighted by volume and by
 * (1 - (r / radius)^2)^2, the bell-shaped function of nonlocal damage models
 * (Bazant and Jirasek 2002, Journal of Engineering Mechanics 128, 1119-1149).
 * The stress under a line load grows as 1/r and that under a point load as
 * 1/r^2, both of which have a finite mean over a ball.
 *
 * Cells that are large for the ball are integrated by rules that are repeated
 * within them.
 *
 * @param displacement with ghosts.
 * @param recovered the stress to take instead of the elements' own, or nothing.
 * @throw CutError where no integration point lies within a ball.
 */
template <int dim>
FrontStresses
stresses_in_zones(const ElasticModel<dim> &model,
                  const std::vector<ProcessZone<dim>> &zones,
                  const double radius,
                  const LA::Vector &displacement,
                  const RecoveredStress<dim> *recovered = nullptr);
} // namespace Setsudan
