// SPDX-License-Identifier: LGPL-2.1-or-later
#include <deal.II/grid/grid_generator.h>
#include <deal.II/grid/grid_tools.h>

#include <setsudan/body/body.h>

#include <algorithm>

namespace Setsudan
{
using namespace dealii;

namespace
{
template <int dim>
std::vector<unsigned int>
sorted_numbers(const Body<dim> &body)
{
  std::vector<unsigned int> numbers;
  for (const auto &of_element : body.node_numbers)
    numbers.insert(numbers.end(), of_element.begin(), of_element.end());
  std::sort(numbers.begin(), numbers.end());
  numbers.erase(std::unique(numbers.begin(), numbers.end()), numbers.end());
  return numbers;
}

/** In the order of deal.II's faces of a cell. */
template <int dim>
std::vector<std::string>
names_of_faces()
{
  if (dim == 2)
    return {"left", "right", "bottom", "top"};
  return {"left", "right", "front", "back", "bottom", "top"};
}
} // namespace


template <int dim>
unsigned int
Body<dim>::n_nodes() const
{
  return sorted_numbers(*this).size();
}



template <int dim>
bool
Body<dim>::has_node(const unsigned int number) const
{
  return std::any_of(
    node_numbers.begin(), node_numbers.end(), [&](const auto &of_element) {
      return std::find(of_element.begin(), of_element.end(), number) !=
             of_element.end();
    });
}



template <int dim>
unsigned int
Body<dim>::node_of_vertex(const unsigned int vertex) const
{
  for (unsigned int cell = 0; cell < mesh.cells.size(); ++cell)
    for (unsigned int v = 0; v < mesh.cells[cell].vertices.size(); ++v)
      if (mesh.cells[cell].vertices[v] == vertex)
        return node_numbers[cell][v];
  Assert(false, ExcMessage("Every vertex belongs to an element."));
  return numbers::invalid_unsigned_int;
}



template <int dim>
Body<dim>
make_box(const Point<dim> &size,
         const typename BoxNumbering<dim>::Indices &n_elements)
{
  Body<dim> body;
  body.box.emplace(n_elements);

  Triangulation<dim> triangulation;
  GridGenerator::subdivided_hyper_rectangle(
    triangulation,
    std::vector<unsigned int>(n_elements.begin(), n_elements.end()),
    Point<dim>(),
    size);
  SubCellData boundary;
  std::tie(body.mesh.vertices, body.mesh.cells, boundary) =
    GridTools::get_coarse_mesh_description(triangulation);

  body.node_numbers.resize(body.mesh.cells.size());
  for (unsigned int cell = 0; cell < body.mesh.cells.size(); ++cell)
    for (unsigned int node = 0; node < n_element_nodes<dim>; ++node)
      body.node_numbers[cell][node] = body.box->node_number(cell, node);

  const auto names = names_of_faces<dim>();
  for (unsigned int face = 0; face < names.size(); ++face)
    body.groups.push_back({names[face], int(face) + 1, dim - 1, {}, {}});
  for (const auto &cell : triangulation.active_cell_iterators())
    for (const unsigned int face : cell->face_indices())
      if (cell->face(face)->at_boundary())
        body.groups[face].entities.push_back(
          body.mesh.face_key({cell->index(), face}));
  return body;
}



template struct Body<2>;
template struct Body<3>;
template Body<2>
make_box(const Point<2> &, const BoxNumbering<2>::Indices &);
template Body<3>
make_box(const Point<3> &, const BoxNumbering<3>::Indices &);
} // namespace Setsudan
