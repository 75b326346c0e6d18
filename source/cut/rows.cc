#include <setsudan/cut/rows.h>

#include <algorithm>
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
                    Patterns::Selection("node row|element row"),
                    "What is split at once: a layer of nodes, or a layer of "
                    "corner nodes with the mid-side nodes behind it.");
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
}



DivisionParameters::DivisionParameters(const Parameters &parameters)
  : release(parameters.text("Division", "Release") == "node row"
              ? Release::node_row
              : Release::element_row)
  , load_control(parameters.text("Division", "Load control") == "constant"
                   ? LoadControl::constant
                   : LoadControl::ramp)
  , max_load_factor(parameters.number("Division", "Maximum load factor"))
{
  parameters.require(max_load_factor >= 0,
                     "Division",
                     "Maximum load factor",
                     "a number that is not negative");
}



namespace
{
/** Add a layer of nodes to the row that it goes with. */
void
append_layer(const std::vector<unsigned int> &layer,
             const double depth,
             const bool own_row,
             std::vector<Row> &rows)
{
  if (own_row)
    rows.push_back({layer, layer, depth});
  else
    rows.back().pairs.insert(
      rows.back().pairs.end(), layer.begin(), layer.end());
}
} // namespace


template <int dim>
std::vector<Row>
make_rows(const std::vector<NodePair<dim>> &pairs,
          const Tensor<1, dim> &direction,
          const BladeEdge<dim> &edge,
          const DivisionParameters::Release release)
{
  std::vector<double> depths, positions;
  for (const auto &pair : pairs)
    {
      depths.push_back(direction * Tensor<1, dim>(pair.position));
      positions.push_back(edge.position(pair.position));
    }
  const auto ends        = std::minmax_element(depths.begin(), depths.end());
  const double entry     = *ends.first;
  const double tolerance = 1e-8 * (*ends.second - entry);

  std::vector<unsigned int> order(pairs.size());
  std::iota(order.begin(), order.end(), 0);
  std::sort(order.begin(), order.end(), [&](const auto a, const auto b) {
    return depths[a] < depths[b];
  });

  std::vector<Row> rows;
  for (auto begin = order.begin(); begin != order.end();)
    {
      const double depth = depths[*begin];
      const auto end     = std::find_if(begin, order.end(), [&](const auto p) {
        return depths[p] > depth + tolerance;
      });
      std::vector<unsigned int> layer(begin, end);
      std::sort(layer.begin(), layer.end(), [&](const auto a, const auto b) {
        return std::tie(positions[a], a) < std::tie(positions[b], b);
      });
      begin = end;

      const bool has_corners =
        std::any_of(layer.begin(), layer.end(), [&](const auto p) {
          return pairs[p].is_corner;
        });
      const bool on_board =
        std::all_of(layer.begin(), layer.end(), [&](const auto p) {
          return pairs[p].supported.all();
        });
      const bool own_row =
        rows.empty() ||
        (!on_board &&
         (release == DivisionParameters::Release::node_row || has_corners));
      append_layer(layer, depth - entry, own_row, rows);
    }
  return rows;
}



template std::vector<Row>
make_rows(const std::vector<NodePair<2>> &,
          const Tensor<1, 2> &,
          const BladeEdge<2> &,
          const DivisionParameters::Release);
template std::vector<Row>
make_rows(const std::vector<NodePair<3>> &,
          const Tensor<1, 3> &,
          const BladeEdge<3> &,
          const DivisionParameters::Release);
} // namespace Setsudan
