// SPDX-License-Identifier: LGPL-2.1-or-later
#include <setsudan/body/directions.h>
#include <setsudan/body/gmsh/gmsh_checks.h>
#include <setsudan/body/gmsh/gmsh_entities.h>
#include <setsudan/body/gmsh/gmsh_file.h>
#include <setsudan/body/gmsh/gmsh_mesh.h>
#include <setsudan/body/gmsh/gmsh_outline.h>
#include <setsudan/mesh/cell_lines.h>
#include <setsudan/mesh/face_index.h>

#include <algorithm>
#include <cmath>
#include <iterator>
#include <limits>
#include <stdexcept>
#include <tuple>

namespace Setsudan
{
using namespace dealii;

namespace
{
template <int dim>
constexpr unsigned int n_element_corners = GeometryInfo<dim>::vertices_per_cell;

template <int dim>
void
check_nodes_differ(const GmshMesh<dim> &file)
{
  const unsigned int n_nodes =
    file.is_quadratic ? n_element_nodes<dim> : n_element_corners<dim>;
  std::vector<unsigned int> nodes;
  for (unsigned int cell = 0; cell < file.elements.size(); ++cell)
    {
      const auto &of_cell = file.elements[cell];
      nodes.assign(of_cell.begin(), of_cell.begin() + n_nodes);
      std::sort(nodes.begin(), nodes.end());
      const auto twice = std::adjacent_find(nodes.begin(), nodes.end());
      if (twice != nodes.end())
        throw std::runtime_error(
          "element " + std::to_string(file.element_numbers[cell]) +
          " has the node " + std::to_string(*twice) + " twice");
    }
}

/** The numbers of the nodes that are corners of elements, ascending. */
template <int dim>
std::vector<unsigned int>
collect_vertices(const GmshMesh<dim> &file)
{
  std::vector<unsigned int> numbers;
  numbers.reserve(file.elements.size() * n_element_corners<dim>);
  for (const auto &nodes : file.elements)
    numbers.insert(
      numbers.end(), nodes.begin(), nodes.begin() + n_element_corners<dim>);
  std::sort(numbers.begin(), numbers.end());
  numbers.erase(std::unique(numbers.begin(), numbers.end()), numbers.end());
  return numbers;
}

/** Those of some numbers of nodes that belong to no element, among them what is
 * left out of the middle of faces and elements; all ascending. */
template <int dim>
std::vector<unsigned int>
collect_unused_nodes(const GmshMesh<dim> &file,
                     const std::vector<unsigned int> &node_numbers)
{
  std::vector<unsigned int> used, unused;
  used.reserve(file.elements.size() * n_element_nodes<dim>);
  for (const auto &nodes : file.elements)
    used.insert(used.end(), nodes.begin(), nodes.end());
  std::sort(used.begin(), used.end());
  std::set_difference(node_numbers.begin(),
                      node_numbers.end(),
                      used.begin(),
                      used.end(),
                      std::back_inserter(unused));
  return unused;
}

/** The position of a node, in 2D without its third coordinate. */
template <int dim>
Point<dim>
position_of(const GmshMesh<dim> &file, const unsigned int node)
{
  const auto &in_space = file.position(node);
  Point<dim> position;
  for (unsigned int d = 0; d < dim; ++d)
    position[d] = in_space[d];
  return position;
}

/** Nodes must be somewhere, in 2D in the plane z = 0, up to round-off against
 * their distance from the origin. */
template <int dim>
void
check_positions(const GmshMesh<dim> &file)
{
  const auto refuse = [&](const unsigned int node,
                          const unsigned int cell,
                          const char *why) {
    throw std::runtime_error("node " + std::to_string(node) + " of element " +
                             std::to_string(file.element_numbers[cell]) + why);
  };
  for (unsigned int cell = 0; cell < file.elements.size(); ++cell)
    for (const unsigned int node : file.elements[cell])
      if (node != numbers::invalid_unsigned_int)
        {
          const auto &position  = file.position(node);
          const double distance = position.norm();
          if (!std::isfinite(distance))
            refuse(node, cell, " has no finite coordinates");
          if (dim == 2 && std::abs(position[2]) > 1e-12 * distance)
            refuse(node, cell, " is not in the plane z = 0");
        }
}

template <int dim>
std::vector<CellData<dim>>
make_cells(const GmshMesh<dim> &file,
           const std::vector<unsigned int> &vertex_numbers)
{
  std::vector<CellData<dim>> cells(file.elements.size());
  for (unsigned int cell = 0; cell < cells.size(); ++cell)
    for (unsigned int v = 0; v < n_element_corners<dim>; ++v)
      cells[cell].vertices[v] = std::lower_bound(vertex_numbers.begin(),
                                                 vertex_numbers.end(),
                                                 file.elements[cell][v]) -
                                vertex_numbers.begin();
  return cells;
}

/** Give the middle nodes that the file does not have numbers from `next` on,
 * in the order in which the elements have them. */
template <int dim>
void
number_middle_nodes(const std::vector<CellLine> &lines,
                    const std::size_t next,
                    Body<dim> &body)
{
  // The place of each line's first appearance, and the numbers in their order.
  std::vector<std::size_t> first;
  for (std::size_t i = 0; i < lines.size(); ++i)
    if (i == 0 || lines[i].vertices != lines[i - 1].vertices)
      first.push_back(i);
  std::sort(
    first.begin(), first.end(), [&](const std::size_t a, const std::size_t b) {
      return std::tie(lines[a].cell, lines[a].node) <
             std::tie(lines[b].cell, lines[b].node);
    });
  if (next + first.size() > std::numeric_limits<unsigned int>::max())
    throw std::runtime_error(
      "node numbers are too large: none are left for the middle nodes");
  for (std::size_t n = 0; n < first.size(); ++n)
    for (std::size_t i = first[n];
         i < lines.size() && lines[i].vertices == lines[first[n]].vertices;
         ++i)
      body.node_numbers[lines[i].cell][lines[i].node] = next + n;
}

/** The middle nodes' positions, or nothing if all are in the middle of
 * straight lines. */
template <int dim>
std::vector<typename CoarseMesh<dim>::LineNodes>
collect_line_nodes(const GmshMesh<dim> &file, const CoarseMesh<dim> &straight)
{
  // Relative to the line's length. gmsh itself is off by some 1e-12 on straight
  // lines, and the text of a file by its last digit.
  constexpr double tolerance = 1e-9;
  std::vector<typename CoarseMesh<dim>::LineNodes> line_nodes(
    file.elements.size());
  bool is_straight = true;
  for (unsigned int cell = 0; cell < line_nodes.size(); ++cell)
    {
      const auto middle = straight.node_positions(cell);
      for (unsigned int node = n_element_corners<dim>; node < middle.size();
           ++node)
        {
          const auto ends     = vertices_of_node<dim>(node);
          const double length = middle[ends[0]].distance(middle[ends[1]]);
          const auto position = position_of(file, file.elements[cell][node]);
          line_nodes[cell][node - n_element_corners<dim>] = position;
          is_straight                                     = is_straight &&
                        position.distance(middle[node]) <= tolerance * length;
        }
    }
  if (is_straight)
    line_nodes.clear();
  return line_nodes;
}

/** The elements and their nodes as the file lists them. */
template <int dim>
Body<dim>
take_elements(const GmshMesh<dim> &file,
              const std::vector<unsigned int> &vertex_numbers)
{
  Body<dim> body;
  for (const unsigned int number : vertex_numbers)
    body.mesh.vertices.push_back(position_of(file, number));
  body.mesh.cells   = make_cells(file, vertex_numbers);
  body.node_numbers = file.elements;
  if (file.is_quadratic)
    body.mesh.line_nodes = collect_line_nodes(file, body.mesh);
  return body;
}
} // namespace


template <int dim>
Body<dim>
read_gmsh_file(const std::string &file_name, const double time_limit)
{
  const auto outline = outline_gmsh_file(file_name);
  const auto file    = load_gmsh_mesh<dim>(file_name, outline, time_limit);
  check_nodes_differ(file);
  check_positions(file);

  const auto vertex_numbers = collect_vertices(file);
  auto body                 = take_elements(file, vertex_numbers);
  make_counterclockwise(body);
  const FaceIndex<dim> faces(body.mesh);
  const auto lines = collect_lines(body.mesh);
  const auto &node_numbers =
    outline.is_geometry ? file.node_numbers : outline.node_numbers;
  body.unused_nodes = collect_unused_nodes(file, node_numbers);
  if (!file.is_quadratic)
    number_middle_nodes(lines, node_numbers.back() + 1ull, body);

  check_shapes(body, file.element_numbers);
  check_faces(body, faces, file.element_numbers);
  check_lines(body, lines, vertex_numbers, file.element_numbers);
  body.groups = file.groups;
  address_vertices(faces, lines, vertex_numbers, body.groups);
  make_lines_consistent(body);
  return body;
}



template Body<2>
read_gmsh_file(const std::string &, const double);
template Body<3>
read_gmsh_file(const std::string &, const double);
} // namespace Setsudan
