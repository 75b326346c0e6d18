// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <setsudan/cut/surface/cut_surface.h>
#include <setsudan/mesh/coarse_mesh.h>

namespace Setsudan
{
/**
 * Open a mesh along a surface by duplicating vertices.
 *
 * Around each vertex of the surface the cells that meet there form a fan.
 * Without the faces of the surface the fan falls into components; the one with
 * the smallest cell number keeps the vertex, every other gets a copy of its
 * own. So the tip of a cut inside the body stays joined, crossing cuts make
 * four copies, and no material is lost.
 *
 * Cells keep their numbers and copies stand behind the old vertices. Faces
 * that are open already are left as they are.
 */
template <int dim>
CoarseMesh<dim>
split_mesh(const CoarseMesh<dim> &mesh, const CutSurface<dim> &surface);

/** The faces of a surface that its two cells (still) share. */
template <int dim>
CutSurface<dim>
joined_faces(const CoarseMesh<dim> &mesh, const CutSurface<dim> &surface);
} // namespace Setsudan
