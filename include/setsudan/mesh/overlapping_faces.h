// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <setsudan/mesh/coarse_mesh.h>

#include <vector>

namespace Setsudan
{
/**
 * The faces of a surface that lie on others with other corners: the center of
 * one lies in another one that looks the other way.
 *
 * @param places of the vertices: coincident ones have the same number.
 */
template <int dim>
std::vector<CellFace>
find_overlapping_faces(const CoarseMesh<dim> &mesh,
                       const std::vector<CellFace> &surface,
                       const std::vector<unsigned int> &places);
} // namespace Setsudan
