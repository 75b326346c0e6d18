// SPDX-License-Identifier: LGPL-2.1-or-later
#include <setsudan/body/supports.h>

#include <algorithm>

namespace Setsudan
{
using namespace dealii;

template <int dim>
Supports<dim>::Supports(const SupportParameters<dim> &parameters,
                        const Body<dim> &body)
  : floating_pieces(parameters.floating_pieces)
  , supports(parameters.supports)
  , body(body)
{
}



template <int dim>
NodeSupport<dim>
Supports<dim>::at(const unsigned int cell, const Point<dim> &unit_point) const
{
  NodeSupport<dim> result;
  for (const auto &support : supports)
    if ((support.components & ~result.components).any() &&
        support.region.contains(body, cell, unit_point))
      for (unsigned int c = 0; c < dim; ++c)
        if (support.components[c] && !result.components[c])
          {
            result.components[c]   = true;
            result.displacement[c] = support.displacement[c];
          }
  return result;
}



template <int dim>
std::vector<HeldPoint<dim>>
Supports<dim>::held_points(const std::vector<unsigned int> &cells) const
{
  std::vector<HeldPoint<dim>> points;
  for (const unsigned int cell : cells)
    for (unsigned int node = 0; node < n_element_nodes<dim>; ++node)
      {
        const auto held = at(cell, unit_point_of_node<dim>(node)).components;
        if (held.any())
          points.push_back({body.mesh.node_position(cell, node), held});
      }
  return points;
}



template <int dim>
const std::vector<Support<dim>> &
Supports<dim>::all() const
{
  return supports;
}



template <int dim>
bool
Supports<dim>::move() const
{
  return std::any_of(
    supports.begin(), supports.end(), [](const Support<dim> &support) {
      return support.displacement != Tensor<1, dim>();
    });
}



template <int dim>
bool
Supports<dim>::drop_loose_pieces() const
{
  return floating_pieces == SupportParameters<dim>::LoosePieces::drop;
}



template <int dim>
std::optional<Point<dim>>
Supports<dim>::find_contradiction() const
{
  if (!move())
    return {};
  for (unsigned int cell = 0; cell < body.mesh.cells.size(); ++cell)
    for (unsigned int node = 0; node < n_element_nodes<dim>; ++node)
      {
        const auto point = unit_point_of_node<dim>(node);
        const auto first = at(cell, point);
        for (const auto &support : supports)
          for (unsigned int c = 0; c < dim; ++c)
            if (support.components[c] &&
                support.displacement[c] != first.displacement[c] &&
                support.region.contains(body, cell, point))
              return body.mesh.node_position(cell, node);
      }
  return {};
}



template class Supports<2>;
template class Supports<3>;
} // namespace Setsudan
