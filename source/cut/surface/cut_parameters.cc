// SPDX-License-Identifier: LGPL-2.1-or-later
#include <setsudan/cut/surface/cut_checks.h>
#include <setsudan/cut/surface/cut_parameters.h>
#include <setsudan/cut/surface/surface_grammar.h>
#include <setsudan/mesh/geometry.h>
#include <setsudan/parameters/exceptions.h>

#include <algorithm>
#include <limits>

namespace Setsudan
{
using namespace dealii;

template <int dim>
void
CutParameters<dim>::declare(ParameterHandler &handler)
{
  Setsudan::declare(
    handler,
    "Cut",
    "Surfaces",
    "",
    Patterns::Anything(),
    std::string("Where the body is divided; several, separated by ';', are cut "
                "in turn. 'axis : boundary' is a boundary between layers of "
                "elements of a box, counted from 1; 'plane : ") +
      (dim == 3 ? "px, py, pz ; nx, ny, nz'" : "px, py ; nx, ny'") +
      " and 'where : expression' (in x, y, z, equal to 0 on the cut) take the "
      "element faces that follow a surface best; 'group : name' is a group of "
      "faces inside the body, 'between : A, B' the interface of two groups of "
      "elements. Cuts follow the elements as they are before refinement. "
      "Without a surface the scene is a deformation and nothing else.");
  Setsudan::declare(
    handler,
    "Cut",
    "Extent",
    "all",
    Patterns::Anything(),
    std::string("How much of a surface is cut: 'all', 'depth : "
                "d' from the blade's entry, or 'box : ") +
      (dim == 3 ? "x0, y0, z0, x1, y1, z1'" : "x0, y0, x1, y1'") +
      "; an element face is cut if its center lies within, up to a millionth "
      "of the element. "
      "One item for all surfaces, or one for each, separated "
      "by ';' [length].");
  Setsudan::declare(handler,
                    "Cut",
                    "Notch",
                    "0",
                    Patterns::Double(),
                    "How deep each cut is open before the blade comes, where "
                    "Blade/Drive is travel: rows up to this depth behind the "
                    "entry are split from the start, and take no energy "
                    "[length].");
  Setsudan::declare(handler,
                    "Cut",
                    "Refinement near cut",
                    "0",
                    Patterns::List(Patterns::Double(0), 1, 2),
                    "How often elements at the cuts are halved along each "
                    "axis, and the distance from a cut up to which others are "
                    "as well, as 'levels' or 'levels, width' [-, length].");
}



namespace
{
/** The choice for a cut from a list with one item for all, or one for each. */
template <typename T>
const T &
for_cut(const std::vector<T> &list, const unsigned int cut)
{
  return list[list.size() == 1 ? 0 : cut];
}



/** The faces whose centers an extent holds. */
template <int dim>
CutSurface<dim>
limit_surface(const Body<dim> &body,
              const CutSurface<dim> &surface,
              const Extent<dim> &extent,
              const Tensor<1, dim> &direction)
{
  const auto nodes_of = [&](const CutFace<dim> &face) {
    std::vector<Point<dim>> nodes;
    for (unsigned int v = 0; v < GeometryInfo<dim>::vertices_per_face; ++v)
      nodes.push_back(body.mesh.node_position(
        face.minus.first,
        GeometryInfo<dim>::face_to_cell_vertices(face.minus.second, v)));
    return nodes;
  };
  double entry = std::numeric_limits<double>::max();
  for (const auto &face : surface)
    for (const auto &node : nodes_of(face))
      entry = std::min(entry, direction * Tensor<1, dim>(node));
  CutSurface<dim> limited;
  for (const auto &face : surface)
    {
      const auto nodes = nodes_of(face);
      Point<dim> center;
      for (const auto &node : nodes)
        center += node / double(nodes.size());
      const double tolerance =
        coordinate_tolerance<dim>(body.mesh.node_positions(face.minus.first));
      if (extent(center, tolerance, direction, entry))
        limited.push_back(face);
    }
  return limited;
}



/** Whether two surfaces are the same faces, which may be sorted and turned in
 * different ways. */
template <int dim>
bool
is_same(const CutSurface<dim> &a, const CutSurface<dim> &b)
{
  const auto sorted = [](const CutSurface<dim> &surface) {
    std::vector<CellFace> faces;
    for (const auto &face : surface)
      faces.push_back(std::min(face.minus, face.plus));
    std::sort(faces.begin(), faces.end());
    return faces;
  };
  return sorted(a) == sorted(b);
}



/** The surface of an item, as far as its extent goes. */
template <int dim>
ChosenSurface<dim>
choose_surface(const Parameters &parameters,
               const Body<dim> &body,
               const SurfaceItem<dim> &item,
               const Tensor<1, dim> &direction,
               const Extent<dim> &extent)
{
  ChosenSurface<dim> surface;
  try
    {
      surface = item.choice->choose(body);
    }
  catch (const CutError &error)
    {
      parameters.reject("Cut",
                        "Surfaces",
                        "surfaces inside the body, and '" + item.text +
                          "' is none: " + error.what());
    }
  // The depth is measured as the blade travels in the whole surface.
  const BladeEdge<dim> whole(areas_of_faces(body, surface.faces), direction);
  const bool was_empty = surface.faces.empty();
  surface.faces = limit_surface(body, surface.faces, extent, whole.direction);
  parameters.require(was_empty || !surface.faces.empty(),
                     "Cut",
                     "Extent",
                     "parts of the surfaces, and this one holds the center "
                     "of no element face of '" +
                       item.text + "'");
  return surface;
}
} // namespace


template <int dim>
CutParameters<dim>::CutParameters(const Parameters &parameters,
                                  const Body<dim> &body,
                                  const Supports<dim> &supports,
                                  const BladeParameters<dim> &blade)
{
  notch = parameters.number("Cut", "Notch");
  parameters.require(
    notch >= 0, "Cut", "Notch", "a number that is not negative");
  parameters.require(blade.travels || notch == 0,
                     "Cut",
                     "Notch",
                     "0 where Blade/Drive is force");
  const auto near = parameters.numbers("Cut", "Refinement near cut");
  near_cut_levels = static_cast<unsigned int>(near[0]);
  near_cut_width  = near.size() > 1 ? near[1] : 0.;
  parameters.require(near_cut_levels == near[0] && near_cut_levels <= 10,
                     "Cut",
                     "Refinement near cut",
                     "a whole number of levels from 0 to 10, and a width");

  const auto items   = read_surfaces(parameters, body);
  const auto extents = read_extents<dim>(parameters, items.size());
  const auto require_count =
    [&](const std::size_t n, const std::string &name, const std::string &hint) {
      parameters.require(n == 1 || n == items.size(),
                         "Blade",
                         name,
                         "one item for all cuts, or one for each" + hint);
    };
  require_count(blade.directions.size(), "Direction", "");
  require_count(blade.edge_loads.size(),
                "Edge loads",
                ", separated by ';'; the positions of one cut are separated by "
                "','");

  for (unsigned int c = 0; c < items.size(); ++c)
    {
      const auto &direction = for_cut(blade.directions, c);
      const auto surface    = choose_surface(
        parameters, body, items[c], direction, for_cut(extents, c));
      check_surface(parameters, body, items[c].text, surface.faces);
      cuts.push_back({items[c].text,
                      surface,
                      BladeEdge<dim>(areas_of_faces(body, surface.faces),
                                     direction,
                                     blade.edge_points),
                      for_cut(blade.edge_loads, c)});
      for (unsigned int other = 0; other < c; ++other)
        parameters.require(!is_same(cuts[other].surface.faces, surface.faces),
                           "Cut",
                           "Surfaces",
                           "each surface once, and '" + cuts[other].text +
                             "' and '" + items[c].text +
                             "' have the same element faces");
      check_blade(parameters, body, supports, cuts.back());
    }
}



template <int dim>
std::vector<std::pair<unsigned int, double>>
travels_to_vertices(const CoarseMesh<dim> &mesh, const Cut<dim> &cut)
{
  std::vector<std::pair<unsigned int, double>> travels;
  for (const auto &face : cut.surface.faces)
    for (const unsigned int vertex : mesh.face_vertices(face.minus))
      travels.emplace_back(vertex, cut.edge.travel(mesh.vertices[vertex]));
  return travels;
}



template std::vector<std::pair<unsigned int, double>>
travels_to_vertices(const CoarseMesh<2> &, const Cut<2> &);
template std::vector<std::pair<unsigned int, double>>
travels_to_vertices(const CoarseMesh<3> &, const Cut<3> &);
template struct CutParameters<2>;
template struct CutParameters<3>;
} // namespace Setsudan
