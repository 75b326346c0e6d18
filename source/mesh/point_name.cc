// SPDX-License-Identifier: LGPL-2.1-or-later
#include <setsudan/mesh/point_name.h>

#include <algorithm>

namespace Setsudan
{
using namespace dealii;

template <int dim>
PointName
name_of_point(const CoarseMesh<dim> &mesh,
              const unsigned int cell,
              const Point<dim> &unit_point)
{
  PointName name;
  for (const unsigned int v : GeometryInfo<dim>::vertex_indices())
    {
      const double weight =
        GeometryInfo<dim>::d_linear_shape_function(unit_point, v);
      if (weight != 0)
        name.emplace_back(mesh.cells[cell].vertices[v], weight);
    }
  std::sort(name.begin(), name.end());
  return name;
}



template <int dim>
EntityKey
entity_of_point(const CoarseMesh<dim> &mesh,
                const unsigned int cell,
                const Point<dim> &unit_point)
{
  EntityKey key;
  key.fill(numbers::invalid_unsigned_int);
  unsigned int n = 0;
  for (const unsigned int v : GeometryInfo<dim>::vertex_indices())
    if (GeometryInfo<dim>::d_linear_shape_function(unit_point, v) != 0)
      {
        if (n == key.size())
          {
            key.fill(numbers::invalid_unsigned_int);
            return key;
          }
        key[n++] = mesh.cells[cell].vertices[v];
      }
  std::sort(key.begin(), key.end());
  return key;
}



template PointName
name_of_point(const CoarseMesh<2> &, const unsigned int, const Point<2> &);
template PointName
name_of_point(const CoarseMesh<3> &, const unsigned int, const Point<3> &);
template EntityKey
entity_of_point(const CoarseMesh<2> &, const unsigned int, const Point<2> &);
template EntityKey
entity_of_point(const CoarseMesh<3> &, const unsigned int, const Point<3> &);
} // namespace Setsudan
