// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <setsudan/space/linear_algebra.h>

#include <functional>
#include <vector>

namespace Setsudan
{
/**
 * The unknowns of a matrix of one process, ascending, in the parts into which
 * it falls: none has an entry with one of another part. Unknowns that stand
 * alone are in the first part.
 */
std::vector<std::vector<unsigned int>>
connected_components(const LA::SparseMatrix &matrix);

/** Do something for each of some parts, on all cores, as if one part after the
 * other were done: what fails is thrown. */
void
parallel_for(const unsigned int n_parts,
             const std::function<void(unsigned int)> &work);
} // namespace Setsudan
