// SPDX-License-Identifier: LGPL-2.1-or-later
// Hooke's law by the way of laws that are not linear, with an internal variable
// that counts the states which were accepted.
#pragma once

#include <setsudan/material/small_strain_law.h>

namespace Setsudan
{
class CountingLaw : public ConstitutiveLaw
{
public:
  explicit CountingLaw(const Hooke &hooke)
    : elastic(hooke)
  {
  }

  unsigned int
  n_internal() const override
  {
    return 1;
  }

  void
  initialize(const dealii::ArrayView<double> &internal) const override
  {
    internal[0] = 0;
  }

  MaterialResponse
  evaluate(const dealii::Tensor<2, 3> &gradient,
           const History &history,
           const bool needs_tangent) const override
  {
    history.after[0] = history.before[0] + 1;
    return elastic.evaluate(gradient, history, needs_tangent);
  }

private:
  const LinearElasticity elastic;
};
} // namespace Setsudan
