// SPDX-License-Identifier: LGPL-2.1-or-later
// A law at one point, and whether stress and tangent are derivatives of its
// energy.
#pragma once

#include <setsudan/material/constitutive_law.h>

#include <deal.II/base/tensor.h>

#include <algorithm>
#include <cmath>
#include <vector>

#include "../test_setup.h"

namespace Setsudan
{
using dealii::Tensor;

/** @param before of size n_internal().
 * @param after is set. */
inline MaterialResponse
evaluate(const ConstitutiveLaw &law,
         const Tensor<2, 3> &gradient,
         const std::vector<double> &before,
         std::vector<double> &after,
         const double time_step = 0)
{
  after.resize(before.size());
  return law.evaluate(
    gradient,
    {{before.data(), before.size()}, {after.data(), after.size()}, time_step},
    true);
}


/** The internal variables of the body at rest. */
inline std::vector<double>
at_rest(const ConstitutiveLaw &law)
{
  std::vector<double> internal(law.n_internal());
  law.initialize({internal.data(), internal.size()});
  return internal;
}


/** Of the energy at a displacement gradient. */
inline void
test_derivatives_at(const Tensor<2, 3> &now,
                    const ConstitutiveLaw &law,
                    const std::vector<double> &before,
                    const double time_step = 0)
{
  std::vector<double> after;
  const auto response   = evaluate(law, now, before, after, time_step);
  constexpr double step = 1e-5;
  double of_energy = 0, of_stress = 0, asymmetry = 0;
  for (unsigned int k = 0; k < 3; ++k)
    for (unsigned int l = 0; l < 3; ++l)
      {
        Tensor<2, 3> change;
        change[k][l] = step;
        const auto behind =
          evaluate(law, now - change, before, after, time_step);
        const auto ahead =
          evaluate(law, now + change, before, after, time_step);
        of_energy =
          std::max(of_energy,
                   std::abs((ahead.energy.potential - behind.energy.potential) /
                              (2 * step) -
                            response.stress[k][l]));
        for (unsigned int i = 0; i < 3; ++i)
          for (unsigned int j = 0; j < 3; ++j)
            {
              of_stress =
                std::max(of_stress,
                         std::abs((ahead.stress[i][j] - behind.stress[i][j]) /
                                    (2 * step) -
                                  response.tangent[i][j][k][l]));
              asymmetry = std::max(asymmetry,
                                   std::abs(response.tangent[i][j][k][l] -
                                            response.tangent[k][l][i][j]));
            }
      }
  check_below("stress: derivative of the energy", of_energy, 1e-8);
  check_below("tangent: derivative of the stress", of_stress, 1e-8);
  check_below("  is symmetric", asymmetry, 1e-13);
}


/** In a state that many laws reach by flowing, from an earlier one. */
inline void
test_derivatives(const ConstitutiveLaw &law,
                 const double time_step = 0,
                 const double size      = 1)
{
  Tensor<2, 3> earlier, now;
  for (unsigned int i = 0; i < 3; ++i)
    for (unsigned int j = 0; j < 3; ++j)
      {
        earlier[i][j] = 0.4 * std::sin(1 + 3 * i + 7 * j);
        now[i][j]     = 0.7 * std::cos(2 + 5 * i + 2 * j);
      }
  std::vector<double> before;
  evaluate(law, size * earlier, at_rest(law), before, time_step);
  test_derivatives_at(size * now, law, before, time_step);
}
} // namespace Setsudan
