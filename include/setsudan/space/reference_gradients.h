// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <deal.II/base/aligned_vector.h>
#include <deal.II/fe/fe.h>

namespace Setsudan
{
/** The gradients of a scalar element's functions at Gauss's points in reference
 * coordinates, as a kernel takes them: [point][function][direction]. */
template <int dim>
dealii::AlignedVector<double>
reference_gradients(const dealii::FiniteElement<dim> &element,
                    const unsigned int n_gauss_points);
} // namespace Setsudan
