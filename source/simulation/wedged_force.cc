// SPDX-License-Identifier: LGPL-2.1-or-later
#include <setsudan/simulation/wedged_force.h>

#include <algorithm>

namespace Setsudan
{
template <int dim>
WedgedForce<dim>::WedgedForce(const Scene<dim> &scene)
  : ContactDrive<dim>(scene)
{
}



template <int dim>
std::optional<Split>
WedgedForce<dim>::ramp(BladeMotion &load)
{
  const auto &path  = *this->path;
  const double most = this->scene.division.max_load_factor;
  while (true)
    {
      const double end = std::min({path.end(), this->search->end(), most});
      const auto split = this->search->first_split(load, end);
      load.travel      = split ? split->travel : end;
      if (split || end == most)
        return split;
      if (path.end() <= end)
        this->path->cross_end();
      this->search->cross(end);
    }
}



template <int dim>
State<dim>
WedgedForce<dim>::advance(CutBody<dim> &body,
                          const unsigned int row,
                          const State<dim> &from)
{
  const bool is_checked = this->is_checked(row);
  const bool rises =
    this->scene.division.load_control == DivisionParameters::LoadControl::ramp;
  // The load factor stands in the place of a travel.
  BladeMotion load;
  load.travel             = !rises ? 1 : is_checked ? 0 : from.load_factor;
  CutContact<dim> &of_cut = this->contact(body, from);
  this->path              = of_cut.path(row, 0, load, this->path.get());
  this->search->begin(body, of_cut, row, *this->path, load);
  const auto split = rises && is_checked ? ramp(load) : std::optional<Split>();
  State<dim> state =
    of_cut.state(*this->path, row, load.travel, from.displacement);
  state.stress = split ? split->stress : this->search->stress_at(load.travel);
  state.yields = split || !is_checked || (!rises && state.stress.yields());
  return state;
}



template <int dim>
State<dim>
WedgedForce<dim>::finish(CutBody<dim> &body, const State<dim> &from)
{
  CutContact<dim> *const of_cut = this->cut_contact.get();
  State<dim> state =
    of_cut != nullptr && of_cut->has_last_stage() &&
        of_cut->is_of_present_body()
      ? of_cut->state(*of_cut->path_without_blade({}, this->path.get()),
                      body.seam().rows().size(),
                      0,
                      from.displacement)
      : Drive<dim>::finish(body, from);
  this->path.reset();
  this->cut_contact.reset();
  return state;
}



template class WedgedForce<2>;
template class WedgedForce<3>;
} // namespace Setsudan
