// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <deal.II/base/array_view.h>
#include <deal.II/base/symmetric_tensor.h>
#include <deal.II/base/tensor.h>

#include <cmath>
#include <string>

namespace Setsudan
{
class FiniteStrainLaw;
class HyperelasticLaw;
class SmallStrainLaw;

/** What becomes of the work that is done on a material, per volume at rest
 * [force/area]; of a body, the integral of that [force length]. */
struct Energy
{
  /** That of which stress and tangent are derivatives in this step of time, up
   * to what does not depend on this state. Where no time passes its changes are
   * those of total(). Infinite where a volume is not positive. */
  double potential = 0;
  /** What is given back. */
  double stored = 0;
  /** What plastic flow has taken since the start: what it has turned into heat,
   * and what its hardening has stored. */
  double plastic = 0;
  /** What viscosity has turned into heat since the start. */
  double viscous = 0;

  /** Of an elastic material. */
  static Energy
  elastic(const double stored)
  {
    return {stored, stored, 0, 0};
  }

  double
  total() const
  {
    return stored + plastic + viscous;
  }

  bool
  is_finite() const
  {
    return std::isfinite(potential);
  }

  void
  add(const double weight, const Energy &other)
  {
    potential += weight * other.potential;
    stored += weight * other.stored;
    plastic += weight * other.plastic;
    viscous += weight * other.viscous;
  }
};

/** What a law answers to a displacement gradient. */
struct MaterialResponse
{
  /** The first Piola-Kirchhoff stress; the Cauchy stress where strains are
   * small [force/area]. */
  dealii::Tensor<2, 3> stress;
  /** Its derivative by the displacement gradient [force/area]. */
  dealii::Tensor<4, 3> tangent;
  Energy energy;
};

/** What a point remembers. */
struct History
{
  /** The internal variables of the last accepted state. */
  dealii::ArrayView<const double> before;
  /** Those of this state; is written. */
  dealii::ArrayView<double> after;
  /** How much later this state is [time]. */
  double time_step = 0;
};

/** The law of a material at a point. Laws are written once, in space; plane
 * strain is a gradient without entries across the plane. */
class ConstitutiveLaw
{
public:
  virtual ~ConstitutiveLaw() = default;

  /** What it is called on the screen. */
  virtual std::string
  name() const
  {
    return "a law of this program's";
  }

  /** Whether the tangent never changes. A body of such laws only is linear. */
  virtual bool
  is_linear() const
  {
    return false;
  }

  /** The stiffness of a law that is linear but not isotropic, or null: to the
   * fast kernels it is unknown [force/area]. */
  virtual const dealii::SymmetricTensor<4, 3> *
  anisotropic_stiffness() const
  {
    return nullptr;
  }

  /** This, if it is a law of finite strain that has an energy; or null. */
  virtual const HyperelasticLaw *
  hyperelastic() const
  {
    return nullptr;
  }

  /** This, if it is another law of finite strain; or null. */
  virtual const FiniteStrainLaw *
  finite_strain() const
  {
    return nullptr;
  }

  /** This, if it is a law of small strain; or null. */
  virtual const SmallStrainLaw *
  small_strain() const
  {
    return nullptr;
  }

  /** Whether the body stays deformed beyond a limit. */
  virtual bool
  is_plastic() const
  {
    return false;
  }

  /** Whether its stress depends on how fast it is deformed. */
  virtual bool
  is_viscous() const
  {
    return false;
  }

  /** How many internal variables a point has. */
  virtual unsigned int
  n_internal() const
  {
    return 0;
  }

  /** Set the internal variables of the body at rest. */
  virtual void
  initialize(const dealii::ArrayView<double> &internal) const
  {
    (void)internal;
  }

  /** @param gradient of the displacement.
   * @param needs_tangent whether the tangent must be set. */
  virtual MaterialResponse
  evaluate(const dealii::Tensor<2, 3> &gradient,
           const History &history,
           const bool needs_tangent) const = 0;
};
} // namespace Setsudan
