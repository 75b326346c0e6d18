// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <deal.II/base/point.h>
#include <deal.II/grid/tria.h>

#include <setsudan/mesh/coarse_mesh.h>

#include <cstdint>
#include <tuple>
#include <vector>

namespace Setsudan
{
/**
 * A cell of a refined mesh, named by the element of the body that it is a part
 * of and the way down to it: a leading 1, then dim bits for each child. Unlike
 * deal.II's names it stays the same when the mesh is cut.
 */
struct CellPath
{
  unsigned int element = 0;
  std::uint64_t path   = 1;

  bool
  operator<(const CellPath &other) const
  {
    return std::tie(element, path) < std::tie(other.element, other.path);
  }

  bool
  operator==(const CellPath &other) const
  {
    return element == other.element && path == other.path;
  }

  template <class Archive>
  void
  serialize(Archive &archive, const unsigned int)
  {
    archive &element &path;
  }
};

template <int dim>
CellPath
path_of_cell(const typename dealii::Triangulation<dim>::cell_iterator &cell);

/** A point of a refined cell, in the reference coordinates of its element. */
template <int dim>
dealii::Point<dim>
point_in_element(const CellPath &path, const dealii::Point<dim> &unit_point);

/**
 * How the elements of a body are refined: a record that can be replayed on the
 * mesh after it has been cut, where it gives the same cells.
 */
struct Refinement
{
  /** How often all cells are refined first. */
  unsigned int global_levels = 0;
  /** The cells that are refined besides, ascending, the same on all
   * processes. */
  std::vector<CellPath> refined;
};

/** The record of a mesh that was refined everywhere by `global_levels` first;
 * called by all processes that share it, all get the same. */
template <int dim>
Refinement
record_refinement(const dealii::Triangulation<dim> &triangulation,
                  const unsigned int global_levels);

/** The cells of all processes' lists, ascending; called by all of them. */
std::vector<CellPath>
gather_cells(const std::vector<CellPath> &own, const MPI_Comm communicator);

/** How many cells the mesh of a body has when it is refined so. */
template <int dim>
dealii::types::global_cell_index
count_cells(const CoarseMesh<dim> &mesh, const Refinement &refinement);

/** Refine an unrefined mesh of the body as recorded. */
template <int dim>
void
refine(dealii::Triangulation<dim> &triangulation, const Refinement &refinement);
} // namespace Setsudan
