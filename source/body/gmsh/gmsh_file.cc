// SPDX-License-Identifier: LGPL-2.1-or-later
#include <setsudan/body/directions.h>
#include <setsudan/body/gmsh/gmsh_checks.h>
#include <setsudan/body/gmsh/gmsh_elements.h>
#include <setsudan/body/gmsh/gmsh_file.h>
#include <setsudan/body/gmsh/gmsh_geometry.h>
#include <setsudan/body/gmsh/msh_file.h>
#include <setsudan/mesh/cell_lines.h>
#include <setsudan/mesh/face_index.h>
#include <setsudan/parameters/exceptions.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <filesystem>
#include <limits>
#include <unordered_map>

namespace Setsudan
{
using namespace dealii;

namespace
{
template <int dim>
constexpr unsigned int n_element_corners = GeometryInfo<dim>::vertices_per_cell;

GmshMesh
read_mesh(const std::string &file_name,
          const unsigned int dim,
          const double time_limit)
{
  const std::string extension =
    std::filesystem::path(file_name).extension().string();
  const TextFile file = read_text_file(file_name);
  check_encoding(file);
  if (extension == ".msh")
    return read_msh_file(file);
  if (extension != ".geo")
    throw BodyFileError(
      "the file is none of gmsh: its name ends neither in .msh nor in .geo");
  check_characters_of_geometry(file);
  return mesh_geometry(file_name, dim, time_limit);
}

/** An element's nodes must differ, and be somewhere, in 2D in the plane z = 0,
 * up to round-off against their distance from the origin. */
template <int dim>
void
check_nodes(const GmshMesh &mesh,
            const unsigned int element,
            std::vector<unsigned int> nodes)
{
  const std::string of_element = " of element " + std::to_string(element);
  for (const unsigned int node : nodes)
    {
      const auto &position  = mesh.find_node(node)->position;
      const double distance = position.norm();
      if (!std::isfinite(distance))
        throw BodyFileError("node " + std::to_string(node) + of_element +
                            " has no finite coordinates");
      if (dim == 2 && std::abs(position[2]) > 1e-12 * distance)
        throw BodyFileError("node " + std::to_string(node) + of_element +
                            " is not in the plane z = 0");
    }
  std::sort(nodes.begin(), nodes.end());
  const auto twice = std::adjacent_find(nodes.begin(), nodes.end());
  if (twice != nodes.end())
    throw BodyFileError("element " + std::to_string(element) +
                        " has the node " + std::to_string(*twice) + " twice");
}

/** The numbers of the nodes that are corners of elements, ascending. */
template <int dim>
std::vector<unsigned int>
collect_vertices(const GmshElements<dim> &elements)
{
  std::vector<unsigned int> numbers;
  numbers.reserve(elements.nodes.size() * n_element_corners<dim>);
  for (const auto &nodes : elements.nodes)
    numbers.insert(
      numbers.end(), nodes.begin(), nodes.begin() + n_element_corners<dim>);
  std::sort(numbers.begin(), numbers.end());
  numbers.erase(std::unique(numbers.begin(), numbers.end()), numbers.end());
  return numbers;
}

/** The numbers of nodes that belong to no element, among them what is left out
 * of the middle of faces and elements; ascending. */
template <int dim>
std::vector<unsigned int>
collect_unused_nodes(const GmshMesh &mesh, const GmshElements<dim> &elements)
{
  std::vector<bool> is_used(mesh.nodes.size());
  for (const auto &nodes : elements.nodes)
    for (const unsigned int number : nodes)
      if (number != numbers::invalid_unsigned_int)
        is_used[mesh.find_node(number) - mesh.nodes.data()] = true;
  std::vector<unsigned int> unused;
  for (std::size_t i = 0; i < is_used.size(); ++i)
    if (!is_used[i])
      unused.push_back(mesh.nodes[i].number);
  return unused;
}

/** The position of a node, in 2D without its third coordinate. */
template <int dim>
Point<dim>
position_of(const GmshMesh &mesh, const unsigned int node)
{
  const auto &in_space = mesh.find_node(node)->position;
  Point<dim> position;
  for (unsigned int d = 0; d < dim; ++d)
    position[d] = in_space[d];
  return position;
}

/** Give the middle nodes that the file does not have numbers from `next` on,
 * in the order in which the elements have them. */
template <int dim>
void
number_middle_nodes(std::uint64_t next, Body<dim> &body)
{
  std::unordered_map<std::uint64_t, unsigned int> number_of_line;
  for (unsigned int cell = 0; cell < body.mesh.cells.size(); ++cell)
    for (unsigned int node = n_element_corners<dim>;
         node < n_element_nodes<dim>;
         ++node)
      {
        const auto &vertices = body.mesh.cells[cell].vertices;
        const auto ends      = vertices_of_node<dim>(node);
        const auto [a, b] = std::minmax(vertices[ends[0]], vertices[ends[1]]);
        const auto [line, is_new] =
          number_of_line.try_emplace(std::uint64_t(a) << 32 | b, next);
        body.node_numbers[cell][node] = line->second;
        next += is_new;
      }
  if (next > std::numeric_limits<unsigned int>::max())
    throw BodyFileError(
      "node numbers are too large: none are left for the middle nodes");
}

/** The middle nodes' positions, or nothing if all are in the middle of
 * straight lines. */
template <int dim>
std::vector<typename CoarseMesh<dim>::LineNodes>
collect_line_nodes(const GmshMesh &mesh,
                   const GmshElements<dim> &elements,
                   const CoarseMesh<dim> &straight)
{
  // Relative to the line's length. gmsh itself is off by some 1e-12 on straight
  // lines, and the text of a file by its last digit.
  constexpr double tolerance = 1e-9;
  std::vector<typename CoarseMesh<dim>::LineNodes> line_nodes(
    elements.nodes.size());
  bool is_straight = true;
  for (unsigned int cell = 0; cell < line_nodes.size(); ++cell)
    {
      const auto middle = straight.node_positions(cell);
      for (unsigned int node = n_element_corners<dim>; node < middle.size();
           ++node)
        {
          const auto ends     = vertices_of_node<dim>(node);
          const double length = middle[ends[0]].distance(middle[ends[1]]);
          const auto position =
            position_of<dim>(mesh, elements.nodes[cell][node]);
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
make_body_of(const GmshMesh &mesh,
             const GmshElements<dim> &elements,
             const std::vector<unsigned int> &vertex_numbers)
{
  Body<dim> body;
  for (const unsigned int number : vertex_numbers)
    body.mesh.vertices.push_back(position_of<dim>(mesh, number));
  body.mesh.cells.resize(elements.nodes.size());
  for (unsigned int cell = 0; cell < body.mesh.cells.size(); ++cell)
    for (unsigned int v = 0; v < n_element_corners<dim>; ++v)
      body.mesh.cells[cell].vertices[v] =
        std::lower_bound(vertex_numbers.begin(),
                         vertex_numbers.end(),
                         elements.nodes[cell][v]) -
        vertex_numbers.begin();
  body.node_numbers = elements.nodes;
  body.unused_nodes = collect_unused_nodes(mesh, elements);
  if (elements.is_quadratic)
    body.mesh.line_nodes = collect_line_nodes(mesh, elements, body.mesh);
  make_counterclockwise(body);
  if (!elements.is_quadratic)
    number_middle_nodes(mesh.nodes.back().number + 1ull, body);
  return body;
}
} // namespace


template <int dim>
Body<dim>
read_gmsh_file(const std::string &file_name, const double time_limit)
{
  const auto mesh     = read_mesh(file_name, dim, time_limit);
  const auto elements = take_elements<dim>(mesh);
  for (unsigned int cell = 0; cell < elements.nodes.size(); ++cell)
    check_nodes<dim>(mesh,
                     elements.numbers[cell],
                     {elements.nodes[cell].begin(),
                      elements.nodes[cell].begin() +
                        (elements.is_quadratic ? n_element_nodes<dim>
                                               : n_element_corners<dim>)});

  const auto vertex_numbers = collect_vertices(elements);
  auto body                 = make_body_of(mesh, elements, vertex_numbers);
  const FaceIndex<dim> faces(body.mesh);
  const auto lines = collect_lines(body.mesh);
  check_body(body, faces, lines, vertex_numbers, elements.numbers);
  body.groups = elements.groups;
  address_vertices(faces, lines, vertex_numbers, body.groups);
  make_lines_consistent(body);
  return body;
}



template Body<2>
read_gmsh_file(const std::string &, const double);
template Body<3>
read_gmsh_file(const std::string &, const double);
} // namespace Setsudan
