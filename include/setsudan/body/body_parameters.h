// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <setsudan/body/body.h>
#include <setsudan/body/mesh_size.h>
#include <setsudan/body/transformation.h>
#include <setsudan/element/element_type.h>
#include <setsudan/parameters/parameters.h>

#include <string>

namespace Setsudan
{
/** Subsection `Body`: the shape and its elements. */
template <int dim>
struct BodyParameters
{
  enum class Shape
  {
    box,
    file
  };

  /** What is done about parts that touch without being joined. */
  enum class OpenJoints
  {
    warn,
    refuse,
    allow
  };

  Shape shape;
  dealii::Point<dim> size;
  typename BoxNumbering<dim>::Indices n_elements;
  std::string file;
  /** How long gmsh may take, in seconds. */
  double meshing_time;
  OpenJoints open_joints;
  Transformation<dim> transformation;
  /** How often all elements are halved along each axis. */
  unsigned int refinement;
  ElementType element_type;

  static void
  declare(dealii::ParameterHandler &handler);

  explicit BodyParameters(const Parameters &parameters);

  /** The size of a mesh when it is refined so. */
  MeshSize<dim>
  refined(MeshSize<dim> mesh) const;

  /** @throw SceneError where the memory does not suffice for a mesh that is
   * refined so. */
  void
  check_refined(const Parameters &parameters, const MeshSize<dim> &mesh) const;
};

/** Make the body that a scene asks for.
 *
 * @throw SceneError where its file cannot be used. */
template <int dim>
Body<dim>
make_body(const Parameters &parameters, const BodyParameters<dim> &choice);
} // namespace Setsudan
