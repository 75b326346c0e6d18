// SPDX-License-Identifier: LGPL-2.1-or-later
#include <deal.II/base/quadrature_lib.h>

#include <setsudan/cut/seam/fronts.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <set>

namespace Setsudan
{
using namespace dealii;

namespace
{
/** Which node of a layer follows which, along the faces of the cut. */
template <int dim>
std::map<unsigned int, unsigned int>
link_nodes(const SurfaceNodes<dim> &nodes,
           const BladeEdge<dim> &edge,
           const std::vector<unsigned int> &layer_of_node,
           const unsigned int layer,
           const std::vector<unsigned int> &faces)
{
  std::map<unsigned int, unsigned int> next;
  if constexpr (dim == 3)
    for (const unsigned int f : faces)
      {
        std::vector<std::pair<double, unsigned int>> along;
        Tensor<1, dim> normal;
        for (const unsigned int p : nodes.faces[f].pairs)
          normal += nodes.pairs[p].normal;
        const auto tangent = cross_product_3d(normal, edge.direction);
        for (const unsigned int p : nodes.faces[f].pairs)
          if (layer_of_node[p] == layer)
            along.emplace_back(
              tangent * Tensor<1, dim>(nodes.pairs[p].position), p);
        std::sort(along.begin(), along.end());
        for (unsigned int i = 0; i + 1 < along.size(); ++i)
          next[along[i].second] = along[i + 1].second;
      }
  return next;
}



/** Follow the links from nodes that follow none, then around what is left. */
std::vector<Chain>
follow_links(const std::vector<unsigned int> &layer,
             const std::map<unsigned int, unsigned int> &next)
{
  std::set<unsigned int> left(layer.begin(), layer.end());
  std::set<unsigned int> starts = left;
  for (const auto &[node, follower] : next)
    starts.erase(follower);
  std::vector<Chain> chains;
  while (!left.empty())
    {
      const bool open          = !starts.empty();
      const unsigned int start = open ? *starts.begin() : *left.begin();
      starts.erase(start);
      Chain chain{{}, !open};
      unsigned int node = start;
      while (left.erase(node) > 0)
        {
          chain.nodes.push_back(node);
          const auto link = next.find(node);
          if (link == next.end())
            break;
          node = link->second;
        }
      chains.push_back(chain);
    }
  return chains;
}



/** Whether a coordinate never runs back along a chain. */
template <int dim>
bool
is_monotone(const SurfaceNodes<dim> &nodes,
            const BladeEdge<dim> &edge,
            const Chain &chain)
{
  if (chain.closed)
    return false;
  std::vector<double> positions;
  for (const unsigned int p : chain.nodes)
    positions.push_back(edge.position(nodes.pairs[p].position));
  return std::is_sorted(positions.begin(), positions.end()) ||
         std::is_sorted(positions.rbegin(), positions.rend());
}



/** Add the integrals of the shape functions along a line of two nodes, or of
 * three with one in its middle. */
template <int dim>
void
add_lengths(const std::array<Point<dim>, 3> &nodes,
            const bool is_quadratic,
            std::array<double, 3> &lengths)
{
  const QGauss<1> gauss(4);
  for (unsigned int q = 0; q < gauss.size(); ++q)
    {
      const double x = gauss.point(q)[0];
      std::array<double, 3> values{{1 - x, 0, x}}, slopes{{-1, 0, 1}};
      if (is_quadratic)
        {
          values = {{(1 - x) * (1 - 2 * x), 4 * x * (1 - x), x * (2 * x - 1)}};
          slopes = {{4 * x - 3, 4 - 8 * x, 4 * x - 1}};
        }
      Tensor<1, dim> tangent;
      for (unsigned int i = 0; i < 3; ++i)
        tangent += slopes[i] * Tensor<1, dim>(nodes[i]);
      for (unsigned int i = 0; i < 3; ++i)
        lengths[i] += gauss.weight(q) * tangent.norm() * values[i];
    }
}



/** The integrals of the shape functions of a chain's nodes along it: of lines
 * of elements, or straight from node to node where these are in the middle of
 * lines. */
template <int dim>
std::vector<double>
lengths_of_chain(const SurfaceNodes<dim> &nodes, const Chain &chain)
{
  const unsigned int n = chain.nodes.size();
  const auto pair      = [&](const unsigned int i) -> const auto &
  {
    return nodes.pairs[chain.nodes[i % n]];
  };
  // A ring may begin anywhere, but lines end at corners.
  unsigned int begin = 0;
  while (chain.closed && begin + 1 < n && !pair(begin).is_corner)
    ++begin;
  const unsigned int end = begin + (chain.closed ? n : n - 1);
  std::vector<double> result(n);
  for (unsigned int i = begin; i < end;)
    {
      const bool is_quadratic = i + 2 <= end && pair(i).is_corner &&
                                !pair(i + 1).is_corner && pair(i + 2).is_corner;
      const unsigned int next = i + (is_quadratic ? 2 : 1);
      std::array<double, 3> lengths{};
      add_lengths<dim>(
        {{pair(i).position, pair(i + 1).position, pair(next).position}},
        is_quadratic,
        lengths);
      result[i % n] += lengths[0];
      result[(i + 1) % n] += lengths[1];
      result[next % n] += lengths[2];
      i = next;
    }
  return result;
}



template <int dim>
void
order_by_coordinate(const SurfaceNodes<dim> &nodes,
                    const BladeEdge<dim> &edge,
                    const std::vector<Chain> &chains,
                    Row &row)
{
  // Chains may meet in a node.
  std::map<std::pair<double, unsigned int>, double> along;
  for (const auto &chain : chains)
    {
      const auto lengths = lengths_of_chain(nodes, chain);
      for (unsigned int i = 0; i < lengths.size(); ++i)
        along[{edge.position(nodes.pairs[chain.nodes[i]].position),
               chain.nodes[i]}] += lengths[i];
    }
  for (const auto &[place, length] : along)
    {
      row.positions.push_back(place.first);
      row.front.push_back(place.second);
      row.lengths.push_back(length);
    }
}



/** Which of two nodes is nearer to the beginning of a front that no axis
 * follows: the one of the smaller coordinate along the edge, or, where these
 * are equal up to round-off, across it. It is the same place in all rows. */
template <int dim>
class Beginning
{
public:
  Beginning(const SurfaceNodes<dim> &nodes, const BladeEdge<dim> &edge)
    : nodes(nodes)
    , edge(edge)
  {
    Tensor<1, dim> axis;
    axis[edge.axis] = 1;
    if constexpr (dim == 3)
      across = cross_product_3d(axis, edge.direction);
    for (const auto &pair : nodes.pairs)
      tolerance = std::max(
        tolerance, 1e-6 * pair.position.distance(nodes.pairs[0].position));
  }

  bool
  operator()(const unsigned int a, const unsigned int b) const
  {
    const auto &x = nodes.pairs[a].position, &y = nodes.pairs[b].position;
    const double along = edge.position(x) - edge.position(y);
    return std::abs(along) > tolerance ? along < 0 : across * (x - y) < 0;
  }

private:
  const SurfaceNodes<dim> &nodes;
  const BladeEdge<dim> &edge;
  Tensor<1, dim> across;
  double tolerance = 0;
};



template <int dim>
void
order_by_length(const SurfaceNodes<dim> &nodes,
                const BladeEdge<dim> &edge,
                std::vector<Chain> chains,
                Row &row)
{
  const Beginning<dim> is_nearer(nodes, edge);
  for (auto &chain : chains)
    if (chain.closed)
      // Any node can be the first of a ring.
      std::rotate(
        chain.nodes.begin(),
        std::min_element(chain.nodes.begin(), chain.nodes.end(), is_nearer),
        chain.nodes.end());
    else if (is_nearer(chain.nodes.back(), chain.nodes.front()))
      std::reverse(chain.nodes.begin(), chain.nodes.end());
  std::stable_sort(
    chains.begin(), chains.end(), [&](const Chain &a, const Chain &b) {
      return is_nearer(a.nodes.front(), b.nodes.front());
    });

  double length = 0;
  for (const auto &chain : chains)
    {
      auto lengths = lengths_of_chain(nodes, chain);
      auto along   = chain.nodes;
      if (chain.closed)
        {
          along.push_back(along.front());
          lengths.push_back(0);
        }
      for (unsigned int i = 0; i < along.size(); ++i)
        {
          if (!row.front.empty())
            length += nodes.pairs[row.front.back()].position.distance(
              nodes.pairs[along[i]].position);
          row.front.push_back(along[i]);
          row.positions.push_back(length);
          row.lengths.push_back(lengths[i]);
        }
    }
}
} // namespace


template <int dim>
void
set_front(const SurfaceNodes<dim> &nodes,
          const BladeEdge<dim> &edge,
          const std::vector<Chain> &chains,
          const bool axis_follows,
          Row &row)
{
  if (axis_follows)
    order_by_coordinate(nodes, edge, chains, row);
  else
    order_by_length(nodes, edge, chains, row);
}



template <int dim>
void
order_fronts(const SurfaceNodes<dim> &nodes,
             const BladeEdge<dim> &edge,
             std::vector<Row> &rows)
{
  std::vector<unsigned int> layer_of_node(nodes.pairs.size());
  for (unsigned int l = 0; l < rows.size(); ++l)
    for (const unsigned int p : rows[l].pairs)
      layer_of_node[p] = l;
  std::vector<std::set<unsigned int>> faces(rows.size());
  for (unsigned int f = 0; f < nodes.faces.size(); ++f)
    for (const unsigned int p : nodes.faces[f].pairs)
      faces[layer_of_node[p]].insert(f);

  std::vector<std::vector<Chain>> chains;
  bool axis_follows = true;
  for (unsigned int l = 0; l < rows.size(); ++l)
    {
      chains.push_back(
        follow_links(rows[l].pairs,
                     link_nodes(nodes,
                                edge,
                                layer_of_node,
                                l,
                                std::vector<unsigned int>(faces[l].begin(),
                                                          faces[l].end()))));
      for (const auto &chain : chains.back())
        axis_follows = axis_follows && is_monotone(nodes, edge, chain);
    }
  for (unsigned int l = 0; l < rows.size(); ++l)
    set_front(nodes, edge, chains[l], axis_follows, rows[l]);
}



template void
set_front(const SurfaceNodes<2> &,
          const BladeEdge<2> &,
          const std::vector<Chain> &,
          const bool,
          Row &);
template void
set_front(const SurfaceNodes<3> &,
          const BladeEdge<3> &,
          const std::vector<Chain> &,
          const bool,
          Row &);
template void
order_fronts(const SurfaceNodes<2> &, const BladeEdge<2> &, std::vector<Row> &);
template void
order_fronts(const SurfaceNodes<3> &, const BladeEdge<3> &, std::vector<Row> &);
} // namespace Setsudan
