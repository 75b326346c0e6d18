// SPDX-License-Identifier: LGPL-2.1-or-later
#include <deal.II/numerics/rtree.h>

#include <setsudan/body/joints.h>
#include <setsudan/mesh/face_index.h>
#include <setsudan/mesh/overlapping_faces.h>
#include <setsudan/mesh/pieces.h>

#include <algorithm>
#include <cmath>
#include <iterator>
#include <numeric>
#include <sstream>

namespace Setsudan
{
using namespace dealii;

namespace
{
/** Up to which vertices are in one place, relative to their shortest line. */
constexpr double tolerance_of_vertices = 1e-6;

template <int dim>
std::vector<CellFace>
collect_surface(const CoarseMesh<dim> &mesh)
{
  const FaceIndex<dim> index(mesh);
  const auto &faces = index.faces();
  std::vector<CellFace> surface;
  for (std::size_t i = 0; i < faces.size(); ++i)
    if ((i == 0 || faces[i].first != faces[i - 1].first) &&
        (i + 1 == faces.size() || faces[i].first != faces[i + 1].first))
      surface.push_back(faces[i].second);
  return surface;
}

/** The vertices that have something to do with the surface, ascending, each
 * with the shortest line of its faces. */
template <int dim>
std::vector<std::pair<unsigned int, double>>
measure_vertices(const CoarseMesh<dim> &mesh,
                 const std::vector<CellFace> &surface)
{
  std::vector<std::pair<unsigned int, double>> lengths;
  for (const auto &[cell, face] : surface)
    for (unsigned int node = GeometryInfo<dim>::vertices_per_cell;
         node < n_element_nodes<dim>;
         ++node)
      if (node_is_on_face<dim>(node, face))
        {
          const auto ends     = vertices_of_node<dim>(node);
          const auto &of_cell = mesh.cells[cell].vertices;
          const double length = mesh.vertices[of_cell[ends[0]]].distance(
            mesh.vertices[of_cell[ends[1]]]);
          for (const unsigned int end : ends)
            lengths.emplace_back(of_cell[end], length);
        }
  std::sort(lengths.begin(), lengths.end());
  lengths.erase(std::unique(lengths.begin(),
                            lengths.end(),
                            [](const auto &a, const auto &b) {
                              return a.first == b.first;
                            }),
                lengths.end());
  return lengths;
}

/** For each vertex the smallest one in its place. */
template <int dim>
std::vector<unsigned int>
find_places(const CoarseMesh<dim> &mesh, const std::vector<CellFace> &surface)
{
  std::vector<unsigned int> places(mesh.vertices.size());
  std::iota(places.begin(), places.end(), 0);
  const auto vertices = measure_vertices(mesh, surface);
  std::vector<Point<dim>> points;
  for (const auto &[vertex, length] : vertices)
    points.push_back(mesh.vertices[vertex]);
  const auto tree = pack_rtree_of_indices(points);
  std::vector<unsigned int> found;
  for (unsigned int i = 0; i < vertices.size(); ++i)
    {
      BoundingBox<dim> box({points[i], points[i]});
      box.extend(tolerance_of_vertices * vertices[i].second);
      found.clear();
      tree.query(boost::geometry::index::intersects(box),
                 std::back_inserter(found));
      for (const unsigned int other : found)
        places[vertices[i].first] =
          std::min(places[vertices[i].first], vertices[other].first);
    }
  return places;
}

FoundPlaces
find_coincident(const std::vector<unsigned int> &places)
{
  FoundPlaces found;
  std::vector<unsigned int> occupied;
  for (unsigned int vertex = 0; vertex < places.size(); ++vertex)
    if (places[vertex] != vertex)
      occupied.push_back(places[vertex]);
  std::sort(occupied.begin(), occupied.end());
  occupied.erase(std::unique(occupied.begin(), occupied.end()), occupied.end());
  found.n = occupied.size();
  for (unsigned int vertex = 0; vertex < places.size() && found.n > 0; ++vertex)
    if (places[vertex] == occupied.front())
      found.vertices.push_back(vertex);
  return found;
}

template <int dim>
FoundPlaces
find_overlapping(const CoarseMesh<dim> &mesh,
                 const std::vector<CellFace> &surface,
                 const std::vector<unsigned int> &places)
{
  const auto faces = find_overlapping_faces(mesh, surface, places);
  FoundPlaces found;
  found.n = faces.size();
  if (found.n > 0)
    {
      const auto key = mesh.face_key(faces.front());
      found.vertices.assign(key.begin(), key.begin() + n_vertices(key));
    }
  return found;
}

/** The vertices that several parts share. */
template <int dim>
FoundPlaces
find_thin(const CoarseMesh<dim> &mesh, const std::vector<unsigned int> &parts)
{
  std::vector<unsigned int> part_of_vertex(mesh.vertices.size(),
                                           numbers::invalid_unsigned_int);
  std::vector<unsigned int> shared;
  for (unsigned int cell = 0; cell < mesh.cells.size(); ++cell)
    for (const unsigned int vertex : mesh.cells[cell].vertices)
      {
        unsigned int &part = part_of_vertex[vertex];
        if (part == numbers::invalid_unsigned_int)
          part = parts[cell];
        else if (part != parts[cell])
          shared.push_back(vertex);
      }
  std::sort(shared.begin(), shared.end());
  shared.erase(std::unique(shared.begin(), shared.end()), shared.end());
  FoundPlaces found;
  found.n = shared.size();
  if (found.n > 0)
    found.vertices.push_back(shared.front());
  return found;
}

/** Vertices by their nodes, and where they are: "nodes 5 and 9 at (0, 0, 1)".
 */
template <int dim>
std::string
describe_place(const Body<dim> &body, const std::vector<unsigned int> &vertices)
{
  std::ostringstream text;
  text << (vertices.size() == 1 ? "node" : "nodes");
  Point<dim> center;
  for (const unsigned int vertex : vertices)
    {
      center += body.mesh.vertices[vertex] / double(vertices.size());
      text << (vertex == vertices.front()  ? " "
               : vertex == vertices.back() ? " and "
                                           : ", ")
           << body.node_of_vertex(vertex);
    }
  // Without the round-off of a zero.
  const double smallest = 1e-12 * body.mesh.extent();
  for (unsigned int d = 0; d < dim; ++d)
    text << (d == 0 ? " at (" : ", ")
         << (std::abs(center[d]) < smallest ? 0 : center[d]);
  return text.str() + ")";
}

/** "1 place", "2 places". */
std::string
count(const unsigned int n, const std::string &what)
{
  return std::to_string(n) + " " + what + (n == 1 ? "" : "s");
}
} // namespace


template <int dim>
Joints
find_joints(const Body<dim> &body)
{
  Joints joints;
  if (body.box)
    return joints;
  const auto surface = collect_surface(body.mesh);
  const auto places  = find_places(body.mesh, surface);
  const auto parts   = find_pieces(body.mesh);
  joints.n_parts     = *std::max_element(parts.begin(), parts.end()) + 1;
  joints.coincident  = find_coincident(places);
  joints.overlapping = find_overlapping(body.mesh, surface, places);
  joints.thin        = find_thin(body.mesh, parts);
  return joints;
}



template <int dim>
std::vector<std::string>
describe_joints(const Body<dim> &body, const Joints &joints)
{
  const std::string whose =
    joints.n_parts == 1
      ? "The body touches itself"
      : "The " + std::to_string(joints.n_parts) + " parts of the body touch";
  const std::string way_out = " (BooleanFragments in the geometry, 'Coherence "
                              "Mesh' for a mesh), or set Body/Open joints = "
                              "allow where it is meant.";
  std::vector<std::string> sentences;
  if (joints.coincident.n > 0)
    sentences.push_back(
      whose + " at " + count(joints.coincident.n, "place") +
      " without being joined: different corners of elements lie there, first " +
      describe_place(body, joints.coincident.vertices) +
      ". The body is open there, and no force passes. Join them" + way_out);
  if (joints.overlapping.n > 0)
    sentences.push_back(
      whose + " at " + count(joints.overlapping.n, "face") +
      " without being joined: they lie on others with other corners, first " +
      describe_place(body, joints.overlapping.vertices) +
      ". The body is open there, and no force passes. Divide both sides alike "
      "and join them" +
      way_out);
  if (joints.thin.n > 0)
    sentences.push_back("Parts of the body that share no face are joined by " +
                        count(joints.thin.n, "corner") + " only, first " +
                        describe_place(body, joints.thin.vertices) +
                        ". Such a joint turns like a hinge, and its stress has "
                        "no limit. Join them by faces" +
                        way_out);
  return sentences;
}



template Joints
find_joints(const Body<2> &);
template Joints
find_joints(const Body<3> &);
template std::vector<std::string>
describe_joints(const Body<2> &, const Joints &);
template std::vector<std::string>
describe_joints(const Body<3> &, const Joints &);
} // namespace Setsudan
