// SPDX-License-Identifier: LGPL-2.1-or-later
#include <deal.II/base/mpi.h>

#include <setsudan/cut/seam/node_pairs.h>
#include <setsudan/mesh/geometry.h>

#include <algorithm>
#include <cstdint>
#include <limits>
#include <map>

namespace Setsudan
{
using namespace dealii;

template <int dim>
bool
NodePair<dim>::is_double() const
{
  return minus != plus;
}



template <int dim>
unsigned int
NodePair<dim>::normal_component() const
{
  unsigned int component = 0;
  for (unsigned int c = 1; c < dim; ++c)
    if (std::abs(normal[c]) > std::abs(normal[component]))
      component = c;
  return component;
}



namespace
{
/** What one side's cell knows of a node of a cut face, as plain numbers, since
 * it is sent to the other processes: index of the face in the surface, side,
 * path of the cell in its element, node of the cell, supported components,
 * unknowns. */
template <int dim>
using SideRecord = std::array<std::uint64_t, 5 + dim>;

template <int dim>
std::uint64_t
supported_components(const ElasticModel<dim> &model,
                     const typename Discretization<dim>::NodeIndices &node)
{
  std::bitset<dim> supported;
  for (unsigned int c = 0; c < dim; ++c)
    supported[c] = model.supports.is_constrained(node[c]);
  return supported.to_ulong();
}

template <int dim>
std::vector<SideRecord<dim>>
record_own_sides(const ElasticModel<dim> &model, const CutSurface<dim> &surface)
{
  std::multimap<unsigned int, std::pair<unsigned int, unsigned int>> sides;
  for (unsigned int f = 0; f < surface.size(); ++f)
    {
      sides.emplace(surface[f].minus.first, std::make_pair(f, 0));
      sides.emplace(surface[f].plus.first, std::make_pair(f, 1));
    }

  std::vector<SideRecord<dim>> records;
  const auto &discretization = model.discretization;
  for (const auto &cell : discretization.dof_handler.active_cell_iterators())
    if (cell->is_locally_owned())
      {
        const auto range = sides.equal_range(discretization.element(cell));
        if (range.first == range.second)
          continue;
        const auto nodes  = discretization.node_indices(cell);
        const auto &units = discretization.nodes();
        const auto points = discretization.points_in_element(cell);
        const auto path   = path_of_cell<dim>(cell).path;
        for (auto it = range.first; it != range.second; ++it)
          {
            const auto [f, side] = it->second;
            const unsigned int face =
              side == 0 ? surface[f].minus.second : surface[f].plus.second;
            for (unsigned int node = 0; node < nodes.size(); ++node)
              if (units[node][face / 2] == face % 2)
                {
                  // A refined cell may lie away from its element's face.
                  if (points[node][face / 2] != face % 2)
                    break;
                  SideRecord<dim> record{
                    {f,
                     side,
                     path,
                     node,
                     supported_components(model, nodes[node])}};
                  std::copy(
                    nodes[node].begin(), nodes[node].end(), record.begin() + 5);
                  records.push_back(record);
                }
          }
      }
  return records;
}



/** A face of a cell that stands on an axis of the cell, from the places of its
 * nodes in the cell. */
template <int dim>
SurfaceFace
face_of_nodes(const std::vector<std::pair<Point<dim>, unsigned int>> &nodes,
              const unsigned int axis)
{
  SurfaceFace face;
  for (const auto &[point, pair] : nodes)
    face.pairs.push_back(pair);
  for (unsigned int d = 0; d < dim; ++d)
    for (const double end : {0., 1.})
      {
        if (d == axis)
          continue;
        // There is one axis along the line in 3D, and none in 2D.
        std::map<double, unsigned int> line;
        for (const auto &[point, pair] : nodes)
          if (point[d] == end)
            line[dim == 3 ? point[3 - d - axis] : 0.] = pair;
        face.lines.emplace_back();
        for (const auto &[place, pair] : line)
          face.lines.back().push_back(pair);
      }
  return face;
}



/** Puts pairs together from the records of their two sides. */
template <int dim>
class PairBuilder
{
public:
  PairBuilder(const CutSurface<dim> &surface,
              const std::vector<Point<dim>> &nodes,
              const Body<dim> &body,
              const CoarseMesh<dim> &split)
    : surface(surface)
    , nodes(nodes)
    , body(body)
    , split(split)
  {
  }

  void
  add(const SideRecord<dim> &record)
  {
    const CutFace<dim> &face = surface[record[0]];
    const bool is_minus      = record[1] == 0;
    const CellFace &side     = is_minus ? face.minus : face.plus;
    const CellPath path{side.first, record[2]};
    const unsigned int node = record[3];
    deepest                 = std::max(deepest, path.path);
    const auto point        = point_in_element<dim>(path, nodes[node]);
    Point<dim> center;
    for (unsigned int d = 0; d < dim; ++d)
      center[d] = d == side.second / 2 ? side.second % 2 : 0.5;

    const PointName name = name_of_point(body.mesh, side.first, point);
    const PointName cell_face =
      name_of_point(body.mesh, side.first, point_in_element<dim>(path, center));
    Entry &entry        = entries[{record[0], cell_face}][name];
    NodePair<dim> &pair = entry.pair;
    pair.name           = name;
    pair.is_corner      = node < GeometryInfo<dim>::vertices_per_cell;
    if (is_minus)
      {
        const auto corners = body.mesh.node_positions(side.first);
        pair.position      = path.path == 1 && node < corners.size()
                               ? corners[node]
                               : point_of_element(corners, point);
        pair.normal        = normal_of_face(corners, side.second, point);
        pair.element       = side.first;
        entry.unit_point   = nodes[node];
      }
    else
      pair.plus_element = side.first;
    auto &indices = is_minus ? pair.minus : pair.plus;
    std::copy(record.begin() + 5, record.end(), indices.begin());
    pair.supported |= std::bitset<dim>(record[4]);
    entry.name_in_split[record[1]] = name_of_point(split, side.first, point);
  }

  /** The faces that meet at a node name the same pair. */
  SurfaceNodes<dim>
  finish() const
  {
    using Key = std::pair<PointName, std::array<types::global_dof_index, 2>>;
    const auto key_of = [](const NodePair<dim> &pair) {
      return Key{pair.name, {{pair.minus[0], pair.plus[0]}}};
    };
    std::map<Key, NodePair<dim>> unique;
    for (const auto &[face, of_face] : entries)
      for (const auto &[name, entry] : of_face)
        {
          const auto inserted = unique.emplace(key_of(entry.pair), entry.pair);
          auto &whole         = inserted.first->second;
          if (!inserted.second)
            {
              whole.normal += entry.pair.normal;
              whole.supported |= entry.pair.supported;
            }
          // A node is divided if an end of the line it lies on, or a corner of
          // the face, is.
          whole.is_divided = whole.is_divided ||
                             entry.name_in_split[0] != entry.name_in_split[1];
        }

    SurfaceNodes<dim> result;
    std::map<Key, unsigned int> number;
    for (auto &[key, pair] : unique)
      {
        number[key] = result.pairs.size();
        pair.normal /= pair.normal.norm();
        result.pairs.push_back(pair);
      }
    for (const auto &[face, of_face] : entries)
      {
        std::vector<std::pair<Point<dim>, unsigned int>> at;
        for (const auto &[name, entry] : of_face)
          at.emplace_back(entry.unit_point, number.at(key_of(entry.pair)));
        result.faces.push_back(
          face_of_nodes<dim>(at, surface[face.first].minus.second / 2));
      }
    for (auto path = deepest; path > 1; path >>= dim)
      result.n_cells_on_line *= 2;
    return result;
  }

private:
  const CutSurface<dim> &surface;
  const std::vector<Point<dim>> &nodes;
  const Body<dim> &body;
  const CoarseMesh<dim> &split;
  /** A pair as one face has it, and the names of its sides behind the
   * surgery. */
  struct Entry
  {
    NodePair<dim> pair{};
    std::array<PointName, 2> name_in_split;
    /** In the cell of the minus side. */
    Point<dim> unit_point;
  };

  /** By face of a cell, named by its center, and by node. */
  std::map<std::pair<std::uint64_t, PointName>, std::map<PointName, Entry>>
    entries;
  std::uint64_t deepest = 1;
};
} // namespace


template <int dim>
std::vector<SurfaceNodes<dim>>
collect_surface_nodes(const ElasticModel<dim> &model,
                      const std::vector<CutSurface<dim>> &surfaces,
                      const Body<dim> &body,
                      const CoarseMesh<dim> &split)
{
  std::vector<std::vector<SideRecord<dim>>> own;
  for (const auto &surface : surfaces)
    own.push_back(record_own_sides(model, surface));
  const auto all =
    Utilities::MPI::all_gather(model.discretization.communicator, own);
  std::vector<SurfaceNodes<dim>> nodes;
  for (unsigned int s = 0; s < surfaces.size(); ++s)
    {
      PairBuilder<dim> builder(
        surfaces[s], model.discretization.nodes(), body, split);
      for (const auto &of_process : all)
        for (const auto &record : of_process[s])
          builder.add(record);
      nodes.push_back(builder.finish());
    }
  return nodes;
}



template <int dim>
std::array<double, 2>
travels_of_pairs(const std::vector<NodePair<dim>> &pairs,
                 const BladeEdge<dim> &edge)
{
  std::array<double, 2> ends{{std::numeric_limits<double>::max(),
                              std::numeric_limits<double>::lowest()}};
  for (const auto &pair : pairs)
    {
      const double travel = edge.travel(pair.position);
      ends = {{std::min(ends[0], travel), std::max(ends[1], travel)}};
    }
  return ends;
}



template struct NodePair<2>;
template struct NodePair<3>;
template std::array<double, 2>
travels_of_pairs(const std::vector<NodePair<2>> &, const BladeEdge<2> &);
template std::array<double, 2>
travels_of_pairs(const std::vector<NodePair<3>> &, const BladeEdge<3> &);
template std::vector<SurfaceNodes<2>>
collect_surface_nodes(const ElasticModel<2> &,
                      const std::vector<CutSurface<2>> &,
                      const Body<2> &,
                      const CoarseMesh<2> &);
template std::vector<SurfaceNodes<3>>
collect_surface_nodes(const ElasticModel<3> &,
                      const std::vector<CutSurface<3>> &,
                      const Body<3> &,
                      const CoarseMesh<3> &);
} // namespace Setsudan
