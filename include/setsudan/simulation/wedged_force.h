// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <setsudan/simulation/contact_drive.h>

#include <optional>

namespace Setsudan
{
/**
 * The scene's forces on the edge of a blade that keeps the walls of split rows
 * its thickness apart, and pushes only. Which walls it touches depends on the
 * load; between the load factors at which that changes everything is linear in
 * the factor.
 */
template <int dim>
class WedgedForce : public ContactDrive<dim>
{
public:
  explicit WedgedForce(const Scene<dim> &scene);

  State<dim>
  advance(CutBody<dim> &body,
          const unsigned int row,
          const State<dim> &from) override;

  State<dim>
  finish(CutBody<dim> &body, const State<dim> &from) override;

private:
  /** Let the load rise until the row splits, or to the largest that is allowed,
   * in which case nothing is returned. */
  std::optional<Split>
  ramp(BladeMotion &load);
};
} // namespace Setsudan
