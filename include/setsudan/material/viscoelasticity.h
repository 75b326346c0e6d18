// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <setsudan/material/small_strain_law.h>

#include <memory>
#include <string>
#include <utility>
#include <vector>

namespace Setsudan
{
/** Moduli that relax: parts of those at once, each with its relaxation time,
 * which a sudden strain finds and which are gone a long time later (a Prony
 * series). */
struct Relaxation
{
  /** Of a modulus, and the time in which this part of it falls to 1/e. */
  using Terms = std::vector<std::pair<double, double>>;

  Terms shear;
  Terms bulk;

  bool
  empty() const
  {
    return shear.empty() && bulk.empty();
  }

  /** The part of a modulus that is left when all has relaxed. */
  static double
  lasting_part(const Terms &terms);

  /** What is left of moduli then. */
  Hooke
  long_after(const Hooke &at_once) const;
};

/**
 * Linear viscoelasticity of small strain: a law that lasts, and beside it
 * Maxwell elements, springs in series with dashpots, of which each has a part
 * of the shear modulus or of the bulk modulus. With the strain e of such a
 * spring, C its stiffness and t its relaxation time,
 *   stress = C e,   de/dt = d strain/dt - e/t,
 * which is solved exactly for a strain that changes at a constant rate in each
 * step (Taylor, Pister and Goudreau 1970, International Journal for Numerical
 * Methods in Engineering 2, 45-59). A step that takes no time leaves the
 * dashpots as they are. What they turn into heat is that of this solution, too.
 *
 * Internal variables: what viscosity has turned into heat, the last strain and
 * change of volume, those of the dashpots, and the ones of the law that lasts.
 */
class Viscoelasticity : public SmallStrainLaw
{
public:
  /** @param lasting what is left when all has relaxed; relaxation of
   *   `at_once` says how. */
  Viscoelasticity(const std::shared_ptr<const SmallStrainLaw> &lasting,
                  const Hooke &at_once,
                  const Relaxation &relaxation);

  std::string
  name() const override;

  bool
  is_plastic() const override
  {
    return lasting->is_plastic();
  }

  bool
  is_viscous() const override
  {
    return true;
  }

  unsigned int
  n_internal() const override;

  void
  initialize(const dealii::ArrayView<double> &internal) const override;

  SmallStrainResponse
  respond(const dealii::SymmetricTensor<2, 3> &strain,
          const double dilatation,
          const History &history) const override;

private:
  struct MaxwellElement
  {
    /** Lamé's constants of the spring. */
    double lambda;
    double mu;
    double relaxation_time;
  };

  const std::shared_ptr<const SmallStrainLaw> lasting;
  std::vector<MaxwellElement> elements;
};
} // namespace Setsudan
