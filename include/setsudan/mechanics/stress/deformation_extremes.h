// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <setsudan/mechanics/elastic_model.h>

#include <limits>

namespace Setsudan
{
/** The extremes of a deformed state. */
struct DeformationExtremes
{
  /** Smallest determinant of the deformation gradient, 1 at rest: not positive
   * where the deformed body overlaps itself. At nodes and Gauss points. */
  double min_jacobian = std::numeric_limits<double>::max();
  /** Largest principal strain in magnitude, at Gauss points. */
  double max_strain = 0;
  /** Largest maximum shear stress, at Gauss points. */
  double max_shear = 0;
  /** Largest displacement of a node. */
  double max_displacement = 0;
};

/** @param displacement without ghosts. */
template <int dim>
DeformationExtremes
find_extremes(const ElasticModel<dim> &model, const LA::Vector &displacement);

/** The same for any type of element, cell by cell and many times slower.
 *
 * @param displacement with ghosts. */
template <int dim>
DeformationExtremes
find_extremes(const Discretization<dim> &discretization,
              const MaterialParameters<dim> &materials,
              const LA::Vector &displacement);
} // namespace Setsudan
