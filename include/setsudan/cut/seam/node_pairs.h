// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <deal.II/base/tensor.h>

#include <setsudan/blade/blade_edge.h>
#include <setsudan/cut/surface/cut_surface.h>
#include <setsudan/mechanics/elastic_model.h>
#include <setsudan/mesh/point_name.h>

#include <array>
#include <bitset>
#include <vector>

namespace Setsudan
{
/**
 * A node of the cut surface as its two sides have it. Before the surgery, and
 * at the tip of a cut that ends inside the body, both are the same node.
 */
template <int dim>
struct NodePair
{
  using NodeIndices = typename Discretization<dim>::NodeIndices;

  /** The node in the uncut body. */
  PointName name;
  /** An element that has it on the minus side. */
  unsigned int element;
  /** One that has it on the plus side. */
  unsigned int plus_element;
  dealii::Point<dim> position;
  /** Unit normal of the cut there, from minus to plus. */
  dealii::Tensor<1, dim> normal;
  /** Whether it is a corner of cells, and not the middle of an edge. */
  bool is_corner;
  /** Whether the cut will divide it, or has. */
  bool is_divided;
  NodeIndices minus;
  NodeIndices plus;
  /** Components that a support holds, on both sides. */
  std::bitset<dim> supported;

  /** Whether the two sides have a node each. */
  bool
  is_double() const;

  /** The component that an opening determines: the largest of the normal. */
  unsigned int
  normal_component() const;
};

/** Where the blade's travel comes to the nodes of a cut, and where it has
 * passed them all. */
template <int dim>
std::array<double, 2>
travels_of_pairs(const std::vector<NodePair<dim>> &pairs,
                 const BladeEdge<dim> &edge);

/** A face of a (refined) cell on a cut, by its node pairs. */
struct SurfaceFace
{
  std::vector<unsigned int> pairs;
  /** Those on each of its lines, from end to end; in 2D its two vertices. */
  std::vector<std::vector<unsigned int>> lines;
};

/** The nodes of a cut. */
template <int dim>
struct SurfaceNodes
{
  /** In the order of their names. */
  std::vector<NodePair<dim>> pairs;
  std::vector<SurfaceFace> faces;
  /** How many cells there are along a line of an element: all that touch a cut
   * are refined to the same level. */
  unsigned int n_cells_on_line = 1;
};

/**
 * All node pairs of cut surfaces, each for itself, the same on every process.
 * They are found face by face and by name: a position alone may belong to
 * several nodes once the body has been cut before, or where cells are refined.
 *
 * @param split the mesh after the surgery along these surfaces, whether it has
 * been made or not.
 * @pre no node of the surfaces hangs (see refine_near_cuts()).
 */
template <int dim>
std::vector<SurfaceNodes<dim>>
collect_surface_nodes(const ElasticModel<dim> &model,
                      const std::vector<CutSurface<dim>> &surfaces,
                      const Body<dim> &body,
                      const CoarseMesh<dim> &split);
} // namespace Setsudan
