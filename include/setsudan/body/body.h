#pragma once

#include <deal.II/base/point.h>

#include <setsudan/body/box_numbering.h>
#include <setsudan/body/coarse_mesh.h>
#include <setsudan/parameters/parameters.h>

#include <string>

namespace Setsudan
{
/** Subsection `Body`: the shape and its elements. */
template <int dim>
struct BodyParameters
{
  dealii::Point<dim> size;
  typename BoxNumbering<dim>::Indices n_elements;

  static void
  declare(dealii::ParameterHandler &handler);

  explicit BodyParameters(const Parameters &parameters);
};

/** The body before any cut: its elements and its node numbers. */
template <int dim>
struct Body
{
  explicit Body(const BodyParameters<dim> &parameters);

  CoarseMesh<dim> mesh;
  BoxNumbering<dim> numbering;
};

/**
 * The boundary id of a face of a box: left and right are x min and max, front
 * and back y, bottom and top z; in 2D bottom and top are y.
 *
 * @return whether there is a face of that name.
 */
template <int dim>
bool
find_face(const std::string &name, dealii::types::boundary_id &id);

/** The names that find_face() knows, as a list for messages. */
template <int dim>
std::string
face_names();
} // namespace Setsudan
