// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <setsudan/mechanics/elastic_model.h>

#include <limits>
#include <string>

namespace Setsudan
{
/** Where the laws of finite strain come closest to the loss of ellipticity. */
template <int dim>
struct LeastEllipticity
{
  /** The smallest resistance a.Q(N) a to a band of shear or compression, of
   * unit vectors N, across the band at rest, and a, along which one of its
   * sides moves from the other; over the shear modulus at rest. The acoustic
   * tensor Q is A_iJkL N_J N_L, where A is the derivative of the first
   * Piola-Kirchhoff stress. Where it is not positive ellipticity is lost: bands
   * as narrow as the mesh allows take the strain. */
  double ratio         = std::numeric_limits<double>::max();
  unsigned int element = 0;
  /** The Gauss point at rest. */
  dealii::Point<dim> point;
  /** The direction N. */
  dealii::Tensor<1, dim> across;
};

/**
 * Search at Gauss points, across principal directions and those of the sides
 * and diagonals of a cube: a loss that is found is one, and one that is not
 * found may be. Polyconvex laws, which cannot lose it, cost nothing; small
 * strain and the mixed formulation are left out. The same on all processes.
 *
 * @param displacement without ghosts.
 */
template <int dim>
LeastEllipticity<dim>
find_least_ellipticity(const ElasticModel<dim> &model,
                       const LA::Vector &displacement);

/** The law that does not resist, and where, as a sentence that something
 * precedes. */
template <int dim>
std::string
describe_ellipticity(const ElasticModel<dim> &model,
                     const LeastEllipticity<dim> &softest);
} // namespace Setsudan
