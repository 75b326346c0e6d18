#pragma once

#include <setsudan/cut/blade_edge.h>
#include <setsudan/cut/node_pairs.h>

#include <vector>

namespace Setsudan
{
/** Subsection `Division`: how the cut advances. */
struct DivisionParameters
{
  enum class Release
  {
    node_row,
    element_row
  };
  enum class LoadControl
  {
    constant,
    ramp
  };

  Release release;
  LoadControl load_control;
  double max_load_factor;

  static void
  declare(dealii::ParameterHandler &handler);

  explicit DivisionParameters(const Parameters &parameters);
};

/** Nodes of the cut that are split together. */
struct Row
{
  /** All of them, as indices into the list of node pairs. */
  std::vector<unsigned int> pairs;
  /** Those the blade rests on: the first layer, along the edge. */
  std::vector<unsigned int> front;
  /** How far the front lies behind the entry, along the blade's direction. */
  double depth;
};

/**
 * The rows of a cut, entry first. Layers of equal coordinate along the blade's
 * direction (to 1e-8 of the cut's extent) are rows of their own, or with
 * `element_row` layers of corner nodes take the mid-side layer behind with
 * them, so that the front always rests on corner nodes.
 *
 * A row whose nodes are all supported lies on the board: the blade need not
 * divide it, and it goes together with the row before it.
 */
template <int dim>
std::vector<Row>
make_rows(const std::vector<NodePair<dim>> &pairs,
          const dealii::Tensor<1, dim> &direction,
          const BladeEdge<dim> &edge,
          const DivisionParameters::Release release);
} // namespace Setsudan
