// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <setsudan/output/pieces/piece_mesh.h>

#include <set>
#include <vector>

namespace Setsudan
{
/** The faces of cells that are inside of the uncut body and on the surface of
 * the cut one. */
template <int dim>
std::set<CellFace>
find_opened_faces(const CoarseMesh<dim> &mesh, const Body<dim> &body);

/**
 * The groups of the body as far as they are in a piece, so that the piece can
 * be addressed in the next scene as the body is in this one. The faces that
 * cuts have opened join them as the group `cut`.
 *
 * @param piece  all of it but its groups.
 * @param opened see find_opened_faces().
 */
template <int dim>
std::vector<PieceGroup>
collect_piece_groups(const PieceMesh<dim> &piece,
                     const std::set<CellFace> &opened,
                     const Body<dim> &body);
} // namespace Setsudan
