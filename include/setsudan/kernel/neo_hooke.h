// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

namespace Setsudan
{
/** The energy U(J) of a change of volume, over its modulus: see
 * VolumetricEnergy. */
enum class VolumetricForm
{
  ciarlet,
  quadratic,
  logarithmic
};

/** A neo-Hookean law, but for its moduli. */
struct NeoHookeForm
{
  VolumetricForm volumetric;
  /** Whether its distortion is that of J^-2/3 C, and the modulus of U the bulk
   * modulus; else it is of C, and the modulus lambda. */
  bool is_isochoric;
};

// What follows is compiled for several kinds of processors: in an unnamed
// namespace no linker takes one for the other.
namespace
{
/**
 * What a neo-Hookean law is at a point, with which
 *   P  = one F + inverse G,   G = F^-T,
 *   dP = one dF - inverse G dF^T G + cross ((G : dF) F + (F : dF) G)
 *        + square (G : dF) G
 * are the first Piola-Kirchhoff stress and its change; or in terms of the right
 * Cauchy-Green tensor C and the strain E
 *   S  = one 1 + inverse C^-1,
 *   dS = -2 inverse C^-1 dE C^-1 + cross ((C^-1 : dE) 1 + tr dE C^-1)
 *        + square (C^-1 : dE) C^-1.
 *
 * @tparam Number double, or a number for each of several cells.
 */
template <typename Number>
struct NeoHookeTerms
{
  Number energy, one, inverse, cross, square;
};



/**
 * @param volume_modulus that of U.
 * @param log_J     ln J.
 * @param isochoric J^-2/3.
 * @param trace_C   in space, also of a plane.
 */
template <typename Number>
inline NeoHookeTerms<Number>
neo_hooke_terms(const NeoHookeForm form,
                const Number mu,
                const Number volume_modulus,
                const Number J,
                const Number log_J,
                const Number isochoric,
                const Number trace_C)
{
  // U, J U', and J U' + J^2 U'', over the modulus.
  Number U{}, first{}, second{};
  switch (form.volumetric)
    {
      case VolumetricForm::ciarlet:
        U      = 0.25 * ((J - 1.) * (J + 1.) - 2. * log_J);
        first  = 0.5 * ((J - 1.) * (J + 1.));
        second = J * J;
        break;
      case VolumetricForm::quadratic:
        U      = 0.5 * ((J - 1.) * (J - 1.));
        first  = J * (J - 1.);
        second = J * (2. * J - 1.);
        break;
      case VolumetricForm::logarithmic:
        U      = 0.5 * (log_J * log_J);
        first  = log_J;
        second = 0. * J + 1.;
        break;
    }
  NeoHookeTerms<Number> terms;
  terms.energy  = volume_modulus * U;
  terms.inverse = volume_modulus * first;
  terms.square  = volume_modulus * second;
  if (form.is_isochoric)
    {
      terms.one = mu * isochoric;
      terms.energy += 0.5 * (mu * (isochoric * trace_C - 3.));
      terms.inverse -= 1. / 3. * (terms.one * trace_C);
      terms.cross = -2. / 3. * terms.one;
      terms.square += 2. / 9. * (terms.one * trace_C);
    }
  else
    {
      terms.one = mu;
      terms.energy += mu * (0.5 * (trace_C - 3.) - log_J);
      terms.inverse -= mu;
      terms.cross = 0. * mu;
    }
  return terms;
}
} // namespace
} // namespace Setsudan
