// SPDX-License-Identifier: LGPL-2.1-or-later
#include <setsudan/body/region.h>
#include <setsudan/mesh/geometry.h>
#include <setsudan/mesh/point_name.h>

#include <algorithm>

namespace Setsudan
{
using namespace dealii;

template <int dim>
Region<dim>::Region(const Body<dim> &body,
                    const std::vector<const Group *> &groups)
{
  for (const Group *group : groups)
    {
      for (const auto &entity : group->entities)
        add_with_boundary(entity);
      if (!group->cells.empty())
        cells.resize(body.mesh.cells.size());
      for (const unsigned int cell : group->cells)
        {
          cells[cell] = true;
          for (unsigned int f = 0; f < GeometryInfo<dim>::faces_per_cell; ++f)
            add_with_boundary(body.mesh.face_key({cell, f}));
        }
    }
  std::sort(entities.begin(), entities.end());
  entities.erase(std::unique(entities.begin(), entities.end()), entities.end());
}



template <int dim>
Region<dim>::Region(const Point<dim> &lower, const Point<dim> &upper)
  : has_box(true)
  , lower(lower)
  , upper(upper)
{
}



template <int dim>
Region<dim>::Region(const std::set<unsigned int> &node_numbers)
  : nodes(node_numbers)
{
}



template <int dim>
void
Region<dim>::add_with_boundary(const EntityKey &entity)
{
  // All pairs of a face's vertices, its two diagonals among them: no line of
  // the mesh runs there, so that nothing is ever found at them.
  const unsigned int n = n_vertices(entity);
  entities.push_back(entity);
  for (unsigned int i = 0; n > 1 && i < n; ++i)
    {
      entities.push_back(make_entity_key(std::vector<unsigned int>{entity[i]}));
      for (unsigned int j = i + 1; n > 2 && j < n; ++j)
        entities.push_back(
          make_entity_key(std::vector<unsigned int>{entity[i], entity[j]}));
    }
}



template <int dim>
bool
Region<dim>::contains(const Body<dim> &body,
                      const unsigned int cell,
                      const Point<dim> &unit_point) const
{
  if (!cells.empty() && cells[cell])
    return true;
  if (!entities.empty() &&
      std::binary_search(entities.begin(),
                         entities.end(),
                         entity_of_point(body.mesh, cell, unit_point)))
    return true;
  if (has_box)
    {
      const auto nodes     = body.mesh.node_positions(cell);
      const auto point     = point_of_element(nodes, unit_point);
      const double allowed = coordinate_tolerance<dim>(nodes);
      bool inside          = true;
      for (unsigned int d = 0; d < dim; ++d)
        inside = inside && point[d] >= lower[d] - allowed &&
                 point[d] <= upper[d] + allowed;
      return inside;
    }
  if (nodes.empty())
    return false;
  const auto node = node_at(unit_point);
  return node && nodes.count(body.node_numbers[cell][*node]) > 0;
}



template class Region<2>;
template class Region<3>;
} // namespace Setsudan
