// SPDX-License-Identifier: LGPL-2.1-or-later
// Names of points: the same from every element that has the point, different
// for different points, and for the two sides of what was separated.

#include <setsudan/mesh/point_name.h>

#include <cmath>
#include <map>
#include <set>

#include "../body/detach.h"
#include "../body/small_body.h"
#include "../parameters/check.h"
#include "../test_setup.h"

using namespace Setsudan;
using namespace dealii;

/** The points of the reference cell whose coordinates are quarters. */
template <int dim>
std::vector<Point<dim>>
quarter_points()
{
  std::vector<Point<dim>> points;
  for (unsigned int i = 0; i < std::pow(5, dim); ++i)
    {
      Point<dim> point;
      for (unsigned int d = 0, rest = i; d < dim; ++d, rest /= 5)
        point[d] = (rest % 5) / 4.;
      points.push_back(point);
    }
  return points;
}


/** The position in quarters of elements, which are cubes of edge 1. */
template <int dim>
std::array<long, dim>
position(const CoarseMesh<dim> &mesh,
         const unsigned int cell,
         const Point<dim> &unit_point)
{
  const auto corner = mesh.vertices[mesh.cells[cell].vertices[0]];
  std::array<long, dim> result;
  for (unsigned int d = 0; d < dim; ++d)
    result[d] = std::lround(4 * (corner[d] + unit_point[d]));
  return result;
}


/** How many names there are, and positions that have more than one. */
template <int dim>
void
count_names(const std::string &text, const CoarseMesh<dim> &mesh)
{
  std::map<std::array<long, dim>, std::set<PointName>> names_at;
  std::set<PointName> names;
  double error = 0;
  for (unsigned int cell = 0; cell < mesh.cells.size(); ++cell)
    for (const auto &point : quarter_points<dim>())
      {
        const PointName name = name_of_point(mesh, cell, point);
        names.insert(name);
        names_at[position(mesh, cell, point)].insert(name);
        // The name says where the point is.
        Point<dim> named;
        for (const auto &[vertex, weight] : name)
          named += weight * mesh.vertices[vertex];
        const auto corner = mesh.vertices[mesh.cells[cell].vertices[0]];
        error =
          std::max(error, named.distance(corner + (point - Point<dim>())));
      }
  unsigned int n_double = 0;
  for (const auto &[at, of_point] : names_at)
    n_double += of_point.size() > 1;
  std::cout << dim << "D, " << text << ": " << names_at.size() << " positions, "
            << names.size() << " names, " << n_double
            << " positions with several" << std::endl;
  check_below("distance of what is named", error, 1e-14);
}


template <int dim>
void
test_names()
{
  const SmallBody<dim> small(
    {dim == 3 ? "Body/Elements=2,2,1" : "Body/Elements=2,2",
     dim == 3 ? "Body/Size=2,2,1" : "Body/Size=2,2"});
  const auto &mesh = small.body.mesh;
  count_names("whole", mesh);
  count_names("two halves", detach<dim>(mesh, {2, 3}));
  count_names("a corner apart", detach<dim>(mesh, {0}));
}


void
print_name(const PointName &name)
{
  for (const auto &[vertex, weight] : name)
    std::cout << " " << vertex << " x " << weight;
  std::cout << std::endl;
}


/** The second of two squares has the vertices 1, 2, 4, 5. */
void
test_weights()
{
  const auto mesh = SmallBody<2>({"Body/Elements=2,1"}).body.mesh;
  print_name(name_of_point(mesh, 1, Point<2>(0, 1)));
  print_name(name_of_point(mesh, 1, Point<2>(0, 0.25)));
  print_name(name_of_point(mesh, 0, Point<2>(1, 0.25)));
  print_name(name_of_point(mesh, 1, Point<2>(0.25, 0.5)));
}


/** An entity for points on vertices, lines and faces, none inside. */
template <int dim>
void
test_entities()
{
  const auto mesh =
    SmallBody<dim>({dim == 3 ? "Body/Elements=1,1,1" : "Body/Elements=1,1"})
      .body.mesh;
  std::map<EntityKey, unsigned int> n_points;
  bool fits = true;
  for (const auto &point : quarter_points<dim>())
    {
      const EntityKey key = entity_of_point(mesh, 0, point);
      ++n_points[key];
      unsigned int n_inside = 0;
      for (unsigned int d = 0; d < dim; ++d)
        n_inside += point[d] > 0 && point[d] < 1;
      // A hexahedron has more vertices than a key.
      fits = fits && n_vertices(key) == (n_inside == 3 ? 0 : 1u << n_inside);
      if (n_inside == dim - 1)
        for (unsigned int f = 0; f < GeometryInfo<dim>::faces_per_cell; ++f)
          if (point[f / 2] == f % 2)
            fits = fits && key == mesh.face_key({0, f});
    }
  std::map<unsigned int, std::set<unsigned int>> n_points_by_size;
  for (const auto &[key, n] : n_points)
    n_points_by_size[n_vertices(key)].insert(n);
  std::cout << dim << "D: " << n_points.size() << " entities; points on those";
  for (const auto &[size, counts] : n_points_by_size)
    {
      std::cout << " of " << size << " vertices:";
      for (const unsigned int n : counts)
        std::cout << " " << n;
    }
  std::cout << std::endl;
  check("by the number of vertices, and faces", fits);
}


int
main(int argc, char **argv)
{
  return run_test(argc, argv, [] {
    test_names<2>();
    test_names<3>();
    test_weights();
    test_entities<2>();
    test_entities<3>();
  });
}
