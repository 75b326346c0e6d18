// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <setsudan/space/linear_algebra.h>

#include <cholmod.h>

#include <vector>

namespace Setsudan
{
/**
 * The lower triangle of a symmetric matrix in another order, in CHOLMOD's
 * format, for the caller to free.
 *
 * @param place where each unknown comes; those that are not wanted come
 *   nowhere, at -1.
 * @param n     how many are wanted.
 */
cholmod_sparse *
lower_triangle(const LA::SparseMatrix &matrix,
               const std::vector<int> &place,
               const unsigned int n,
               cholmod_common &common);

/**
 * Some unknowns of a matrix in an order in which their elimination leaves few
 * entries, by METIS. Entries that are 0 count: so the unknowns of a node have
 * the same neighbors, and METIS takes them as one.
 *
 * @param unknowns ascending.
 */
std::vector<int>
order_of_elimination(const LA::SparseMatrix &matrix,
                     const std::vector<unsigned int> &unknowns,
                     cholmod_common &common);
} // namespace Setsudan
