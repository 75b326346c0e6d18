#pragma once

#include <setsudan/space/discretization.h>

namespace Setsudan
{
/**
 * Transfer a displacement to another discretization of the same elements, as a
 * surgery or a repartitioning makes it: the values of a node are those of the
 * same node of the same element.
 *
 * @param displacement on `from`, with ghosts.
 * @return a vector on `to`, without ghosts.
 */
template <int dim>
LA::Vector
transfer(const Discretization<dim> &from,
         const LA::Vector &displacement,
         const Discretization<dim> &to);
} // namespace Setsudan
