// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <setsudan/space/discretization.h>

#include <map>
#include <vector>

namespace Setsudan
{
/** Numbers that belong to cells, by the cells' names, which neither surgery nor
 * repartitioning changes. */
using CellData = std::map<CellPath, std::vector<double>>;

/** The data of this process's cells of a discretization, wherever they are:
 * each cell's are among those that one of the processes has. Called by all
 * processes. */
template <int dim>
CellData
exchange_cell_data(const CellData &data, const Discretization<dim> &to);

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
