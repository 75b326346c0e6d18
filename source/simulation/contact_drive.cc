// SPDX-License-Identifier: LGPL-2.1-or-later
#include <setsudan/simulation/contact_drive.h>

namespace Setsudan
{
template <int dim>
ContactDrive<dim>::ContactDrive(const Scene<dim> &scene)
  : Drive<dim>(scene)
  , profile(scene.blade.profile)
  , search(SplitSearch<dim>::make(scene))
{
}



template <int dim>
CutContact<dim> &
ContactDrive<dim>::contact(CutBody<dim> &body)
{
  if (!cut_contact || !cut_contact->is_of(body))
    {
      path.reset();
      cut_contact = std::make_unique<CutContact<dim>>(body, profile);
    }
  return *cut_contact;
}



template class ContactDrive<2>;
template class ContactDrive<3>;
} // namespace Setsudan
