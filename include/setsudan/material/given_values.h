// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <setsudan/material/directional_values.h>
#include <setsudan/material/element_values.h>
#include <setsudan/material/viscoelasticity.h>

#include <string>
#include <tuple>
#include <vector>

namespace Setsudan
{
/** The values of subsection `Material` that elements may have of their own, as
 * a scene gives them. */
template <int dim>
class GivenValues
{
public:
  /** Young's modulus, Poisson's ratio, shear limit, toughness, yield stress,
   * its isotropic and kinematic hardening, how shear and bulk modulus relax,
   * the law, and what depends on the direction. */
  using OfElement = std::tuple<double,
                               double,
                               double,
                               double,
                               double,
                               std::vector<double>,
                               Relaxation::Terms,
                               Relaxation::Terms,
                               std::string,
                               typename DirectionalValues<dim>::OfElement>;

  /** @throw SceneError for a value that no material has, or a group of elements
   * that the body does not have. */
  GivenValues(const Parameters &parameters, const Body<dim> &body);

  /** 1 where all are the same everywhere; or the number of elements. */
  unsigned int
  size() const;

  OfElement
  of_element(const unsigned int element) const;

private:
  ElementValues<double> moduli, ratios, limits, toughnesses, yield_stresses;
  ElementValues<std::vector<double>> hardenings;
  ElementValues<Relaxation::Terms> shear_terms, bulk_terms;
  ElementValues<std::string> names;
  const DirectionalValues<dim> directional;
};
} // namespace Setsudan
