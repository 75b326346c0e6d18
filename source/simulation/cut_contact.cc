// SPDX-License-Identifier: LGPL-2.1-or-later
#include <setsudan/simulation/cut_contact.h>

#include <algorithm>

namespace Setsudan
{
using namespace dealii;

namespace
{
/** The depth of the shallowest row but the first. */
template <int dim>
double
shortest_row(const CutBody<dim> &body)
{
  double shortest = body.mesh().extent();
  if (!body.has_cut())
    return shortest;
  const auto &rows = body.seam().rows();
  for (unsigned int row = 1; row < rows.size(); ++row)
    shortest = std::min(shortest, rows[row].depth - rows[row - 1].depth);
  return shortest;
}



/** A parameter of a path that is small: of the travel, beside a row; of the
 * load factor, beside the scene's loads. */
template <int dim>
double
small_step(const CutBody<dim> &body)
{
  return 1e-9 * (body.scene().blade.travels
                   ? shortest_row(body)
                   : std::max(1., body.scene().division.max_load_factor));
}



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
unsigned int
CutContact<dim>::n_rows(const CutBody<dim> &body)
{
  return body.has_cut() ? body.seam().rows().size() : 0;
}



template <int dim>
bool
CutContact<dim>::has_forces() const
{
  return body.has_cut() && !body.scene().blade.travels;
}



template <int dim>
ContactBasis<dim>
CutContact<dim>::make_basis(CutBody<dim> &body, const BladeProfile &profile)
{
  if (!body.has_cut())
    return {body.communicator(), *body.board()};
  return {body.model(),
          body.surface(),
          body.seam(),
          body.cut().edge,
          {body.scene().blade.sliding,
           !profile.facets.empty(),
           body.scene().blade.travels},
          body.earlier_cuts(),
          body.board(),
          body.entry_hats()};
}



template <int dim>
CutContact<dim>::CutContact(CutBody<dim> &body,
                            const BladeProfile &profile,
                            const LA::Vector &displacement)
  : body(body)
  , profile(profile)
  , basis(make_basis(body, profile))
  , last_stage(find_last_stage(body))
  , step(small_step(body))
  , compliance(StageCompliance<dim>::make(body, stage_forces(), last_stage))
{
  if (body.board())
    measured = work_of(basis.vectors(), displacement);
}



template <int dim>
StageForces
CutContact<dim>::stage_forces() const
{
  StageForces forces{basis.vectors(), {}};
  if (has_forces())
    for (unsigned int n = 0; n <= last_stage; ++n)
      forces.vectors.push_back(forces_on_edge(body, n));
  forces.of_stage = [this](const unsigned int n_split) {
    auto vectors = basis.vectors_of_stage(n_split, 0);
    if (has_forces())
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
  return path(profile, n_split, n_ahead, motion, neighbour);
}



template <int dim>
std::unique_ptr<ContactPath<dim>>
CutContact<dim>::path_without_blade(const BladeMotion &motion,
                                    const ContactPath<dim> *neighbour)
{
  return path(no_profile, n_rows(body), 0, motion, neighbour);
}



template <int dim>
std::unique_ptr<ContactPath<dim>>
CutContact<dim>::path(const BladeProfile &of_blade,
                      const unsigned int n_split,
                      const unsigned int n_ahead,
                      const BladeMotion &motion,
                      const ContactPath<dim> *neighbour)
{
  const auto &products = compliance->products(n_split);
  auto path            = std::make_unique<ContactPath<dim>>(
    std::make_unique<ContactStage<dim>>(
      basis, n_split, n_ahead, products, untouched(products, n_split)),
    of_blade,
    body.scene().blade.sliding,
    step);
  path->begin(motion, neighbour, measured);
  return path;
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
  if (!has_forces())
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
state_on_board(CutBody<dim> &body, const State<dim> &from)
{
  const BladeProfile no_blade;
  CutContact<dim> contact(body, no_blade, from.displacement);
  State<dim> state = contact.state(
    *contact.path_without_blade({}, nullptr), 0, 0, from.displacement);
  state.motion = from.motion;
  return state;
}



template class CutContact<2>;
template class CutContact<3>;
template State<2>
state_on_board(CutBody<2> &, const State<2> &);
template State<3>
state_on_board(CutBody<3> &, const State<3> &);
} // namespace Setsudan
