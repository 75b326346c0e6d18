// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <deal.II/base/array_view.h>
#include <deal.II/base/tensor.h>

#include <setsudan/material/material.h>

#include <memory>
#include <string>

namespace Setsudan
{
class HyperelasticLaw;

/** What a law answers to a displacement gradient. */
struct MaterialResponse
{
  /** The first Piola-Kirchhoff stress; the Cauchy stress where strains are
   * small [force/area]. */
  dealii::Tensor<2, 3> stress;
  /** Its derivative by the displacement gradient [force/area]. */
  dealii::Tensor<4, 3> tangent;
  /** Per volume at rest, the energy of which stress and tangent are
   * derivatives: what is stored, and what plastic flow has taken [force/area].
   */
  double energy = 0;
  /** The part of it that plastic flow has taken since the start: what it has
   * turned into heat, and what its hardening has stored. */
  double plastic_energy = 0;
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

  /** The constants of a law whose tangent never changes, or null. A body of
   * such laws only is linear, and is left to the fast kernels. */
  virtual const Hooke *
  linear() const
  {
    return nullptr;
  }

  /** This, if it is a law of finite strain that has an energy; or null. */
  virtual const HyperelasticLaw *
  hyperelastic() const
  {
    return nullptr;
  }

  /** Whether the body stays deformed beyond a limit. */
  virtual bool
  is_plastic() const
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

  /**
   * @param gradient of the displacement.
   * @param before   the internal variables of the last accepted state.
   * @param after    those of this state; is written.
   */
  virtual MaterialResponse
  evaluate(const dealii::Tensor<2, 3> &gradient,
           const dealii::ArrayView<const double> &before,
           const dealii::ArrayView<double> &after) const = 0;
};

/** Hooke's law. */
class LinearElasticity : public ConstitutiveLaw
{
public:
  explicit LinearElasticity(const Hooke &hooke);

  const Hooke *
  linear() const override;

  MaterialResponse
  evaluate(const dealii::Tensor<2, 3> &gradient,
           const dealii::ArrayView<const double> &before,
           const dealii::ArrayView<double> &after) const override;

private:
  const Hooke hooke;
};
} // namespace Setsudan
