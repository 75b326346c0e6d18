// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <setsudan/body/body.h>
#include <setsudan/cut/seam/sides.h>
#include <setsudan/mechanics/elastic_model.h>
#include <setsudan/output/frames/vtu.h>

#include <vector>

namespace Setsudan
{
/** Data of a frame besides its fields. */
struct FrameFacts
{
  /** The first unknowns of the nodes at the front of the cut, ascending. */
  std::vector<dealii::types::global_dof_index> front;
  /** What is said of the state as a whole. */
  std::vector<VtuArray> of_state;
};

/**
 * What a frame shows of this process's cells. At points, of which no two cells
 * share one, so that what jumps between cells can be seen: displacement,
 * stress, strain, what follows from them, the number of the node and whether it
 * is at the front. Cells have 3^dim points, which hold quadratic fields
 * exactly, or the corners of linear elements. Of each cell: its element, side,
 * piece and material.
 *
 * Points are in the order of the cells, whatever is cut: on one process a point
 * is the same one in all frames. Called by all processes.
 *
 * @param body          whose elements the cells are, or parts of them.
 * @param displacement  with ghosts.
 * @param error_squares see ErrorEstimate; empty if errors are not estimated.
 */
template <int dim>
VtuGrid
frame_content(const Body<dim> &body,
              const ElasticModel<dim> &model,
              const LA::Vector &displacement,
              const ElementLabels &labels,
              const dealii::Vector<double> &error_squares,
              const FrameFacts &facts = {});
} // namespace Setsudan
