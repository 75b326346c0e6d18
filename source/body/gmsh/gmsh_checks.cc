// SPDX-License-Identifier: LGPL-2.1-or-later
#include <setsudan/body/gmsh/gmsh_checks.h>
#include <setsudan/mesh/geometry.h>
#include <setsudan/mesh/node_order.h>

#include <algorithm>
#include <cmath>
#include <sstream>
#include <stdexcept>

namespace Setsudan
{
using namespace dealii;

namespace
{
/** Flatter elements are refused: their stiffness is round-off. */
constexpr double smallest_scaled_jacobian = 1e-8;

/** Throw a sentence composed of the parts. */
template <typename... Parts>
[[noreturn]] void
refuse(const Parts &...parts)
{
  std::ostringstream message;
  (message << ... << parts);
  throw std::runtime_error(message.str());
}

/** Where a middle node lies along the straight line between its ends: 0 and 1
 * are the ends. */
template <int dim>
double
place_on_line(const ElementNodes<dim> &nodes, const unsigned int node)
{
  const auto ends  = vertices_of_node<dim>(node);
  const auto chord = nodes[ends[1]] - nodes[ends[0]];
  return ((nodes[node] - nodes[ends[0]]) * chord) / chord.norm_square();
}

/** Where they must lie, from the middle. Behind it the element is inverted at
 * the end of the line, and there, at a quarter, its strain is singular. */
constexpr double largest_way_from_middle = 0.25;

template <int dim>
bool
is_in_middle(const ElementNodes<dim> &nodes, const unsigned int node)
{
  return std::abs(place_on_line<dim>(nodes, node) - 0.5) <=
         largest_way_from_middle;
}

/** Whether a file of gmsh seems to list the nodes of an element as VTK does: so
 * all middle nodes are in the middle of their lines. */
template <int dim>
bool
is_in_order_of_vtk(const ElementNodes<dim> &nodes)
{
  const auto gmsh = node_order<dim>(gmsh_edges<dim>());
  const auto vtk  = node_order<dim>(vtk_edges<dim>());
  ElementNodes<dim> read_as_vtk;
  for (unsigned int i = 0; i < nodes.size(); ++i)
    read_as_vtk[vtk[i]] = nodes[gmsh[i]];
  bool fits = true;
  for (unsigned int node = GeometryInfo<dim>::vertices_per_cell;
       node < nodes.size();
       ++node)
    fits = fits && is_in_middle<dim>(read_as_vtk, node);
  return fits;
}

/** Refuse middle nodes that are not in the middle of an element's lines. */
template <int dim>
void
check_middle_nodes(const Body<dim> &body,
                   const unsigned int cell,
                   const std::size_t element_number)
{
  constexpr double round_off = 1e-6;
  const auto nodes           = body.mesh.node_positions(cell);
  for (unsigned int node = GeometryInfo<dim>::vertices_per_cell;
       node < nodes.size();
       ++node)
    {
      const double way  = std::abs(place_on_line<dim>(nodes, node) - 0.5);
      const auto number = body.node_numbers[cell][node];
      if (std::abs(way - largest_way_from_middle) < round_off)
        refuse("node ",
               number,
               " of element ",
               element_number,
               " is a middle node at a quarter of its line: singular elements "
               "of fracture mechanics cannot be computed here; move it into "
               "the middle");
      if (!is_in_middle<dim>(nodes, node))
        refuse("node ",
               number,
               " of element ",
               element_number,
               " is a middle node, but outside of the middle half of its line",
               is_in_order_of_vtk<dim>(nodes)
                 ? "; the file seems to list the nodes in the order of VTK and "
                   "Abaqus, in which all of them are in the middle: write them "
                   "in gmsh's order"
                 : "");
    }
}

/** The corners of a face around it as seen from outside of the cell,
 * counterclockwise, from the smallest vertex. */
template <int dim>
std::vector<unsigned int>
face_from_outside(const CoarseMesh<dim> &mesh, const CellFace &face)
{
  // In deal.II's order, faces have their normals along the axes of the
  // reference cell; in 2D, lines have them to the right.
  const bool is_reversed =
    dim == 3 ? face.second % 2 == 0 : face.second == 0 || face.second == 3;
  std::vector<unsigned int> corners = dim == 3
                                        ? std::vector<unsigned int>{0, 1, 3, 2}
                                        : std::vector<unsigned int>{0, 1};
  if (is_reversed)
    std::reverse(corners.begin(), corners.end());
  for (unsigned int &corner : corners)
    corner =
      mesh.cells[face.first].vertices[GeometryInfo<dim>::face_to_cell_vertices(
        face.second, corner)];
  if (dim == 3)
    std::rotate(corners.begin(),
                std::min_element(corners.begin(), corners.end()),
                corners.end());
  return corners;
}

/** Whether two cells that share a face lie on different sides of it. */
template <int dim>
bool
are_opposite(const CoarseMesh<dim> &mesh, const CellFace &a, const CellFace &b)
{
  auto corners = face_from_outside(mesh, a);
  std::reverse(dim == 3 ? corners.begin() + 1 : corners.begin(), corners.end());
  return corners == face_from_outside(mesh, b);
}
} // namespace


template <int dim>
void
check_shapes(const Body<dim> &body,
             const std::vector<std::size_t> &element_numbers)
{
  for (unsigned int cell = 0; cell < body.mesh.cells.size(); ++cell)
    {
      if (body.mesh.is_curved())
        check_middle_nodes(body, cell, element_numbers[cell]);
      const double jacobian =
        scaled_jacobian<dim>(body.mesh.node_positions(cell));
      // Also for positions that are no numbers.
      if (!(jacobian > smallest_scaled_jacobian))
        refuse("element ",
               element_numbers[cell],
               " is flat or inverted: its scaled Jacobian is ",
               jacobian);
    }
}



template <int dim>
void
check_faces(const Body<dim> &body,
            const FaceIndex<dim> &faces,
            const std::vector<std::size_t> &element_numbers)
{
  const auto &sorted = faces.faces();
  for (std::size_t i = 1; i < sorted.size(); ++i)
    if (sorted[i].first == sorted[i - 1].first)
      {
        const CellFace &a = sorted[i - 1].second, &b = sorted[i].second;
        if (i >= 2 && sorted[i].first == sorted[i - 2].first)
          refuse("the elements ",
                 element_numbers[sorted[i - 2].second.first],
                 ", ",
                 element_numbers[a.first],
                 " and ",
                 element_numbers[b.first],
                 " share one face, which only two can");
        if (!are_opposite(body.mesh, a, b))
          refuse("the elements ",
                 element_numbers[a.first],
                 " and ",
                 element_numbers[b.first],
                 " lie on the same side of a face that they share");
      }
}



template <int dim>
void
check_lines(const Body<dim> &body,
            const std::vector<CellLine> &lines,
            const std::vector<unsigned int> &vertex_numbers,
            const std::vector<std::size_t> &element_numbers)
{
  const auto middle = [&](const CellLine &line) {
    return body.node_numbers[line.cell][line.node];
  };
  std::vector<CellLine> distinct;
  for (const CellLine &line : lines)
    if (distinct.empty() || distinct.back().vertices != line.vertices)
      distinct.push_back(line);
    else if (middle(distinct.back()) != middle(line))
      refuse("the elements ",
             element_numbers[distinct.back().cell],
             " and ",
             element_numbers[line.cell],
             " do not conform: on the line that they share they have the "
             "different middle nodes ",
             middle(distinct.back()),
             " and ",
             middle(line));

  std::sort(distinct.begin(),
            distinct.end(),
            [&](const CellLine &a, const CellLine &b) {
              return middle(a) < middle(b);
            });
  for (std::size_t i = 0; i < distinct.size(); ++i)
    {
      const unsigned int node   = middle(distinct[i]);
      const std::size_t element = element_numbers[distinct[i].cell];
      if (i > 0 && middle(distinct[i - 1]) == node)
        refuse("node ",
               node,
               " is the middle node of different lines, in the elements ",
               element_numbers[distinct[i - 1].cell],
               " and ",
               element);
      if (std::binary_search(
            vertex_numbers.begin(), vertex_numbers.end(), node))
        refuse("node ",
               node,
               " is a middle node of element ",
               element,
               " and a corner of another");
    }
}



template void
check_shapes(const Body<2> &, const std::vector<std::size_t> &);
template void
check_shapes(const Body<3> &, const std::vector<std::size_t> &);
template void
check_faces(const Body<2> &,
            const FaceIndex<2> &,
            const std::vector<std::size_t> &);
template void
check_faces(const Body<3> &,
            const FaceIndex<3> &,
            const std::vector<std::size_t> &);
template void
check_lines(const Body<2> &,
            const std::vector<CellLine> &,
            const std::vector<unsigned int> &,
            const std::vector<std::size_t> &);
template void
check_lines(const Body<3> &,
            const std::vector<CellLine> &,
            const std::vector<unsigned int> &,
            const std::vector<std::size_t> &);
} // namespace Setsudan
