// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <setsudan/material/cut_limit.h>
#include <setsudan/material/element_values.h>
#include <setsudan/material/orthotropic_elasticity.h>

#include <array>
#include <optional>
#include <vector>

namespace Setsudan
{
/** The values of subsection `Material` that depend on the direction in a
 * material, as a scene gives them. */
template <int dim>
class DirectionalValues
{
public:
  /** Young's moduli, Poisson's ratios, shear moduli, shear limits and
   * toughnesses by axis, empty where they are not given; and the axes. */
  using OfElement = std::array<std::vector<double>, 6>;

  static void
  declare(dealii::ParameterHandler &handler);

  /** @throw SceneError for numbers that no material has, or a group of elements
   * that the body does not have. */
  DirectionalValues(const Parameters &parameters, const Body<dim> &body);

  /** 1 where all are the same everywhere; or the number of elements. */
  unsigned int
  size() const;

  OfElement
  of_element(const unsigned int element) const;

private:
  std::array<ElementValues<std::vector<double>>, 6> values;
};

/** What they say of a material; nothing where it is isotropic. */
struct MaterialDirections
{
  std::optional<OrthotropicConstants> elastic;
  std::optional<CutLimit> shear_limit;
  std::optional<CutLimit> toughness;

  /** @throw SceneError for axes that are none, and for constants that do not go
   * together. */
  template <int dim>
  static MaterialDirections
  make(const Parameters &parameters,
       const typename DirectionalValues<dim>::OfElement &values);
};
} // namespace Setsudan
