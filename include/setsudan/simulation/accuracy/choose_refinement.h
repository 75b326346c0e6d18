// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <setsudan/mesh/refinement.h>
#include <setsudan/output/progress.h>
#include <setsudan/simulation/scene.h>

namespace Setsudan
{
/**
 * How the scene's body is to be refined: as the scene says, and further until
 * the estimated error of its trial meets Accuracy/Target (see RefinementTrial).
 * Cells are marked that hold half of the error (Dörfler 1996, SIAM Journal on
 * Numerical Analysis 33, 1106-1124).
 *
 * It says what was chosen, or what was reached where the target was not.
 */
template <int dim>
Refinement
choose_refinement(const Scene<dim> &scene,
                  Progress &progress,
                  const MPI_Comm communicator);
} // namespace Setsudan
