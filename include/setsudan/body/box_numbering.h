// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <deal.II/base/point.h>

#include <array>

namespace Setsudan
{
/**
 * Node and element numbers of a box as in the paper (Kakefuda et al. 1996,
 * figure 3 and equations 19 to 27): x fastest, then y, then z.
 *
 * Nodes lie at half-indices (i, j, k), i in [0, 2 nx] and so on, of which at
 * most one is odd. In 2D, k is 0.
 */
template <int dim>
class BoxNumbering
{
public:
  using Indices = std::array<unsigned int, dim>;

  explicit BoxNumbering(const Indices &n_elements);

  unsigned int
  n_nodes() const;

  /** The node at half-indices of which at most one is odd. */
  unsigned int
  node_number(const Indices &half_indices) const;

  /** A node of an element, by its number within the element (see nodes.h). */
  unsigned int
  node_number(const unsigned int element, const unsigned int node) const;

  unsigned int
  element_number(const Indices &indices) const;

  Indices
  element_indices(unsigned int element) const;

  /** Elements along each axis: the paper's nx, ny, nz. */
  const Indices n_elements;

private:
  unsigned int
  nodes_in_even_layer() const;

  unsigned int
  nodes_in_odd_layer() const;
};
} // namespace Setsudan
