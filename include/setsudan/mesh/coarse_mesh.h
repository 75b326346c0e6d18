// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <deal.II/base/point.h>
#include <deal.II/base/types.h>
#include <deal.II/grid/tria.h>
#include <deal.II/grid/tria_description.h>

#include <setsudan/mesh/entity_key.h>
#include <setsudan/mesh/nodes.h>

#include <array>
#include <utility>
#include <vector>

namespace Setsudan
{
/** A face, named by a cell of the mesh and the face's number in that cell. */
using CellFace = std::pair<unsigned int, unsigned int>;

/** Positions of the nodes of an element, in the order of nodes.h. */
template <int dim>
using ElementNodes = std::array<dealii::Point<dim>, n_element_nodes<dim>>;

/**
 * The elements of a body: what a triangulation is created from, and what the
 * mesh surgery works on. Every process holds all of it.
 *
 * Cells keep their numbers for ever: a cut changes which vertices they have,
 * and nothing else. What a cell has besides, the middle nodes of its lines
 * among it, hangs on the cell, so that the surgery cannot lose it.
 */
template <int dim>
struct CoarseMesh
{
  using LineNodes =
    std::array<dealii::Point<dim>, dealii::GeometryInfo<dim>::lines_per_cell>;

  std::vector<dealii::Point<dim>> vertices;

  /** Vertices in deal.II's order, and the material of each cell. */
  std::vector<dealii::CellData<dim>> cells;

  /** The middle nodes of the lines of each cell. Empty where all lines of the
   * mesh are straight, with their nodes in the middle. */
  std::vector<LineNodes> line_nodes;

  bool
  is_curved() const;

  std::array<unsigned int, dealii::GeometryInfo<dim>::vertices_per_face>
  face_vertices(const CellFace &face) const;

  EntityKey
  face_key(const CellFace &face) const;

  /** The mean of a cell's vertices. */
  dealii::Point<dim>
  cell_center(const unsigned int cell) const;

  dealii::Point<dim>
  node_position(const unsigned int cell, const unsigned int node) const;

  ElementNodes<dim>
  node_positions(const unsigned int cell) const;

  /** Largest extent of the body along a coordinate axis. */
  double
  extent() const;

  /** What the digits of coordinates leave unsaid, relative to the shortest line
   * between two vertices of a cell: more than round-off where the body is far
   * from the origin. */
  double
  round_off() const;
};

/** Make the triangulation whose level-0 cell of index i is cell i of `mesh`. */
template <int dim>
void
create_triangulation(const CoarseMesh<dim> &mesh,
                     dealii::Triangulation<dim> &triangulation);
} // namespace Setsudan
