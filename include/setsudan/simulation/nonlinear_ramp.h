// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <setsudan/simulation/drive.h>

#include <optional>

namespace Setsudan
{
/** The blade's forces times the smallest factor at which the row yields, as
 * ForceRamp, in a body that is not linear: the factor is bracketed, and the
 * state solved for at each one that is tried. */
template <int dim>
class NonlinearRamp : public Drive<dim>
{
public:
  using Drive<dim>::Drive;

  State<dim>
  advance(CutBody<dim> &body,
          const unsigned int row,
          const State<dim> &from) override;

private:
  /** Two states, of which the row yields in the second one only; that is not
   * there where the row does not yield at the largest factor. */
  struct Bracket
  {
    State<dim> below;
    std::optional<State<dim>> above;
  };

  Bracket
  bracket(CutBody<dim> &body,
          const unsigned int row,
          const State<dim> &from) const;
};
} // namespace Setsudan
