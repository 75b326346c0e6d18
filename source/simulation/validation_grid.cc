// SPDX-License-Identifier: LGPL-2.1-or-later
#include <setsudan/mesh/point_name.h>
#include <setsudan/output/pieces/element_order.h>
#include <setsudan/output/pieces/piece_mesh.h>
#include <setsudan/simulation/validation.h>

namespace Setsudan
{
using namespace dealii;

namespace
{
/** A number for each node of the body, found element by element. */
template <int dim, typename Value>
VtuArray
at_nodes(const std::string &name,
         const PieceMesh<dim> &nodes,
         const std::int32_t otherwise,
         const Value &value)
{
  std::vector<std::int32_t> values(nodes.nodes.size(), otherwise);
  for (unsigned int e = 0; e < nodes.elements.size(); ++e)
    for (unsigned int n = 0; n < n_element_nodes<dim>; ++n)
      if (const std::int32_t here = value(e, unit_point_of_node<dim>(n));
          here != otherwise)
        values[nodes.elements[e][n]] = here;
  return {name, 1, values};
}

std::string
name_of(const Group &group)
{
  return "group " +
         (group.name.empty() ? std::to_string(group.number) : group.name);
}

/** Which nodes are in each group; of groups of elements, which elements. */
template <int dim>
void
add_groups(const Scene<dim> &scene, const PieceMesh<dim> &nodes, VtuGrid &grid)
{
  for (const auto &group : scene.body.groups)
    if (group.dimension == dim)
      {
        std::vector<std::int32_t> values(nodes.elements.size(), 0);
        for (const unsigned int cell : group.cells)
          values[cell] = 1;
        grid.cell_data.push_back({name_of(group), 1, values});
      }
    else
      {
        const Region<dim> region(scene.body, {&group});
        grid.point_data.push_back(
          at_nodes(name_of(group),
                   nodes,
                   0,
                   [&](const unsigned int cell, const Point<dim> &point) {
                     return region.contains(scene.body, cell, point);
                   }));
      }
}

/** At the nodes of each cut its row. */
template <int dim>
void
add_rows(const Scene<dim> &scene,
         const Validation &validation,
         const PieceMesh<dim> &nodes,
         VtuGrid &grid)
{
  for (unsigned int cut = 0; cut < validation.rows.size(); ++cut)
    grid.point_data.push_back(
      at_nodes("row of cut " + std::to_string(cut),
               nodes,
               -1,
               [&](const unsigned int cell, const Point<dim> &point) {
                 const auto found = validation.rows[cut].find(
                   name_of_point(scene.body.mesh, cell, point));
                 return found == validation.rows[cut].end()
                          ? -1
                          : std::int32_t(found->second);
               }));
}

/** On each side of the faces of cuts: the number of the cut, else -1. */
template <int dim>
VtuArray
cut_faces(const Scene<dim> &scene)
{
  std::vector<std::int32_t> values(scene.body.mesh.cells.size(), -1);
  for (unsigned int cut = 0; cut < scene.cut.cuts.size(); ++cut)
    for (const auto &face : scene.cut.cuts[cut].surface.faces)
      values[face.minus.first] = values[face.plus.first] = cut;
  return {"at cut", 1, values};
}
} // namespace



template <int dim>
VtuGrid
validation_grid(const Scene<dim> &scene, const Validation &validation)
{
  const auto whole = make_piece_meshes(
    scene.body.mesh,
    std::vector<unsigned int>(scene.body.mesh.cells.size(), 0),
    scene.body);
  const PieceMesh<dim> &nodes = whole.front();
  VtuGrid grid                = grid_of_piece(nodes);
  grid.point_data.push_back(at_nodes(
    "support", nodes, 0, [&](const unsigned int cell, const Point<dim> &point) {
      return scene.supports.at(cell, point).components.to_ulong();
    }));
  add_groups(scene, nodes, grid);
  add_rows(scene, validation, nodes, grid);
  grid.cell_data.push_back(cut_faces(scene));
  grid.cell_data.push_back(
    {"piece",
     1,
     std::vector<std::int32_t>(validation.pieces.begin(),
                               validation.pieces.end())});
  return grid;
}



template VtuGrid
validation_grid(const Scene<2> &, const Validation &);
template VtuGrid
validation_grid(const Scene<3> &, const Validation &);
} // namespace Setsudan
