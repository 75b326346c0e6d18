// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <setsudan/cut/seam/seam.h>

#include <vector>

namespace Setsudan
{
/** The node pairs of a cut, and how they are held together. */
template <int dim>
struct CutWall
{
  const std::vector<NodePair<dim>> &pairs;
  PairStates states;
};

/** Where the two walls of a cut have moved through each other the farthest. */
template <int dim>
struct WallOverlap
{
  /** How far, along the cut's normal [length]; 0 where they have not. */
  double depth = 0;
  /** The place, in the body at rest, and the number of the cut. */
  dealii::Point<dim> position;
  unsigned int cut = 0;
};

/**
 * The largest overlap at the node pairs that nothing holds together any more:
 * n.(u+ - u-) < 0. Nothing in a body without contact prevents it. Called by all
 * processes.
 *
 * @param walls        of all cuts.
 * @param displacement without ghosts.
 */
template <int dim>
WallOverlap<dim>
find_wall_overlap(const std::vector<CutWall<dim>> &walls,
                  const LA::Vector &displacement,
                  const MPI_Comm communicator);
} // namespace Setsudan
