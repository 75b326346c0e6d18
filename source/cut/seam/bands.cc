// SPDX-License-Identifier: LGPL-2.1-or-later
#include <setsudan/cut/seam/bands.h>
#include <setsudan/cut/seam/face_graph.h>

#include <algorithm>
#include <limits>
#include <map>
#include <set>

namespace Setsudan
{
using namespace dealii;

namespace
{
/** The bands of a cut's faces. */
struct Bands
{
  std::vector<unsigned int> of_face;
  /** Whether a face is entered from the border, and not from split faces. */
  std::vector<bool> is_entered;
  /** Of the front of each band. */
  std::vector<double> depths;
};



/** The depth of the deepest of the faces that a straight edge stands in. */
double
largest_extent(const std::vector<FacePlace> &places,
               const double depth,
               const double tolerance)
{
  double largest = 0;
  for (const auto &place : places)
    if (place.begin <= depth + tolerance && place.end > depth + tolerance)
      largest = std::max(largest, place.end - place.begin);
  return largest;
}



/** The unsplit faces whose centres a straight edge passes next: as many as
 * bring the split area nearest to what it has opened at its next depth.
 *
 * @param area that is missing for that. */
std::set<unsigned int>
next_faces(const std::vector<FacePlace> &places,
           const std::set<unsigned int> &unsplit,
           const double area,
           const double tolerance)
{
  std::vector<std::pair<double, unsigned int>> by_center;
  for (const unsigned int f : unsplit)
    by_center.emplace_back(places[f].center, f);
  std::sort(by_center.begin(), by_center.end());
  std::set<unsigned int> passed;
  double missing = area;
  for (auto begin = by_center.begin(); begin != by_center.end();)
    {
      // Those that agree are passed together.
      const auto end =
        std::find_if(begin, by_center.end(), [&](const auto &other) {
          return other.first > begin->first + tolerance;
        });
      double more = 0;
      for (auto it = begin; it != end; ++it)
        more += places[it->second].area;
      if (!passed.empty() && more > 2 * missing)
        break;
      for (; begin != end; ++begin)
        passed.insert(begin->second);
      missing -= more;
    }
  return passed;
}



/** Take from faces that a straight edge has passed those to which the blade
 * comes: what hangs together with split faces, and then with the border. Others
 * are islands, and wait.
 *
 * @param entered whether those come from the border. */
template <int dim>
std::vector<unsigned int>
reached_faces(const FaceGraph<dim> &graph,
              const std::set<unsigned int> &unsplit,
              const bool entered,
              std::set<unsigned int> &passed)
{
  std::vector<unsigned int> first;
  for (const unsigned int f : passed)
    {
      const auto &lines = graph.lines_of_face(f);
      if (std::any_of(lines.begin(), lines.end(), [&](const unsigned int l) {
            const auto &line = graph.lines()[l];
            return entered ? graph.is_entered(line)
                           : std::any_of(line.faces.begin(),
                                         line.faces.end(),
                                         [&](const unsigned int other) {
                                           return unsplit.count(other) == 0;
                                         });
          }))
        first.push_back(f);
    }
  return graph.take_connected(first, passed);
}



template <int dim>
Bands
find_bands(const FaceGraph<dim> &graph,
           const AreaBehindEdge &area_behind,
           const double tolerance)
{
  const auto &places = graph.places();
  Bands bands{std::vector<unsigned int>(places.size()),
              std::vector<bool>(places.size(), false),
              {}};
  std::set<unsigned int> unsplit;
  double whole = 0, split = 0;
  for (unsigned int f = 0; f < places.size(); ++f)
    {
      unsplit.insert(f);
      whole += places[f].area;
    }
  while (!unsplit.empty())
    {
      // Where a hole lies between split faces and others, these are entered
      // below it.
      double depth = std::numeric_limits<double>::max();
      for (const unsigned int f : unsplit)
        depth = std::min(depth, places[f].begin);
      depth             = std::max(depth, area_behind.depth_of(split / whole));
      const double next = depth + largest_extent(places, depth, tolerance);
      auto passed       = next_faces(
        places, unsplit, whole * area_behind.part_at(next) - split, tolerance);
      auto faces        = reached_faces(graph, unsplit, false, passed);
      const auto behind = faces.size();
      const auto others = reached_faces(graph, unsplit, true, passed);
      faces.insert(faces.end(), others.begin(), others.end());
      // A closed surface inside the body is entered anywhere.
      if (faces.empty())
        faces.insert(faces.end(), passed.begin(), passed.end());
      for (unsigned int i = 0; i < faces.size(); ++i)
        {
          const unsigned int f = faces[i];
          bands.of_face[f]     = bands.depths.size();
          bands.is_entered[f]  = i >= behind;
          split += places[f].area;
          unsplit.erase(f);
        }
      bands.depths.push_back(depth);
    }
  return bands;
}



/** Chains of the lines of a front, which have a direction. */
std::vector<Chain>
join_lines(const std::vector<std::vector<unsigned int>> &lines)
{
  std::multimap<unsigned int, unsigned int> leaving;
  std::map<unsigned int, int> surplus;
  for (unsigned int l = 0; l < lines.size(); ++l)
    {
      leaving.emplace(lines[l].front(), l);
      ++surplus[lines[l].front()];
      --surplus[lines[l].back()];
    }
  std::vector<Chain> chains;
  const auto follow = [&](unsigned int node) {
    Chain chain{{node}, false};
    auto it = leaving.find(node);
    while (it != leaving.end())
      {
        const auto &line = lines[it->second];
        chain.nodes.insert(chain.nodes.end(), line.begin() + 1, line.end());
        node = line.back();
        leaving.erase(it);
        it = leaving.find(node);
      }
    chain.closed = chain.nodes.size() > 1 && node == chain.nodes.front();
    if (chain.closed)
      chain.nodes.pop_back();
    chains.push_back(chain);
  };
  for (const auto &[node, n] : surplus)
    for (int i = 0; i < n; ++i)
      follow(node);
  while (!leaving.empty())
    follow(leaving.begin()->first);
  return chains;
}



/** What the edge reaches first of a band, node by node: of a surface that is
 * closed inside the body. */
template <int dim>
std::vector<Chain>
first_nodes(const SurfaceNodes<dim> &nodes,
            const FaceGraph<dim> &graph,
            const Bands &bands,
            const unsigned int band,
            const double tolerance)
{
  std::set<std::pair<double, unsigned int>> by_depth;
  for (unsigned int f = 0; f < nodes.faces.size(); ++f)
    if (bands.of_face[f] == band)
      for (const unsigned int p : nodes.faces[f].pairs)
        by_depth.emplace(graph.depth(p), p);
  std::vector<Chain> chains;
  for (const auto &[depth, pair] : by_depth)
    if (depth <= by_depth.begin()->first + tolerance)
      chains.push_back({{pair}, false});
  return chains;
}



/** The chains of the front of each band: between split and unsplit faces, and
 * along the border where the blade enters. */
template <int dim>
std::vector<std::vector<Chain>>
fronts_of_bands(const SurfaceNodes<dim> &nodes,
                const FaceGraph<dim> &graph,
                const Bands &bands,
                const double tolerance)
{
  std::vector<std::vector<std::vector<unsigned int>>> lines(
    bands.depths.size());
  for (const auto &line : graph.lines())
    {
      const auto by_band = [&](const unsigned int a, const unsigned int b) {
        return bands.of_face[a] < bands.of_face[b];
      };
      const auto [first, last] =
        std::minmax_element(line.faces.begin(), line.faces.end(), by_band);
      const auto along = graph.along_front(line, *last);
      if (bands.is_entered[*last] && graph.is_entered(line))
        lines[bands.of_face[*last]].push_back(along);
      for (unsigned int band = bands.of_face[*first] + 1;
           band <= bands.of_face[*last];
           ++band)
        lines[band].push_back(along);
    }
  std::vector<std::vector<Chain>> fronts;
  for (const auto &of_band : lines)
    fronts.push_back(join_lines(of_band));
  for (unsigned int band = 0; band < fronts.size(); ++band)
    if (fronts[band].empty())
      fronts[band] = first_nodes(nodes, graph, bands, band, tolerance);
  return fronts;
}



/** Whether a straight edge crosses the faces in one direction of an axis all
 * along, whatever their lines do. */
template <int dim>
bool
axis_follows(const SurfaceNodes<dim> &nodes, const BladeEdge<dim> &edge)
{
  bool forward = false, back = false;
  if constexpr (dim == 3)
    for (const auto &face : nodes.faces)
      {
        Tensor<1, dim> normal;
        for (const unsigned int p : face.pairs)
          normal += nodes.pairs[p].normal / double(face.pairs.size());
        const double along =
          cross_product_3d(normal, edge.direction)[edge.axis];
        forward = forward || along > 1e-6;
        back    = back || along < -1e-6;
      }
  return !(forward && back);
}
} // namespace


template <int dim>
std::vector<Row>
make_bands(const SurfaceNodes<dim> &nodes,
           const BladeEdge<dim> &edge,
           const std::vector<SurfaceStrip> &strips,
           const double tolerance)
{
  const FaceGraph<dim> graph(nodes, edge);
  const auto bands = find_bands(graph, AreaBehindEdge(strips), tolerance);

  std::vector<Row> rows(bands.depths.size());
  std::vector<unsigned int> band_of_pair(nodes.pairs.size(), 0);
  for (unsigned int f = 0; f < nodes.faces.size(); ++f)
    for (const unsigned int p : nodes.faces[f].pairs)
      band_of_pair[p] = std::max(band_of_pair[p], bands.of_face[f]);
  for (unsigned int p = 0; p < band_of_pair.size(); ++p)
    rows[band_of_pair[p]].pairs.push_back(p);
  const auto fronts  = fronts_of_bands(nodes, graph, bands, tolerance);
  const bool follows = axis_follows(nodes, edge);
  for (unsigned int band = 0; band < rows.size(); ++band)
    {
      rows[band].depth = bands.depths[band];
      set_front(nodes, edge, fronts[band], follows, rows[band]);
    }
  return rows;
}



template std::vector<Row>
make_bands(const SurfaceNodes<2> &,
           const BladeEdge<2> &,
           const std::vector<SurfaceStrip> &,
           const double);
template std::vector<Row>
make_bands(const SurfaceNodes<3> &,
           const BladeEdge<3> &,
           const std::vector<SurfaceStrip> &,
           const double);
} // namespace Setsudan
