// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <setsudan/material/decoupled_law.h>
#include <setsudan/parameters/parameters.h>

#include <memory>
#include <string>

namespace Setsudan
{
/** Subsection `Deformation`, and of `Material` the laws: how strain is measured
 * and what answers it. */
struct LawParameters
{
  enum class Strain
  {
    small,
    finite,
    /** Small until the range of the linear theory is left. */
    automatic
  };

  Strain strain;
  VolumetricEnergy::Form volumetric;
  /** Of the law of Mooney and Rivlin. */
  double mooney_rivlin_share;
  Ogden::Terms ogden_terms;

  static void
  declare(dealii::ParameterHandler &handler);

  /** @throw SceneError for constants that no material has. */
  explicit LawParameters(const Parameters &parameters);

  /** What a law may be called, separated by '|'. */
  static std::string
  names();

  /**
   * The law of a material. With small strain it is always Hooke's; with
   * `automatic` it is that of finite strain.
   *
   * @param name one of names().
   * @param is_mixed whether the change of volume is projected: `auto` is a law
   *   of which distortion and volume are decoupled then.
   * @return null where a law cannot be mixed.
   */
  std::shared_ptr<const ConstitutiveLaw>
  make(const std::string &name,
       const Hooke &at_rest,
       const bool is_mixed) const;
};
} // namespace Setsudan
