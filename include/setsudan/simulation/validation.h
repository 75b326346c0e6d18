// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <setsudan/output/frames/vtu.h>
#include <setsudan/simulation/scene.h>

#include <map>
#include <string>
#include <vector>

namespace Setsudan
{
/** The rows of a cut: for each of its nodes, by name, the row it belongs to. */
using RowsOfNodes = std::map<PointName, unsigned int>;

/** What was understood of a scene. */
struct Validation
{
  /** In sentences, one a line. */
  std::vector<std::string> lines;
  /** Of each cut. */
  std::vector<RowsOfNodes> rows;
  /** The piece of every element when all cuts have gone through. */
  std::vector<unsigned int> pieces;
};

/**
 * Say what a scene selects: elements, nodes and memory, groups, what each
 * support and load takes, and cut by cut the rows and the pieces, and which of
 * them lose their support. The cuts are made without solving, in the body as it
 * is before refinement. Called by all processes.
 */
template <int dim>
Validation
validate(const Scene<dim> &scene, const MPI_Comm communicator);

/** The body at rest with what was selected as fields: groups, supports, cuts,
 * their rows, and pieces. */
template <int dim>
VtuGrid
validation_grid(const Scene<dim> &scene, const Validation &validation);
} // namespace Setsudan
