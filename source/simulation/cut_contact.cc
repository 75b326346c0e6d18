// SPDX-License-Identifier: LGPL-2.1-or-later
#include <setsudan/parameters/exceptions.h>
#include <setsudan/simulation/cut_contact.h>

#include <algorithm>
#include <sstream>

namespace Setsudan
{
using namespace dealii;

namespace
{
/** How many rows may be split with contact. Under forces the blade is gone
 * behind the last one, and so may pieces be, unless an energy asks for them. */
template <int dim>
unsigned int
find_last_stage(const CutBody<dim> &body)
{
  if (!body.has_cut())
    return 0;
  const unsigned int n_rows = body.seam().rows().size();
  return body.scene().blade.travels || body.scene().yield.compares_energies() ||
             body.holds_all_after(n_rows)
           ? n_rows
           : n_rows - 1;
}



/** The scene's forces on the edge while the first rows are split, the same on
 * all processes. */
template <int dim>
UnknownForces
forces_on_edge(const CutBody<dim> &body, const unsigned int n_split)
{
  unsigned int row          = n_split;
  const unsigned int n_rows = body.seam().rows().size();
  while (row < n_rows && body.is_left_out(row))
    ++row;
  UnknownForces here, all;
  if (row == n_rows)
    return all;
  const auto blade = body.blade_on_row(row);
  for (const auto unknown : body.model().discretization.owned)
    if (blade.nodal_forces(unknown) != 0)
      here.emplace_back(unknown, blade.nodal_forces(unknown));
  for (const auto &of_process :
       Utilities::MPI::all_gather(body.communicator(), here))
    all.insert(all.end(), of_process.begin(), of_process.end());
  return all;
}
} // namespace


template <int dim>
CutContact<dim>::CutContact(CutBody<dim> &body,
                            const BladeProfile &profile,
                            const LA::Vector &displacement)
  : ContactBase<dim>(body, profile, displacement)
  , last_stage(find_last_stage(body))
  , compliance(StageCompliance<dim>::make(body, stage_forces(), last_stage))
{
}



template <int dim>
StageForces
CutContact<dim>::stage_forces() const
{
  StageForces forces{basis.vectors(), {}};
  if (this->has_forces())
    for (unsigned int n = 0; n <= last_stage; ++n)
      forces.vectors.push_back(forces_on_edge(body, n));
  forces.of_stage = [this](const unsigned int n_split) {
    auto vectors = basis.vectors_of_stage(n_split, 0);
    if (this->has_forces())
      vectors.push_back(basis.vectors().size() + n_split);
    return vectors;
  };
  return forces;
}



template <int dim>
std::unique_ptr<ContactPath<dim>>
CutContact<dim>::path(const unsigned int n_split,
                      const unsigned int n_ahead,
                      const BladeMotion &motion,
                      const ContactPath<dim> *neighbour)
{
  const auto &products = compliance->products(n_split);
  return this->make_path(profile,
                         n_split,
                         n_ahead,
                         products,
                         untouched(products, n_split),
                         motion,
                         neighbour);
}



template <int dim>
std::unique_ptr<ContactPath<dim>>
CutContact<dim>::path_without_blade(const BladeMotion &motion,
                                    const ContactPath<dim> *neighbour)
{
  const unsigned int n_split = this->n_rows();
  const auto &products       = compliance->products(n_split);
  return this->make_path(this->no_profile,
                         n_split,
                         0,
                         products,
                         untouched(products, n_split),
                         motion,
                         neighbour);
}



template <int dim>
UntouchedBody
CutContact<dim>::untouched(const LAPACKFullMatrix<double> &products,
                           const unsigned int n_split) const
{
  const unsigned int n = basis.vectors().size(), loads = products.n() - 1;
  UntouchedBody result{{Vector<double>(n), Vector<double>(n)}, {}};
  const auto &in_lift = compliance->work_in_lift();
  result.energy.c[0]  = -products(loads, loads) / 2;
  for (unsigned int v = 0; v < n; ++v)
    result.displacements.constant[v] = products(loads, v) + in_lift[v];
  if (!this->has_forces())
    return result;
  const unsigned int edge = n + n_split;
  for (unsigned int v = 0; v < n; ++v)
    result.displacements.slope[v] = products(edge, v);
  result.energy.c[1] = -products(loads, edge) - in_lift[edge];
  result.energy.c[2] = -products(edge, edge) / 2;
  return result;
}



template <int dim>
State<dim>
CutContact<dim>::state(const ContactPath<dim> &path,
                       const unsigned int row,
                       const double travel,
                       const LA::Vector &guess) const
{
  if (!this->has_forces())
    {
      State<dim> state = solve_state(body,
                                     this->blade_load(path, row, travel),
                                     1,
                                     guess,
                                     this->board_load(path, travel));
      this->measure_board(state);
      return state;
    }
  const State<dim> state =
    solve_state(body, pressing_blade(path, row, travel), travel, guess);
  check(path, state);
  return state;
}



template <int dim>
BladeLoad<dim>
CutContact<dim>::pressing_blade(const ContactPath<dim> &path,
                                const unsigned int row,
                                const double load_factor) const
{
  BladeLoad<dim> blade =
    row < this->n_rows() ? body.blade_on_row(row) : no_blade(body.model());
  blade.pressure = this->nodal_forces(
    this->on_unknowns(path.forces(load_factor), 0, basis.vectors().size()));
  // Behind the last row it is gone.
  if (blade.row)
    blade.opening_force = path.resultants().walls(load_factor);
  return blade;
}



template <int dim>
void
CutContact<dim>::check(const ContactPath<dim> &path,
                       const State<dim> &state) const
{
  const auto [missing, pull] = path.violation(
    work_of(basis.vectors(), state.displacement), state.load_factor);
  const double largest = state.displacement.linfty_norm();
  const double allowed = 1e-10 * std::max(profile.keeps_apart, largest) +
                         10 * state.quality.estimated_relative_error * largest;
  if (missing <= allowed && pull <= 1e-10)
    return;
  std::ostringstream message;
  message << "The contact of the walls with the blade does not hold: they come "
             "nearer to each other than they may, by "
          << missing << ", which must not exceed " << allowed
          << ", or are pulled by " << pull
          << " of the largest pressure. The solution is not to be trusted.";
  throw InvariantError(message.str());
}



template class CutContact<2>;
template class CutContact<3>;
} // namespace Setsudan
