// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <setsudan/blade/blade_edge.h>
#include <setsudan/cut/seam/node_pairs.h>

#include <set>
#include <vector>

namespace Setsudan
{
/** How deep a face of a cut lies, from where the blade enters the cut, and how
 * large it is. */
struct FacePlace
{
  double begin;
  double end;
  /** Of its centre. */
  double center;
  double area;
};

/** A line of faces of a cut, in 2D a vertex. */
struct SurfaceLine
{
  /** From end to end. */
  std::vector<unsigned int> nodes;
  std::vector<unsigned int> faces;
};

/** The faces of a cut, as the blade comes to them, and which of them are
 * neighbours. */
template <int dim>
class FaceGraph
{
public:
  /** @param nodes, edge must live as long. */
  FaceGraph(const SurfaceNodes<dim> &nodes, const BladeEdge<dim> &edge);

  /** How far a node is from where the blade enters the cut. */
  double
  depth(const unsigned int pair) const;

  /** Whether the blade comes to a face across a line of the border. */
  bool
  is_entered(const SurfaceLine &line) const;

  /** The nodes of a line of an unsplit face at the front, in the direction in
   * which the front goes on. */
  std::vector<unsigned int>
  along_front(const SurfaceLine &line, const unsigned int unsplit_face) const;

  /** Some faces of a set and those that hang together with them in it; they are
   * taken out of it. */
  std::vector<unsigned int>
  take_connected(std::vector<unsigned int> faces,
                 std::set<unsigned int> &from) const;

  const std::vector<SurfaceLine> &
  lines() const
  {
    return all_lines;
  }

  const std::vector<unsigned int> &
  lines_of_face(const unsigned int face) const
  {
    return numbers_of_lines[face];
  }

  /** Of each face. */
  const std::vector<FacePlace> &
  places() const
  {
    return all_places;
  }

private:
  dealii::Tensor<1, dim>
  position(const unsigned int pair) const;

  FacePlace
  place_of_face(const SurfaceFace &face) const;

  /** From one end of a line to the other. */
  dealii::Tensor<1, dim>
  way(const SurfaceLine &line) const;

  /** The mean of the ends of a face's lines. */
  dealii::Tensor<1, dim>
  middle(const SurfaceFace &face) const;

  /** The direction in the cut across a line, out of a face. */
  dealii::Tensor<1, dim>
  outward(const SurfaceLine &line, const unsigned int face) const;

  const SurfaceNodes<dim> &nodes;
  const BladeEdge<dim> &edge;
  const double entry;
  std::vector<SurfaceLine> all_lines;
  std::vector<std::vector<unsigned int>> numbers_of_lines;
  std::vector<FacePlace> all_places;
};
} // namespace Setsudan
