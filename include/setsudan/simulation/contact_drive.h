// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <setsudan/simulation/drive.h>
#include <setsudan/simulation/split_search.h>

#include <memory>

namespace Setsudan
{
/** A drive of a blade that touches the body by contact, and that looks for
 * splits along the path of that contact. */
template <int dim>
class ContactDrive : public Drive<dim>
{
protected:
  explicit ContactDrive(const Scene<dim> &scene);

  /** The contact with the cut that is being made.
   *
   * @param from the state before. */
  CutContact<dim> &
  contact(CutBody<dim> &body, const State<dim> &from);

  const BladeProfile profile;
  const std::unique_ptr<SplitSearch<dim>> search;
  std::unique_ptr<CutContact<dim>> cut_contact;
  /** With the rows that are split now. */
  std::unique_ptr<ContactPath<dim>> path;
};
} // namespace Setsudan
