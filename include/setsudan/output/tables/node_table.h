// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <setsudan/cut/seam/wall_overlap.h>
#include <setsudan/mechanics/elastic_model.h>
#include <setsudan/output/output_directory.h>

#include <string>
#include <vector>

namespace Setsudan
{
/**
 * Write the nodes of a solved state as a table: number in the uncut body, side
 * of the cut, position, displacement, and the maximum shear (the largest) and
 * stress (the mean) of the elements that meet there on that side.
 *
 * Nodes that refinement has made have numbers behind those of the body.
 *
 * A node away from split nodes has side 0; the copies of a split one have '-'
 * and '+', one sign for each cut that split it. A tied pair is one node still.
 * Called by all processes; the first one writes.
 *
 * @param walls of all cuts made so far, on the present mesh.
 * @param displacement with ghosts.
 */
template <int dim>
void
write_node_table(const Body<dim> &body,
                 const ElasticModel<dim> &model,
                 const std::vector<CutWall<dim>> &walls,
                 const LA::Vector &displacement,
                 const OutputDirectory &directory,
                 const std::string &name);
} // namespace Setsudan
