// SPDX-License-Identifier: LGPL-2.1-or-later
#include <deal.II/base/exceptions.h>

#include <setsudan/body/box_numbering.h>
#include <setsudan/mesh/nodes.h>

namespace Setsudan
{
using namespace dealii;

template <int dim>
BoxNumbering<dim>::BoxNumbering(const Indices &n_elements)
  : n_elements(n_elements)
{
}



template <int dim>
unsigned int
BoxNumbering<dim>::nodes_in_even_layer() const
{
  const unsigned int nx = n_elements[0], ny = n_elements[1];
  return (2 * nx + 1) * (ny + 1) + (nx + 1) * ny;
}



template <int dim>
unsigned int
BoxNumbering<dim>::nodes_in_odd_layer() const
{
  return (n_elements[0] + 1) * (n_elements[1] + 1);
}



template <int dim>
unsigned int
BoxNumbering<dim>::n_nodes() const
{
  const unsigned int nz = dim == 3 ? n_elements[dim - 1] : 0;
  return (nz + 1) * nodes_in_even_layer() + nz * nodes_in_odd_layer();
}



template <int dim>
unsigned int
BoxNumbering<dim>::node_number(const Indices &half_indices) const
{
  const unsigned int nx = n_elements[0];
  const unsigned int i = half_indices[0], j = half_indices[1];
  const unsigned int k = dim == 3 ? half_indices[dim - 1] : 0;
  Assert(i % 2 + j % 2 + k % 2 <= 1,
         ExcMessage("There is no node in the middle of a face or an element."));

  const unsigned int layer =
    (k + 1) / 2 * nodes_in_even_layer() + k / 2 * nodes_in_odd_layer();
  if (k % 2 == 1)
    return layer + j / 2 * (nx + 1) + i / 2;
  return layer + (j + 1) / 2 * (2 * nx + 1) + j / 2 * (nx + 1) +
         (j % 2 == 0 ? i : i / 2);
}



template <int dim>
unsigned int
BoxNumbering<dim>::node_number(const unsigned int element,
                               const unsigned int node) const
{
  const Point<dim> unit = unit_point_of_node<dim>(node);
  Indices half_indices  = element_indices(element);
  for (unsigned int d = 0; d < dim; ++d)
    half_indices[d] =
      2 * half_indices[d] + static_cast<unsigned int>(2 * unit[d]);
  return node_number(half_indices);
}



template <int dim>
unsigned int
BoxNumbering<dim>::element_number(const Indices &indices) const
{
  unsigned int number = 0;
  for (int d = dim - 1; d >= 0; --d)
    number = number * n_elements[d] + indices[d];
  return number;
}



template <int dim>
typename BoxNumbering<dim>::Indices
BoxNumbering<dim>::element_indices(unsigned int element) const
{
  Indices indices;
  for (unsigned int d = 0; d < dim; ++d)
    {
      indices[d] = element % n_elements[d];
      element /= n_elements[d];
    }
  return indices;
}



template class BoxNumbering<2>;
template class BoxNumbering<3>;
} // namespace Setsudan
