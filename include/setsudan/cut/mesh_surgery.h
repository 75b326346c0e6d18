#pragma once

#include <setsudan/body/coarse_mesh.h>
#include <setsudan/cut/cut_surface.h>

namespace Setsudan
{
/** Boundary ids of the two faces of a cut; a box uses 0 to 5 itself. */
constexpr dealii::types::boundary_id cut_minus_id = 100;
constexpr dealii::types::boundary_id cut_plus_id  = 101;

/**
 * Open a mesh along a surface by duplicating vertices.
 *
 * Around each vertex of the surface the cells that meet there form a fan.
 * Without the faces of the surface the fan falls into components; the one with
 * the smallest cell number keeps the vertex, every other gets a copy of its
 * own. So the tip of a cut inside the body stays joined, crossing cuts make
 * four copies, and no material is lost.
 *
 * Cells keep their numbers and copies stand behind the old vertices.
 *
 * @pre every face of the surface is shared by its two cells.
 */
template <int dim>
CoarseMesh<dim>
split_mesh(const CoarseMesh<dim> &mesh, const CutSurface<dim> &surface);
} // namespace Setsudan
