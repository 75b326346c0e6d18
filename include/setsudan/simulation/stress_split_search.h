// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <setsudan/simulation/split_search.h>

#include <optional>

namespace Setsudan
{
/**
 * A row splits where the cutting stress at the front reaches what is required.
 * While the contacts stay as they are the stress is linear in the travel and
 * its measure convex: it is not exceeded between two travels at which it is
 * not.
 */
template <int dim>
class StressSplitSearch : public SplitSearch<dim>
{
public:
  using SplitSearch<dim>::SplitSearch;

  void
  begin(CutBody<dim> &body,
        CutContact<dim> &contact,
        const unsigned int row,
        const ContactPath<dim> &path,
        const BladeMotion &motion) override;

  std::optional<Split>
  first_split(const BladeMotion &motion, const double end) override;

  CuttingStress
  stress_at(const double travel) const override;

  /** All that is set free: the criterion does not ask how much it is. */
  double
  surface_energy(CutBody<dim> &body,
                 const unsigned int row,
                 const unsigned int n,
                 const BladeMotion &motion,
                 const double released) const override;

private:
  /** The response of the body with the blade at a travel. */
  LinearResponse
  response_at(const double travel) const;

  /** The travel of a split between that of `known`, where there is none, and
   * another one. */
  std::optional<Split>
  split_before(const BladeMotion &motion,
               const double last,
               const LinearResponse &at_last) const;

  /** What a row requires that splits where the blade is, over a slow one. */
  double
  factor_of_speed(const BladeMotion &motion, const double travel) const;

  CutBody<dim> *body             = nullptr;
  const CutContact<dim> *contact = nullptr;
  const ContactPath<dim> *path   = nullptr;
  unsigned int row               = 0;
  /** Whether the front has been asked where the blade is. */
  bool is_asked = false;
};
} // namespace Setsudan
