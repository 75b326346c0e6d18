// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <setsudan/cut/yield/front_stresses.h>

#include <functional>

namespace Setsudan
{
/**
 * Driving and required quantity of a row: a stress, or with the criterion
 * `energy release` an energy per area.
 */
struct CuttingStress
{
  double reached  = 0;
  double required = 0;

  /** Whether what is reached exceeds what is required, or nothing is. */
  bool
  yields() const;
};

/**
 * The part of a stress that a criterion compares with the shear limit. All
 * measures are convex in the stress, and in simple shear on the cut they are
 * the shear stress.
 *
 * - maximum and mean shear: (s1 - s3) / 2 of the principal stresses (Tresca);
 * - von Mises: sqrt(J2), with J2 half the square of the deviatoric stress;
 * - traction on the cut: (max(t_n, 0)^2 + |t_s|^2)^1/2 of the normal and the
 *   shear traction, of which the normal one counts if it pulls (as for cohesive
 *   zones: Camacho and Ortiz 1996, International Journal of Solids and
 *   Structures 33, 2899-2938).
 */
double
stress_measure(const YieldParameters::Criterion criterion,
               const FrontStress &stress);

/**
 * The cutting stress (equation 17 of Kakefuda et al. 1996): the largest measure
 * over the samples, or over the means of the process zones; where they are of
 * different materials, that which is largest in relation to its shear limit.
 *
 * The stress under a concentrated load is singular, so that a measure that is
 * not averaged grows as elements shrink.
 */
CuttingStress
cutting_stress(const YieldParameters::Criterion criterion,
               const FrontStresses &stresses,
               const double sharpness,
               const MPI_Comm communicator);

/** What a blade requires of a limit that holds for sharpness 0, a shear limit
 * or a toughness: limit x (1 - sharpness), equation 18. */
double
requirement(const double limit, const double sharpness);

/** The stresses under a load: base + factor x per_load. */
FrontStresses
superpose(const FrontStresses &base,
          const FrontStresses &per_load,
          const double factor);

/** The load factor at which a row yields. */
struct YieldFactor
{
  /** The factor, or the largest allowed one where the row does not yield. */
  double load_factor;
  CuttingStress stress;
  /** True if the criterion is met at `load_factor`; equality counts. */
  bool yields;
};

/**
 * The smallest load factor in [0, max_load_factor] at which the cutting stress
 * reaches what is required. In relation to the requirement the stress must be
 * convex in the factor, so that there is at most one such point beyond 0, and a
 * bracketing root finder cannot miss it.
 */
YieldFactor
find_yield_load(const std::function<CuttingStress(double)> &stress_at,
                const double max_load_factor);
} // namespace Setsudan
