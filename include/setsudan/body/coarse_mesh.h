#pragma once

#include <deal.II/base/point.h>
#include <deal.II/base/types.h>
#include <deal.II/grid/cell_id.h>
#include <deal.II/grid/tria.h>
#include <deal.II/grid/tria_description.h>

#include <map>
#include <utility>
#include <vector>

namespace Setsudan
{
/** A face, named by a cell of the mesh and the face's number in that cell. */
using CellFace = std::pair<unsigned int, unsigned int>;

/** A face as the sorted numbers of its vertices: the same from both cells. */
using FaceKey = std::vector<unsigned int>;

/**
 * The elements of a body: what a triangulation is created from, and what the
 * mesh surgery works on. Every process holds all of it.
 *
 * Cells keep their numbers for ever: a cut changes which vertices they have,
 * and nothing else.
 */
template <int dim>
struct CoarseMesh
{
  std::vector<dealii::Point<dim>> vertices;

  /** Vertices in deal.II's order, and the material of each cell. */
  std::vector<dealii::CellData<dim>> cells;

  /** Boundary ids. They hang on cells and not on vertices, so that the
   * duplication of vertices cannot lose them. */
  std::map<CellFace, dealii::types::boundary_id> boundary_ids;

  FaceKey
  face_key(const CellFace &face) const;

  dealii::Point<dim>
  cell_center(const unsigned int cell) const;

  /** Position of a node of a straight-edged cell (see nodes.h). */
  dealii::Point<dim>
  node_position(const unsigned int cell, const unsigned int node) const;

  /** Volume of a cell (area in 2D). */
  double
  cell_volume(const unsigned int cell) const;

  /** Largest extent of the body along a coordinate axis. */
  double
  extent() const;
};

/** For every cell the cells that share a face with it. */
template <int dim>
std::vector<std::vector<unsigned int>>
collect_neighbors(const CoarseMesh<dim> &mesh);

/** Make the triangulation whose level-0 cell of index i is cell i of `mesh`. */
template <int dim>
void
create_triangulation(const CoarseMesh<dim> &mesh,
                     dealii::Triangulation<dim> &triangulation);

/**
 * The separate bodies that a mesh consists of: for every cell the number of
 * its piece, counted from 0 in the order of the pieces' first cells. Cells
 * that share a face belong together.
 */
template <int dim>
std::vector<unsigned int>
find_pieces(const CoarseMesh<dim> &mesh);
} // namespace Setsudan
