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

/** Where a body is pressed together most. */
template <int dim>
struct SmallestVolume
{
  /** The smallest determinant of the deformation gradient at nodes. */
  double ratio         = std::numeric_limits<double>::max();
  unsigned int element = 0;
  /** The node at rest. */
  dealii::Point<dim> node;
};

/** The same on all processes.
 *
 * @param displacement without ghosts. */
template <int dim>
SmallestVolume<dim>
find_smallest_volume(const ElasticModel<dim> &model,
                     const LA::Vector &displacement);

/** Whether the body turns by a right angle or more at a node on the way from
 * one state to another: by the rotation of F1 F0^-1, where F0 and F1 are the
 * deformation gradients. A body that has been inside out on the straight way,
 * and is no more, does: some x is then turned to -x. A shear of any size does
 * not, though lines may point backwards behind it.
 *
 * @param from and to are displacements without ghosts. */
template <int dim>
bool
turns_over(const ElasticModel<dim> &model,
           const LA::Vector &from,
           const LA::Vector &to);

/** @param displacement without ghosts. */
template <int dim>
DeformationExtremes
find_extremes(const ElasticModel<dim> &model, const LA::Vector &displacement);

/** The same for any type of element, cell by cell and many times slower.
 *
 * @param displacement with ghosts.
 * @param internal see StressEvaluator. */
template <int dim>
DeformationExtremes
find_extremes(const Discretization<dim> &discretization,
              const MaterialParameters<dim> &materials,
              const LA::Vector &displacement,
              const InternalVariables<dim> *internal = nullptr);

/** Whether a body can come from one displacement to another at once: all
 * volumes are positive, and nothing turns over. Neither vector has ghosts. */
template <int dim>
bool
is_attainable(const ElasticModel<dim> &model,
              const LA::Vector &from,
              const LA::Vector &to);
} // namespace Setsudan
