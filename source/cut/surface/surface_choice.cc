// SPDX-License-Identifier: LGPL-2.1-or-later
#include <setsudan/cut/surface/surface_choice.h>
#include <setsudan/mesh/face_index.h>
#include <setsudan/mesh/geometry.h>
#include <setsudan/parameters/exceptions.h>

#include <algorithm>
#include <cmath>
#include <limits>
namespace Setsudan
{
using namespace dealii;

namespace
{
/** The faces between cells on different sides; `side` is -1, +1, or 0 for
 * cells that no face is wanted of. */
template <int dim>
CutSurface<dim>
faces_between(const Body<dim> &body, const std::vector<int> &side)
{
  CutSurface<dim> surface;
  const FaceIndex<dim> index(body.mesh);
  const auto &faces = index.faces();
  for (unsigned int i = 0; i + 1 < faces.size(); ++i)
    if (faces[i].first == faces[i + 1].first)
      {
        const CellFace &a = faces[i].second, &b = faces[i + 1].second;
        if (side[a.first] * side[b.first] < 0)
          surface.push_back(side[a.first] < 0 ? CutFace<dim>{a, b}
                                              : CutFace<dim>{b, a});
      }
  // In the order of the elements, which numbers of vertices do not disturb.
  std::sort(surface.begin(), surface.end(), [](const auto &a, const auto &b) {
    return a.minus < b.minus;
  });
  return surface;
}
} // namespace


template <int dim>
LayerBoundary<dim>::LayerBoundary(const unsigned int axis,
                                  const unsigned int boundary)
  : axis(axis)
  , boundary(boundary)
{
}



template <int dim>
ChosenSurface<dim>
LayerBoundary<dim>::choose(const Body<dim> &body) const
{
  ChosenSurface<dim> surface;
  for (unsigned int element = 0; element < body.mesh.cells.size(); ++element)
    {
      auto indices = body.box->element_indices(element);
      if (indices[axis] != boundary)
        continue;
      --indices[axis];
      surface.faces.push_back(
        {{body.box->element_number(indices), 2 * axis + 1},
         {element, 2 * axis}});
    }
  return surface;
}



template <int dim>
LevelSet<dim>::LevelSet(const Function &function)
  : function(function)
{
}



template <int dim>
double
LevelSet<dim>::distance(const Point<dim> &point, const double size) const
{
  Tensor<1, dim> gradient;
  for (unsigned int d = 0; d < dim; ++d)
    {
      const double step = 1e-4 * size;
      Point<dim> before = point, behind = point;
      before[d] -= step;
      behind[d] += step;
      gradient[d] = (function(behind) - function(before)) / (2 * step);
    }
  const double value = function(point);
  return value == 0 ? 0. : value / gradient.norm();
}



template <int dim>
int
LevelSet<dim>::side(const CoarseMesh<dim> &mesh, const unsigned int cell) const
{
  const Point<dim> center = mesh.cell_center(cell);
  const Point<dim> corner = mesh.vertices[mesh.cells[cell].vertices[0]];
  const double value      = function(center);
  // Far from the surface there is no need to know the distance.
  if (std::abs(value) < 1e-3 * std::abs(function(corner) - value))
    {
      const double size = center.distance(corner);
      if (std::abs(distance(center, size)) <= 1e-6 * size)
        return 1;
    }
  return value < 0 ? -1 : 1;
}



template <int dim>
ChosenSurface<dim>
LevelSet<dim>::choose(const Body<dim> &body) const
{
  std::vector<int> sides(body.mesh.cells.size());
  for (unsigned int cell = 0; cell < sides.size(); ++cell)
    sides[cell] = side(body.mesh, cell);
  ChosenSurface<dim> surface;
  surface.faces   = faces_between(body, sides);
  double smallest = std::numeric_limits<double>::max(), largest = -smallest;
  for (const auto &face : surface.faces)
    {
      const auto nodes  = body.mesh.node_positions(face.minus.first);
      const double size = std::pow(volume_of_element<dim>(nodes), 1. / dim);
      for (unsigned int node = 0; node < nodes.size(); ++node)
        if (node_is_on_face<dim>(node, face.minus.second))
          {
            const double off = distance(nodes[node], size) / size;
            smallest         = std::min(smallest, off);
            largest          = std::max(largest, off);
          }
    }
  if (!surface.faces.empty())
    {
      surface.roughness  = std::max(std::abs(smallest), std::abs(largest));
      surface.unevenness = largest - smallest;
    }
  return surface;
}



template <int dim>
GroupOfFaces<dim>::GroupOfFaces(const std::vector<EntityKey> &faces)
  : faces(faces)
{
}



template <int dim>
ChosenSurface<dim>
GroupOfFaces<dim>::choose(const Body<dim> &body) const
{
  ChosenSurface<dim> surface;
  const FaceIndex<dim> index(body.mesh);
  for (const auto &face : faces)
    {
      const auto cells = index.find(face);
      if (cells.size() == 2)
        surface.faces.push_back({cells[0], cells[1]});
      else
        ++surface.n_open;
    }
  if (surface.faces.empty())
    throw CutError(
      "it lies on the boundary of the body, where there is nothing to cut");
  if (find_branchings(body, surface.faces).empty() &&
      !orient_surface(body, surface.faces))
    throw CutError(
      "it has one side only, like a Möbius strip, and no cut can follow it");
  return surface;
}



template <int dim>
Interface<dim>::Interface(const std::vector<unsigned int> &minus,
                          const std::vector<unsigned int> &plus)
  : minus(minus)
  , plus(plus)
{
}



template <int dim>
ChosenSurface<dim>
Interface<dim>::choose(const Body<dim> &body) const
{
  std::vector<int> side(body.mesh.cells.size(), 0);
  for (const unsigned int cell : minus)
    side[cell] = -1;
  for (const unsigned int cell : plus)
    side[cell] = 1;
  ChosenSurface<dim> surface;
  surface.faces = faces_between(body, side);
  return surface;
}



template class LayerBoundary<2>;
template class LayerBoundary<3>;
template class LevelSet<2>;
template class LevelSet<3>;
template class GroupOfFaces<2>;
template class GroupOfFaces<3>;
template class Interface<2>;
template class Interface<3>;
} // namespace Setsudan
