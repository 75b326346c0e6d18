// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <setsudan/body/body.h>
#include <setsudan/body/region.h>
#include <setsudan/cut/surface/cut_parameters.h>
#include <setsudan/cut/surface/neighborhood.h>
#include <setsudan/mesh/refinement.h>

#include <functional>
#include <vector>

namespace Setsudan
{
/** Tells which cells lie at the cuts of a scene. */
template <int dim>
class NearCut
{
public:
  using Cell = typename dealii::Triangulation<dim>::active_cell_iterator;

  /** @param width the distance from a cut up to which cells lie near it. */
  NearCut(const Body<dim> &body,
          const CutParameters<dim> &cut,
          const double width);

  /** Whether the cell has a vertex on a cut. All such cells must be of one
   * level, also those that touch the cut in a line or a vertex only: then the
   * two sides match, and none of the cut's nodes hangs. */
  bool
  touches(const Cell &cell) const;

  /** Whether it has a vertex on or near a cut. */
  bool
  is_near(const Cell &cell) const;

private:
  bool
  any_vertex(const Cell &cell,
             const std::function<bool(const CellPath &,
                                      const dealii::Point<dim> &)> &has) const;

  const Body<dim> &body;
  /** The faces of the cuts with their lines and vertices. */
  const Region<dim> on_cut;
  const double width;
  const Neighborhood<dim> neighborhood;
};

/**
 * How the body is to be refined: everywhere by `global_levels`, and near its
 * cuts as the scene asks for.
 */
template <int dim>
Refinement
refine_near_cuts(const Body<dim> &body,
                 const CutParameters<dim> &cut,
                 const unsigned int global_levels,
                 const MPI_Comm communicator);

/**
 * Refine some cells further. Where one of them touches a cut, all that do are
 * refined.
 *
 * @param marked the same on all processes, ascending.
 */
template <int dim>
Refinement
refine_further(const Body<dim> &body,
               const CutParameters<dim> &cut,
               const Refinement &refinement,
               const std::vector<CellPath> &marked,
               const MPI_Comm communicator);
} // namespace Setsudan
