#pragma once

#include <setsudan/space/discretization.h>

namespace Setsudan
{
/**
 * Carry a displacement to another mesh of the same elements, as the surgery
 * makes it: every node gets what the same node of the same element had. The
 * meshes may be distributed differently over the processes.
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
