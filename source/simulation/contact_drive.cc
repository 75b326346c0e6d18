// SPDX-License-Identifier: LGPL-2.1-or-later
#include <setsudan/simulation/contact_drive.h>

namespace Setsudan
{
namespace
{
/** The body of a blade; a line that forces press in has no facets, but a
 * thickness. */
template <int dim>
BladeProfile
profile_of(const BladeParameters<dim> &blade)
{
  BladeProfile profile = blade.profile;
  if (!blade.travels)
    profile.keeps_apart = blade.thickness;
  return profile;
}
} // namespace


template <int dim>
ContactDrive<dim>::ContactDrive(const Scene<dim> &scene)
  : Drive<dim>(scene)
  , profile(profile_of(scene.blade))
  , search(SplitSearch<dim>::make(scene))
{
}



template <int dim>
CutContact<dim> &
ContactDrive<dim>::contact(CutBody<dim> &body, const State<dim> &from)
{
  if (!cut_contact || !cut_contact->is_of_present_body())
    {
      path.reset();
      cut_contact =
        std::make_unique<CutContact<dim>>(body, profile, from.displacement);
    }
  return *cut_contact;
}



template class ContactDrive<2>;
template class ContactDrive<3>;
} // namespace Setsudan
