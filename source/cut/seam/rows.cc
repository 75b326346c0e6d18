// SPDX-License-Identifier: LGPL-2.1-or-later
#include <setsudan/cut/seam/bands.h>
#include <setsudan/cut/seam/rows.h>

#include <algorithm>
#include <limits>
#include <map>
#include <numeric>

namespace Setsudan
{
using namespace dealii;

void
DivisionParameters::declare(ParameterHandler &handler)
{
  Setsudan::declare(handler,
                    "Division",
                    "Release",
                    "node row",
                    Patterns::Selection("node row|element row|face band"),
                    "What is split at once: a layer of nodes, a layer of "
                    "corner nodes with the mid-side nodes behind it, or, where "
                    "the elements lie in no straight layers, a band of element "
                    "faces whose centres a straight edge passes.");
  Setsudan::declare(handler,
                    "Division",
                    "Split rows",
                    "opened",
                    Patterns::Selection("opened|wedged|free"),
                    "opened: the blade keeps the two sides of split rows its "
                    "thickness apart; wedged: so far at least, pushing only; "
                    "free: nothing does, as in a crack.");
  Setsudan::declare(handler,
                    "Division",
                    "Row tolerance",
                    "0.01",
                    Patterns::Double(),
                    "Nodes that the blade reaches within this part of the "
                    "shortest line on the cut are one row; at least 0 and less "
                    "than 0.5 [-].");
  Setsudan::declare(handler,
                    "Division",
                    "Load control",
                    "constant",
                    Patterns::Selection("constant|ramp"),
                    "constant: the blade's load is applied whole; ramp: it "
                    "rises from 0 until the row yields.");
  Setsudan::declare(handler,
                    "Division",
                    "Maximum load factor",
                    "1.0",
                    Patterns::Double(),
                    "With ramp, the cut is arrested where more than this "
                    "multiple of the edge loads is needed; at least 0 [-].");
  Setsudan::declare(handler,
                    "Division",
                    "Look-ahead",
                    "0",
                    Patterns::Integer(0, 1000),
                    "With Blade/Drive = travel, how many rows may split at "
                    "once; 0 for 4 toughness/(Young's modulus x row), at least "
                    "2, with which a cut begins in the same way on any mesh "
                    "[-].");
}



namespace
{
DivisionParameters::Release
read_release(const Parameters &parameters)
{
  const auto text = parameters.text("Division", "Release");
  return text == "node row"      ? DivisionParameters::Release::node_row
         : text == "element row" ? DivisionParameters::Release::element_row
                                 : DivisionParameters::Release::face_band;
}

DivisionParameters::SplitRows
read_split_rows(const Parameters &parameters)
{
  const auto text = parameters.text("Division", "Split rows");
  return text == "opened"   ? DivisionParameters::SplitRows::opened
         : text == "wedged" ? DivisionParameters::SplitRows::wedged
                            : DivisionParameters::SplitRows::free;
}
} // namespace


DivisionParameters::DivisionParameters(const Parameters &parameters)
  : release(read_release(parameters))
  , split_rows(read_split_rows(parameters))
  , row_tolerance(parameters.number("Division", "Row tolerance"))
  , load_control(parameters.text("Division", "Load control") == "constant"
                   ? LoadControl::constant
                   : LoadControl::ramp)
  , max_load_factor(parameters.number("Division", "Maximum load factor"))
  , look_ahead(parameters.natural("Division", "Look-ahead"))
{
  parameters.require(row_tolerance >= 0 && row_tolerance < 0.5,
                     "Division",
                     "Row tolerance",
                     "a number from 0 to less than 0.5");
  parameters.require(max_load_factor >= 0,
                     "Division",
                     "Maximum load factor",
                     "a number that is not negative");
}



namespace
{
/** The nodes of the cut in layers, in the order in which the blade reaches
 * them. */
template <int dim>
std::vector<Row>
make_layers(const SurfaceNodes<dim> &nodes,
            const BladeEdge<dim> &edge,
            const double tolerance)
{
  std::vector<double> travel;
  for (const auto &pair : nodes.pairs)
    travel.push_back(edge.travel(pair.position));
  std::vector<unsigned int> order(travel.size());
  std::iota(order.begin(), order.end(), 0);
  std::stable_sort(order.begin(), order.end(), [&](const auto a, const auto b) {
    return travel[a] < travel[b];
  });

  std::vector<Row> layers;
  for (auto begin = order.begin(); begin != order.end();)
    {
      const double first = travel[*begin];
      const auto end     = std::find_if(begin, order.end(), [&](const auto p) {
        return travel[p] > first + tolerance;
      });
      layers.push_back({std::vector<unsigned int>(begin, end),
                        {},
                        {},
                        {},
                        first - travel[order.front()]});
      begin = end;
    }
  order_fronts(nodes, edge, layers);
  return layers;
}



/** The shortest line between nodes of a face of the cut; it has a node in its
 * middle. */
template <int dim>
double
shortest_line(const SurfaceNodes<dim> &nodes)
{
  double shortest = std::numeric_limits<double>::max();
  for (const auto &face : nodes.faces)
    for (unsigned int i = 0; i < face.pairs.size(); ++i)
      for (unsigned int j = 0; j < i; ++j)
        {
          const auto &a = nodes.pairs[face.pairs[i]];
          const auto &b = nodes.pairs[face.pairs[j]];
          if (a.is_corner && b.is_corner)
            shortest = std::min(shortest, a.position.distance(b.position));
        }
  return shortest;
}



/** Whether a layer or band waits for the blade, or goes with another one. */
template <int dim>
bool
is_row(const SurfaceNodes<dim> &nodes,
       const Row &layer,
       const DivisionParameters::Release release)
{
  bool divided = false, held = true, has_corners = false;
  for (const unsigned int p : layer.front)
    {
      divided     = divided || nodes.pairs[p].is_divided;
      held        = held && nodes.pairs[p].supported.all();
      has_corners = has_corners || nodes.pairs[p].is_corner;
    }
  return divided && !held &&
         (release != DivisionParameters::Release::element_row || has_corners);
}
} // namespace


template <int dim>
std::vector<Row>
make_rows(const SurfaceNodes<dim> &nodes,
          const BladeEdge<dim> &edge,
          const DivisionParameters &division,
          const std::vector<SurfaceStrip> &strips)
{
  const double tolerance = division.row_tolerance * shortest_line(nodes);
  const auto layers = division.release == DivisionParameters::Release::face_band
                        ? make_bands(nodes, edge, strips, tolerance)
                        : make_layers(nodes, edge, tolerance);

  std::vector<Row> rows;
  std::vector<unsigned int> ahead;
  for (const auto &layer : layers)
    if (is_row(nodes, layer, division.release))
      {
        rows.push_back(layer);
        rows.back().pairs.insert(
          rows.back().pairs.end(), ahead.begin(), ahead.end());
        ahead.clear();
      }
    else
      {
        auto &with = rows.empty() ? ahead : rows.back().pairs;
        with.insert(with.end(), layer.pairs.begin(), layer.pairs.end());
      }
  return rows;
}



template std::vector<Row>
make_rows(const SurfaceNodes<2> &,
          const BladeEdge<2> &,
          const DivisionParameters &,
          const std::vector<SurfaceStrip> &);
template std::vector<Row>
make_rows(const SurfaceNodes<3> &,
          const BladeEdge<3> &,
          const DivisionParameters &,
          const std::vector<SurfaceStrip> &);
} // namespace Setsudan
