// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <setsudan/kernel/neo_hooke.h>

namespace Setsudan
{
/** The energy U(J) that a change of volume stores, J being the volume over that
 * at rest. */
class VolumetricEnergy
{
public:
  /** U over the modulus. All have the second derivative 1 at rest.
   *
   * - Ciarlet:     (J^2 - 1 - 2 ln J) / 4, which grows without limit as J goes
   *   to 0 or infinity, and is convex (Ciarlet and Geymonat 1982, Comptes
   *   Rendus de l'Academie des Sciences 295, 423-426);
   * - quadratic:   (J - 1)^2 / 2, finite for J = 0;
   * - logarithmic: (ln J)^2 / 2, whose pressure falls again beyond J = e. */
  using Form = VolumetricForm;

  /** @param modulus [force/area]. */
  VolumetricEnergy(const Form form, const double modulus);

  /** Whether U is a convex function of J; with a negative modulus, as lambda is
   * where Poisson's ratio is negative, it is not. */
  bool
  is_convex() const
  {
    return form != Form::logarithmic && modulus >= 0;
  }

  /** U per volume at rest [force/area]. */
  double
  value(const double J) const;

  /** U', the mean Cauchy stress that is due to it. */
  double
  derivative(const double J) const;

  double
  second_derivative(const double J) const;

  const Form form;
  const double modulus;
};
} // namespace Setsudan
