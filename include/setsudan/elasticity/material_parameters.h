#pragma once

#include <setsudan/body/body.h>
#include <setsudan/elasticity/material.h>
#include <setsudan/parameters/parameters.h>

#include <string>
#include <vector>

namespace Setsudan
{
/** What a part of the body is made of. */
struct Material
{
  Hooke hooke;
  double shear_limit;
};

/** Subsection `Material`: the materials, and which element has which. */
template <int dim>
class MaterialParameters
{
public:
  static void
  declare(dealii::ParameterHandler &handler);

  /** @throw SceneError for a value that no material has, or a group of
   * elements that the body does not have. */
  MaterialParameters(const Parameters &parameters, const Body<dim> &body);

  const Material &
  of_element(const unsigned int element) const;

  /** Number of the element's material, from 0. */
  unsigned int
  number(const unsigned int element) const;

  /** The smallest shear limit of all. */
  double
  smallest_shear_limit() const;

  double linear_range;

private:
  std::vector<Material> materials;
  /** Empty where there is one material only. */
  std::vector<unsigned int> material_of_element;
};
} // namespace Setsudan
