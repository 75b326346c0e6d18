#pragma once

#include <setsudan/elasticity/linear_algebra.h>

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
 * The unknowns in an order in which their elimination leaves few entries, by
 * METIS.
 *
 * @param last those that shall come last, in their order.
 */
std::vector<int>
order_of_elimination(const LA::SparseMatrix &matrix,
                     const std::vector<unsigned int> &last,
                     cholmod_common &common);
} // namespace Setsudan
