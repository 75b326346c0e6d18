// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <setsudan/simulation/scene.h>

namespace Setsudan
{
/** How large the model of a scene is, at least. */
struct ModelSize
{
  double n_cells    = 0;
  double n_unknowns = 0;
  /** The memory that a run takes [bytes]. */
  double bytes = 0;
};

/** The size of a scene's model, from its elements and how they are refined: all
 * of them, and those that meet the cuts. What a width around cuts and
 * Accuracy/Target add is not in it. */
template <int dim>
ModelSize
estimate_size(const BodyParameters<dim> &shape,
              const Body<dim> &body,
              const CutParameters<dim> &cut,
              const SolverParameters &solver);

/** @throw SceneError where the memory does not suffice for it. */
template <int dim>
void
check_size(const Parameters &parameters,
           const BodyParameters<dim> &shape,
           const CutParameters<dim> &cut,
           const ModelSize &size);
} // namespace Setsudan
