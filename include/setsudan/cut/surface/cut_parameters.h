// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <setsudan/blade/blade.h>
#include <setsudan/blade/blade_edge.h>
#include <setsudan/body/supports.h>
#include <setsudan/cut/surface/surface_choice.h>

#include <string>
#include <utility>
#include <vector>

namespace Setsudan
{
/** One cut: where it goes, and how the blade makes it. */
template <int dim>
struct Cut
{
  /** As the scene has it. */
  std::string text;
  ChosenSurface<dim> surface;
  BladeEdge<dim> edge;
  EdgeLoads edge_loads;
};

/** How far the blade travels, from wherever, until its edge comes to a vertex
 * of a cut; each vertex as often as it is a corner of a face.
 *
 * @param mesh before the cut is made. */
template <int dim>
std::vector<std::pair<unsigned int, double>>
travels_to_vertices(const CoarseMesh<dim> &mesh, const Cut<dim> &cut);

/** Subsection `Cut`: where the body is cut, one cut after the other. */
template <int dim>
struct CutParameters
{
  static void
  declare(dealii::ParameterHandler &handler);

  /** @throw SceneError for a surface that cannot be cut, or not by the blade.
   */
  CutParameters(const Parameters &parameters,
                const Body<dim> &body,
                const Supports<dim> &supports,
                const BladeParameters<dim> &blade);

  std::vector<Cut<dim>> cuts;

  /** How deep each cut is open before a blade that travels comes. */
  double notch = 0;

  /** How often elements near the cuts are halved along each axis. */
  unsigned int near_cut_levels = 0;
  /** Up to which distance from a cut. */
  double near_cut_width = 0;
};
} // namespace Setsudan
