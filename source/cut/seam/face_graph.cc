// SPDX-License-Identifier: LGPL-2.1-or-later
#include <setsudan/cut/seam/face_graph.h>

#include <algorithm>
#include <limits>
#include <map>

namespace Setsudan
{
using namespace dealii;

template <int dim>
FaceGraph<dim>::FaceGraph(const SurfaceNodes<dim> &nodes,
                          const BladeEdge<dim> &edge)
  : nodes(nodes)
  , edge(edge)
  , entry(travels_of_pairs(nodes.pairs, edge)[0])
  , numbers_of_lines(nodes.faces.size())
{
  std::map<std::pair<unsigned int, unsigned int>, unsigned int> numbers;
  for (unsigned int f = 0; f < nodes.faces.size(); ++f)
    {
      for (const auto &line : nodes.faces[f].lines)
        {
          const auto ends = std::minmax(line.front(), line.back());
          const unsigned int number =
            numbers.emplace(ends, all_lines.size()).first->second;
          if (number == all_lines.size())
            all_lines.push_back({line, {}});
          all_lines[number].faces.push_back(f);
          numbers_of_lines[f].push_back(number);
        }
      all_places.push_back(place_of_face(nodes.faces[f]));
    }
}



template <int dim>
double
FaceGraph<dim>::depth(const unsigned int pair) const
{
  return edge.travel(nodes.pairs[pair].position) - entry;
}



template <int dim>
Tensor<1, dim>
FaceGraph<dim>::position(const unsigned int pair) const
{
  return nodes.pairs[pair].position;
}



template <int dim>
Tensor<1, dim>
FaceGraph<dim>::middle(const SurfaceFace &face) const
{
  Tensor<1, dim> sum;
  for (const auto &line : face.lines)
    sum += position(line.front()) + position(line.back());
  return sum / (2. * face.lines.size());
}



template <int dim>
FacePlace
FaceGraph<dim>::place_of_face(const SurfaceFace &face) const
{
  FacePlace place{std::numeric_limits<double>::max(),
                  std::numeric_limits<double>::lowest(),
                  0,
                  0};
  for (const unsigned int pair : face.pairs)
    {
      place.begin = std::min(place.begin, depth(pair));
      place.end   = std::max(place.end, depth(pair));
    }
  // Parts from the middle to the lines, in 2D to the ends.
  const Tensor<1, dim> inside = middle(face);
  const auto add = [&](const double area, const Tensor<1, dim> &center) {
    place.area += area;
    place.center += area * (edge.travel(Point<dim>(center)) - entry);
  };
  for (const auto &line : face.lines)
    if constexpr (dim == 3)
      for (unsigned int i = 0; i + 1 < line.size(); ++i)
        {
          const Tensor<1, dim> a = position(line[i]), b = position(line[i + 1]);
          add(cross_product_3d(a - inside, b - inside).norm() / 2,
              (a + b + inside) / 3);
        }
    else
      add((position(line[0]) - inside).norm(),
          (position(line[0]) + inside) / 2);
  place.center /= place.area;
  return place;
}



template <int dim>
Tensor<1, dim>
FaceGraph<dim>::way(const SurfaceLine &line) const
{
  return position(line.nodes.back()) - position(line.nodes.front());
}



template <int dim>
Tensor<1, dim>
FaceGraph<dim>::outward(const SurfaceLine &line, const unsigned int face) const
{
  Tensor<1, dim> out =
    (position(line.nodes.front()) + position(line.nodes.back())) / 2. -
    middle(nodes.faces[face]);
  if (const auto along = way(line); along.norm() > 0)
    out -= (out * along) / along.norm_square() * along;
  return out;
}



template <int dim>
bool
FaceGraph<dim>::is_entered(const SurfaceLine &line) const
{
  // Lines that rise more steeply than ten to one are sides.
  const auto out = outward(line, line.faces[0]);
  return line.faces.size() == 1 && out * edge.direction < -0.1 * out.norm();
}



template <int dim>
std::vector<unsigned int>
FaceGraph<dim>::along_front(const SurfaceLine &line,
                            const unsigned int unsplit_face) const
{
  std::vector<unsigned int> result = line.nodes;
  if constexpr (dim == 3)
    {
      Tensor<1, dim> normal;
      for (const unsigned int p : nodes.faces[unsplit_face].pairs)
        normal += nodes.pairs[p].normal;
      if (cross_product_3d(outward(line, unsplit_face), normal) * way(line) < 0)
        std::reverse(result.begin(), result.end());
    }
  return result;
}



template <int dim>
std::vector<unsigned int>
FaceGraph<dim>::take_connected(std::vector<unsigned int> faces,
                               std::set<unsigned int> &from) const
{
  for (const unsigned int f : faces)
    from.erase(f);
  for (unsigned int i = 0; i < faces.size(); ++i)
    for (const unsigned int l : numbers_of_lines[faces[i]])
      for (const unsigned int other : all_lines[l].faces)
        if (from.erase(other) > 0)
          faces.push_back(other);
  return faces;
}



template class FaceGraph<2>;
template class FaceGraph<3>;
} // namespace Setsudan
