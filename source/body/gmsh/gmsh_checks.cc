// SPDX-License-Identifier: LGPL-2.1-or-later
#include <setsudan/body/gmsh/gmsh_checks.h>
#include <setsudan/mesh/geometry.h>
#include <setsudan/mesh/node_order.h>
#include <setsudan/parameters/exceptions.h>

#include <algorithm>
#include <cmath>
#include <sstream>

namespace Setsudan
{
using namespace dealii;

namespace
{
/** Flatter elements are refused: their stiffness is round-off. */
constexpr double smallest_scaled_jacobian = 1e-8;

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

/** Checks a body, and names elements by the file's numbers. */
template <int dim>
class Check
{
public:
  Check(const Body<dim> &body, const std::vector<unsigned int> &element_numbers)
    : body(body)
    , element_numbers(element_numbers)
  {
  }

  void
  check_shape(const unsigned int cell) const
  {
    const auto nodes = body.mesh.node_positions(cell);
    for (unsigned int node = GeometryInfo<dim>::vertices_per_cell;
         body.mesh.is_curved() && node < nodes.size();
         ++node)
      check_middle_node(cell, node, nodes);
    const double jacobian = scaled_jacobian<dim>(nodes);
    // Also for positions that are no numbers.
    if (!(jacobian > smallest_scaled_jacobian))
      {
        std::ostringstream message;
        message << "element " << element_numbers[cell]
                << " is flat or inverted: its scaled Jacobian is " << jacobian;
        throw BodyFileError(message.str());
      }
  }

  void
  check_faces(const FaceIndex<dim> &faces) const
  {
    const auto &sorted = faces.faces();
    for (std::size_t i = 1; i < sorted.size(); ++i)
      if (sorted[i].first == sorted[i - 1].first)
        {
          const CellFace &a = sorted[i - 1].second, &b = sorted[i].second;
          const bool is_third =
            i >= 2 && sorted[i].first == sorted[i - 2].first;
          if (!is_third && are_opposite(body.mesh, a, b))
            continue;
          const std::string both = number(a.first) + " and " + number(b.first);
          throw BodyFileError(
            "the elements " +
            (is_third ? number(sorted[i - 2].second.first) + ", " + both +
                          " share one face, which only two can"
                      : both + " lie on the same side of a face that they "
                               "share"));
        }
  }

  void
  check_lines(const std::vector<CellLine> &lines,
              const std::vector<unsigned int> &vertex_numbers) const
  {
    std::vector<CellLine> distinct;
    for (const CellLine &line : lines)
      if (distinct.empty() || distinct.back().vertices != line.vertices)
        distinct.push_back(line);
      else if (middle(distinct.back()) != middle(line))
        throw BodyFileError(
          "the elements " + number(distinct.back().cell) + " and " +
          number(line.cell) +
          " do not conform: on the line that they share they have the "
          "different middle nodes " +
          std::to_string(middle(distinct.back())) + " and " +
          std::to_string(middle(line)));

    std::sort(distinct.begin(),
              distinct.end(),
              [&](const CellLine &a, const CellLine &b) {
                return middle(a) < middle(b);
              });
    for (std::size_t i = 0; i < distinct.size(); ++i)
      {
        const unsigned int node   = middle(distinct[i]);
        const std::string element = number(distinct[i].cell);
        if (i > 0 && middle(distinct[i - 1]) == node)
          throw BodyFileError(
            "node " + std::to_string(node) +
            " is the middle node of different lines, in the elements " +
            number(distinct[i - 1].cell) + " and " + element);
        if (std::binary_search(
              vertex_numbers.begin(), vertex_numbers.end(), node))
          throw BodyFileError("node " + std::to_string(node) +
                              " is a middle node of element " + element +
                              " and a corner of another");
      }
  }

private:
  std::string
  number(const unsigned int cell) const
  {
    return std::to_string(element_numbers[cell]);
  }

  unsigned int
  middle(const CellLine &line) const
  {
    return body.node_numbers[line.cell][line.node];
  }

  void
  check_middle_node(const unsigned int cell,
                    const unsigned int node,
                    const ElementNodes<dim> &nodes) const
  {
    const double way         = std::abs(place_on_line<dim>(nodes, node) - 0.5);
    const bool is_at_quarter = std::abs(way - largest_way_from_middle) < 1e-6;
    if (!is_at_quarter && is_in_middle<dim>(nodes, node))
      return;
    throw BodyFileError(
      "node " + std::to_string(body.node_numbers[cell][node]) + " of element " +
      number(cell) + " is a middle node" +
      (is_at_quarter
         ? " at a quarter of its line: singular elements of fracture "
           "mechanics cannot be computed here; move it into the middle"
         : ", but outside of the middle half of its line") +
      (!is_at_quarter && is_in_order_of_vtk<dim>(nodes)
         ? "; the file seems to list the nodes in the order of VTK and Abaqus, "
           "in which all of them are in the middle: write them in gmsh's order"
         : ""));
  }

  const Body<dim> &body;
  const std::vector<unsigned int> &element_numbers;
};
} // namespace


template <int dim>
void
check_body(const Body<dim> &body,
           const FaceIndex<dim> &faces,
           const std::vector<CellLine> &lines,
           const std::vector<unsigned int> &vertex_numbers,
           const std::vector<unsigned int> &element_numbers)
{
  const Check<dim> check(body, element_numbers);
  for (unsigned int cell = 0; cell < body.mesh.cells.size(); ++cell)
    check.check_shape(cell);
  check.check_faces(faces);
  check.check_lines(lines, vertex_numbers);
}



template void
check_body(const Body<2> &,
           const FaceIndex<2> &,
           const std::vector<CellLine> &,
           const std::vector<unsigned int> &,
           const std::vector<unsigned int> &);
template void
check_body(const Body<3> &,
           const FaceIndex<3> &,
           const std::vector<CellLine> &,
           const std::vector<unsigned int> &,
           const std::vector<unsigned int> &);
} // namespace Setsudan
