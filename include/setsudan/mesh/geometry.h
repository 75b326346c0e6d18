// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <deal.II/base/point.h>
#include <deal.II/base/tensor.h>

#include <setsudan/mesh/coarse_mesh.h>

#include <string>
namespace Setsudan
{
// The isoparametric geometry of elements: the serendipity functions interpolate
// the shape between the nodes (equation 5 of Kakefuda et al. 1996). An element
// whose middle nodes lie in the middle of straight lines is the multilinear
// one.

/** The point of an element at a point of the reference cell. */
template <int dim>
dealii::Point<dim>
point_of_element(const ElementNodes<dim> &nodes,
                 const dealii::Point<dim> &unit_point);

/** The derivatives of the point by the reference coordinates, columns. */
template <int dim>
dealii::Tensor<2, dim>
jacobian_of_element(const ElementNodes<dim> &nodes,
                    const dealii::Point<dim> &unit_point);

/** The unit normal of a face that points out of the element. */
template <int dim>
dealii::Tensor<1, dim>
normal_of_face(const ElementNodes<dim> &nodes,
               const unsigned int face,
               const dealii::Point<dim> &unit_point);

/** The area of a face per area of the reference cell's, at a point of it. */
template <int dim>
double
area_element_of_face(const ElementNodes<dim> &nodes,
                     const unsigned int face,
                     const dealii::Point<dim> &unit_point);

/** The integral of the normal over a face: its length is the area of a plane
 * face. */
template <int dim>
dealii::Tensor<1, dim>
area_vector_of_face(const ElementNodes<dim> &nodes, const unsigned int face);

/** A point as messages name it: (1, 0.5, 2). */
template <int dim>
std::string
text_of(const dealii::Point<dim> &point);

/** How far a coordinate of a point of an element may lie beside a number that a
 * scene gives and still be meant by it: a millionth of the element's shortest
 * line. Sums of lengths are exact up to round-off only, and people write four
 * digits. */
template <int dim>
double
coordinate_tolerance(const ElementNodes<dim> &nodes);

/** Volume (area in 2D), by Gauss's rule with 3 points in each direction. */
template <int dim>
double
volume_of_element(const ElementNodes<dim> &nodes);

/** The integral of the position over an element: over its volume, its centre.
 */
template <int dim>
dealii::Tensor<1, dim>
first_moment_of_element(const ElementNodes<dim> &nodes);

/**
 * The smallest determinant of the Jacobian at the nodes and Gauss points, over
 * the volume of a cube whose edge is the element's longest line: 1 for a
 * cube, 0 for a flat element, negative for an inverted one.
 */
template <int dim>
double
scaled_jacobian(const ElementNodes<dim> &nodes);
} // namespace Setsudan
