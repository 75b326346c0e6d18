// SPDX-License-Identifier: LGPL-2.1-or-later
#include <deal.II/base/mpi.h>

#include <setsudan/mesh/geometry.h>
#include <setsudan/output/pieces/piece_groups.h>
#include <setsudan/output/pieces/piece_mesh.h>

#include <algorithm>
#include <map>
#include <tuple>

namespace Setsudan
{
using namespace dealii;

namespace
{
/** What tells nodes of a mesh apart, in the order of their numbers: first the
 * number in the uncut body, then the vertices between which it lies. */
using NodeName = std::tuple<unsigned int, unsigned int, unsigned int>;

template <int dim>
NodeName
name_of_node(const CoarseMesh<dim> &mesh,
             const Body<dim> &body,
             const unsigned int element,
             const unsigned int node)
{
  const auto ends          = vertices_of_node<dim>(node);
  const auto &vertices     = mesh.cells[element].vertices;
  const auto [first, last] = std::minmax(vertices[ends[0]], vertices[ends[1]]);
  return {body.node_numbers[element][node], first, last};
}
} // namespace


template <int dim>
double
PieceMesh<dim>::volume() const
{
  double volume = 0;
  for (const auto &element : elements)
    {
      ElementNodes<dim> positions;
      for (unsigned int node = 0; node < element.size(); ++node)
        positions[node] = nodes[element[node]];
      volume += volume_of_element<dim>(positions);
    }
  return volume;
}



template <int dim>
std::vector<PieceMesh<dim>>
make_piece_meshes(const CoarseMesh<dim> &mesh,
                  const std::vector<unsigned int> &pieces,
                  const Body<dim> &body)
{
  std::vector<PieceMesh<dim>> meshes(
    *std::max_element(pieces.begin(), pieces.end()) + 1);
  std::vector<std::map<NodeName, unsigned int>> numbers(meshes.size());
  for (unsigned int element = 0; element < pieces.size(); ++element)
    {
      meshes[pieces[element]].elements_in_body.push_back(element);
      for (unsigned int node = 0; node < n_element_nodes<dim>; ++node)
        numbers[pieces[element]][name_of_node(mesh, body, element, node)];
    }
  const auto opened = find_opened_faces(mesh, body);
  for (unsigned int p = 0; p < meshes.size(); ++p)
    {
      unsigned int next = 0;
      for (auto &[name, number] : numbers[p])
        {
          number = next++;
          meshes[p].numbers_in_body.push_back(std::get<0>(name));
        }
      meshes[p].nodes.resize(next);
      for (const unsigned int element : meshes[p].elements_in_body)
        {
          auto &nodes = meshes[p].elements.emplace_back();
          for (unsigned int node = 0; node < nodes.size(); ++node)
            {
              nodes[node] =
                numbers[p].at(name_of_node(mesh, body, element, node));
              meshes[p].nodes[nodes[node]] = mesh.node_position(element, node);
            }
        }
      meshes[p].groups = collect_piece_groups(meshes[p], opened, body);
    }
  return meshes;
}



template <int dim>
ElementDisplacements<dim>
gather_displacements(const Discretization<dim> &discretization,
                     const unsigned int n_elements,
                     const LA::Vector &displacement)
{
  // Element, node, and the displacement there.
  using Entry = std::tuple<unsigned int, unsigned int, Tensor<1, dim>>;
  std::vector<Entry> own;
  for (const auto &cell : discretization.dof_handler.active_cell_iterators())
    if (cell->is_locally_owned())
      {
        const CellPath path = path_of_cell<dim>(cell);
        const auto nodes    = discretization.node_indices(cell);
        for (unsigned int n = 0; n < n_element_nodes<dim>; ++n)
          if (const auto node = node_at(
                point_in_element<dim>(path, unit_point_of_node<dim>(n))))
            {
              // A linear element has straight lines, whose middles these are.
              const auto ends = n < nodes.size()
                                  ? std::array<unsigned int, 2>{{n, n}}
                                  : vertices_of_node<dim>(n);
              Tensor<1, dim> u;
              for (unsigned int c = 0; c < dim; ++c)
                u[c] = (displacement(nodes[ends[0]][c]) +
                        displacement(nodes[ends[1]][c])) /
                       2;
              own.emplace_back(discretization.element(cell), *node, u);
            }
      }
  ElementDisplacements<dim> result;
  const auto parts = Utilities::MPI::gather(discretization.communicator, own);
  if (!parts.empty())
    result.resize(n_elements);
  for (const auto &part : parts)
    for (const auto &[element, node, u] : part)
      result[element][node] = u;
  return result;
}



template <int dim>
void
set_displacements(const ElementDisplacements<dim> &displacements,
                  PieceMesh<dim> &piece)
{
  piece.displacements.resize(piece.nodes.size());
  for (unsigned int e = 0; e < piece.elements.size(); ++e)
    for (unsigned int node = 0; node < n_element_nodes<dim>; ++node)
      piece.displacements[piece.elements[e][node]] =
        Point<dim>(displacements[piece.elements_in_body[e]][node]);
}



template <int dim>
void
deform(PieceMesh<dim> &piece)
{
  for (unsigned int node = 0; node < piece.nodes.size(); ++node)
    piece.nodes[node] += piece.displacements[node];
}



template struct PieceMesh<2>;
template std::vector<PieceMesh<2>>
make_piece_meshes(const CoarseMesh<2> &,
                  const std::vector<unsigned int> &,
                  const Body<2> &);
template ElementDisplacements<2>
gather_displacements(const Discretization<2> &,
                     const unsigned int,
                     const LA::Vector &);
template void
set_displacements(const ElementDisplacements<2> &, PieceMesh<2> &);
template void
deform(PieceMesh<2> &);
template struct PieceMesh<3>;
template std::vector<PieceMesh<3>>
make_piece_meshes(const CoarseMesh<3> &,
                  const std::vector<unsigned int> &,
                  const Body<3> &);
template ElementDisplacements<3>
gather_displacements(const Discretization<3> &,
                     const unsigned int,
                     const LA::Vector &);
template void
set_displacements(const ElementDisplacements<3> &, PieceMesh<3> &);
template void
deform(PieceMesh<3> &);
} // namespace Setsudan
