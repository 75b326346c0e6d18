// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <setsudan/mesh/coarse_mesh.h>

#include <utility>
#include <vector>

namespace Setsudan
{
/**
 * A point of the body, named by vertices and their weights in the trilinear
 * interpolation, without those of weight 0, in the order of the vertices.
 *
 * A point on a face, line or vertex has the same name from every cell that
 * has it, and the points of refined cells have weights that are exact in
 * binary, so that names can be compared. Positions cannot: different nodes
 * may lie in one place.
 */
using PointName = std::vector<std::pair<unsigned int, double>>;

/** @param unit_point in the reference coordinates of a cell of `mesh`. */
template <int dim>
PointName
name_of_point(const CoarseMesh<dim> &mesh,
              const unsigned int cell,
              const dealii::Point<dim> &unit_point);

/** The smallest vertex, line or face that has a point; all entries of the key
 * are `invalid_unsigned_int` for a point inside a hexahedron. */
template <int dim>
EntityKey
entity_of_point(const CoarseMesh<dim> &mesh,
                const unsigned int cell,
                const dealii::Point<dim> &unit_point);
} // namespace Setsudan
