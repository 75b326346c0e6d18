// SPDX-License-Identifier: LGPL-2.1-or-later
#include <setsudan/mechanics/pieces/hinges.h>
#include <setsudan/mechanics/pieces/piece_motions.h>
#include <setsudan/mesh/pieces.h>

#include <algorithm>
#include <set>
#include <sstream>

namespace Setsudan
{
using namespace dealii;

namespace
{
/** The parts at each vertex. */
template <int dim>
std::vector<std::set<unsigned int>>
collect_parts_of_vertices(const CoarseMesh<dim> &mesh,
                          const std::vector<unsigned int> &parts)
{
  std::vector<std::set<unsigned int>> of_vertex(mesh.vertices.size());
  for (unsigned int cell = 0; cell < mesh.cells.size(); ++cell)
    for (const unsigned int vertex : mesh.cells[cell].vertices)
      of_vertex[vertex].insert(parts[cell]);
  return of_vertex;
}

/** Parts move alike at the vertices that they share. */
template <int dim>
std::vector<PieceLink<dim>>
link_parts(const CoarseMesh<dim> &mesh,
           const std::vector<std::set<unsigned int>> &parts_of_vertices)
{
  std::vector<PieceLink<dim>> links;
  for (unsigned int vertex = 0; vertex < mesh.vertices.size(); ++vertex)
    {
      const auto &parts = parts_of_vertices[vertex];
      for (const unsigned int part : parts)
        if (part != *parts.begin())
          for (unsigned int c = 0; c < dim; ++c)
            links.push_back({{{*parts.begin(), part}},
                             mesh.vertices[vertex],
                             Tensor<1, dim>(Point<dim>::unit_vector(c))});
    }
  return links;
}

/** The nodes by which a part is joined to others: "1 and 2", or the first ones.
 */
template <int dim>
std::string
list_joints(const Body<dim> &body,
            const std::vector<std::set<unsigned int>> &parts_of_vertices,
            const unsigned int part)
{
  constexpr unsigned int n_listed = 5;
  std::vector<unsigned int> vertices;
  for (unsigned int vertex = 0; vertex < parts_of_vertices.size(); ++vertex)
    if (parts_of_vertices[vertex].size() > 1 &&
        parts_of_vertices[vertex].count(part) > 0)
      vertices.push_back(vertex);
  if (vertices.empty())
    return "not joined to any other";
  std::ostringstream text;
  text << "joined to others by the node" << (vertices.size() == 1 ? "" : "s");
  for (unsigned int i = 0; i < std::min<std::size_t>(n_listed, vertices.size());
       ++i)
    text << (i == 0 ? " " : ", ") << body.node_of_vertex(vertices[i]);
  text << (vertices.size() > n_listed ? ", ... only" : " only");
  return text.str();
}

/** The mean of a part's elements. */
template <int dim>
std::string
describe_center(const CoarseMesh<dim> &mesh,
                const std::vector<unsigned int> &parts,
                const unsigned int part)
{
  Point<dim> center;
  const double n = std::count(parts.begin(), parts.end(), part);
  for (unsigned int cell = 0; cell < parts.size(); ++cell)
    if (parts[cell] == part)
      center += mesh.cell_center(cell) / n;
  std::ostringstream text;
  text.precision(4);
  text << n << (n == 1 ? " element" : " elements") << " around (";
  for (unsigned int d = 0; d < dim; ++d)
    text << (d == 0 ? "" : ", ") << center[d];
  text << ")";
  return text.str();
}
} // namespace


template <int dim>
std::optional<std::string>
describe_loose_part(const Body<dim> &body, const Supports<dim> &supports)
{
  if (body.box)
    return {};
  const auto parts = find_pieces(body.mesh);
  if (*std::max_element(parts.begin(), parts.end()) == 0)
    return {};
  const PieceMotions<dim> motions(body.mesh, parts, supports);
  if (motions.all_held())
    return {};
  const auto parts_of_vertices = collect_parts_of_vertices(body.mesh, parts);
  const auto groups =
    motions.find_floating(link_parts(body.mesh, parts_of_vertices));
  if (groups.empty())
    return {};
  std::size_t n_ways = 0;
  for (const auto &loose : groups.front().loose)
    n_ways += loose.hold.size();
  const unsigned int part = groups.front().loose.front().piece;
  return "the part of " + describe_center(body.mesh, parts, part) + " is " +
         list_joints(body, parts_of_vertices, part) +
         ", and free to move rigidly in " + std::to_string(n_ways) +
         (n_ways == 1 ? " way" : " ways") + ": join it by faces, or hold it";
}



template std::optional<std::string>
describe_loose_part(const Body<2> &, const Supports<2> &);
template std::optional<std::string>
describe_loose_part(const Body<3> &, const Supports<3> &);
} // namespace Setsudan
