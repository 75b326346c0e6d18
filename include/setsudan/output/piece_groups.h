#pragma once

#include <setsudan/output/piece_mesh.h>

#include <vector>

namespace Setsudan
{
/**
 * The groups of the body as far as they are in a piece, so that the piece can
 * be addressed in the next scene as the body is in this one. The faces that
 * cuts have opened join them as the group `cut`.
 *
 * @param piece all of it but its groups.
 * @param mesh  the mesh after the cuts.
 */
template <int dim>
std::vector<PieceGroup>
collect_piece_groups(const PieceMesh<dim> &piece,
                     const CoarseMesh<dim> &mesh,
                     const Body<dim> &body);
} // namespace Setsudan
