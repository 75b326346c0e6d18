// SPDX-License-Identifier: LGPL-2.1-or-later
#include <setsudan/parameters/exceptions.h>
#include <setsudan/simulation/cut_body.h>
#include <setsudan/solver/condensed/condensed_solver.h>

#include <algorithm>

// The constraints of a body's states, where a blade may touch it, and the
// solvers under them.

namespace Setsudan
{
using namespace dealii;

template <int dim>
typename CutBody<dim>::Constraints
CutBody<dim>::constraints_without_seam() const
{
  const auto &discretization = present_model->discretization;
  IndexSet lines             = discretization.relevant;
  if (newest_seam)
    lines.add_indices(
      newest_seam->coupled_indices(discretization.dof_handler.n_dofs()));
  Constraints constraints(lines);
  for (const auto *part : {&present_model->hanging, &present_model->supports})
    constraints.merge(*part, Constraints::no_conflicts_allowed, true);
  severed.add_constraints(discretization, present_mesh, constraints);
  return constraints;
}



template <int dim>
typename CutBody<dim>::Constraints
CutBody<dim>::constraints(const PairStates &states) const
{
  auto constraints = constraints_without_seam();
  newest_seam->add_constraints(states, constraints);
  constraints.close();
  return constraints;
}



template <int dim>
typename CutBody<dim>::Constraints
CutBody<dim>::constraints() const
{
  if (newest_seam)
    return constraints(pair_states());
  auto constraints = constraints_without_seam();
  constraints.close();
  return constraints;
}



template <int dim>
LA::Vector
CutBody<dim>::opening() const
{
  return newest_seam ? newest_seam->opening(pair_states(),
                                            *present_model,
                                            the_scene.blade.thickness)
                     : present_model->discretization.zero_vector();
}



template <int dim>
void
CutBody<dim>::set_load_factor(const double factor)
{
  load_factor = factor;
  present_model->set_load_factor(factor);
}



template <int dim>
void
CutBody<dim>::take_finite_strain()
{
  materials.take_finite_strain();
  // Nodal forces of pressures are none of the loads any more. The mesh is the
  // same, and so are the numbers of unknowns.
  rebuild();
}



template <int dim>
Choice<SolverKind>
CutBody<dim>::solver_choice() const
{
  return selection.choice(*present_model);
}



template <int dim>
Choice<CutStrategy>
CutBody<dim>::cut_strategy() const
{
  CutSize size;
  if (newest_seam && !is_finished)
    size = {static_cast<unsigned int>(newest_seam->rows().size()),
            2 * dim * newest_seam->n_double_pairs(),
            the_scene.has_contact(),
            false};
  if (present_board)
    {
      size.has_contact = size.has_foundation = true;
      size.n_interface_unknowns += dim * present_board->corners().size();
    }
  if (!present_model->is_linear())
    return choose_nonlinear_cut_strategy(
      *present_model, the_scene.solver, size);
  return choose_cut_strategy(
    the_scene.solver, size_of(present_model->discretization), size);
}



template <int dim>
void
CutBody<dim>::expect_single_states()
{
  has_single_states = true;
}



template <int dim>
std::vector<EntryHat<dim>>
CutBody<dim>::find_entry_hats() const
{
  if (!the_scene.blade.travels)
    return {};
  const auto is_there = [&](const unsigned int element) {
    return !severed.drops ||
           std::none_of(severed.floating().begin(),
                        severed.floating().end(),
                        [&](const FloatingPiece &piece) {
                          return piece.piece == element_labels.piece[element];
                        });
  };
  return Setsudan::entry_hats(*present_model,
                              the_scene.body.mesh,
                              *newest_seam,
                              cut().edge,
                              the_scene.blade.profile,
                              is_there);
}


template <int dim>
std::optional<CutStages>
CutBody<dim>::stages() const
{
  if (has_single_states || cut_strategy().kind == CutStrategy::row_by_row)
    return {};
  CutStages stages;
  stages.n_rows = newest_seam ? newest_seam->rows().size() : 0;
  // Where a piece comes loose constraints change by more than a row, and a
  // criterion may look at states beside those of the cut.
  stages.are_known =
    newest_seam && severed.all_held() &&
    (the_scene.has_contact() || !the_scene.yield.compares_energies());
  stages.interface_unknowns = [this] {
    const auto n_unknowns = present_model->discretization.dof_handler.n_dofs();
    IndexSet unknowns = newest_seam ? newest_seam->coupled_indices(n_unknowns)
                                    : IndexSet(n_unknowns);
    if (present_board)
      unknowns.add_indices(unknowns_of(present_board->corners(), n_unknowns));
    unknowns.add_indices(unknowns_of(present_entry_hats, n_unknowns));
    // Walls of earlier cuts may meet where a blade presses by contact.
    if (the_scene.has_contact())
      for (const auto &pairs : finished_pairs)
        for (const auto &pair : pairs)
          for (const auto *side : {&pair.minus, &pair.plus})
            unknowns.add_indices(side->begin(), side->end());
    return unknowns;
  };
  if (present_board)
    stages.foundation = [this] { return present_board->springs(); };
  stages.without_ties = [this] {
    auto constraints = constraints_without_seam();
    constraints.close();
    return constraints;
  };
  stages.after = [this](const unsigned int n_split) {
    return constraints(newest_seam->states_after(n_split, split_state()));
  };
  return stages;
}



template <int dim>
std::shared_ptr<TangentSolver>
CutBody<dim>::solver(std::shared_ptr<const Constraints> constraints)
{
  const auto of_cut = stages();
  return selection.solver(
    *present_model, std::move(constraints), of_cut ? &*of_cut : nullptr);
}



template <int dim>
std::shared_ptr<TangentSolver>
CutBody<dim>::solver()
{
  return solver(std::make_shared<const Constraints>(constraints()));
}



template <int dim>
std::shared_ptr<TangentSolver>
CutBody<dim>::solver_without(const unsigned int row)
{
  const auto states = newest_seam->released(pair_states(), row);
  if (severed.n_floating(*newest_seam, states) > severed.floating().size())
    throw FloatingPieceError(
      "Splitting row " + std::to_string(row + 1) +
      " leaves a part that nothing holds, and there is no telling what energy "
      "that releases. Hold it in subsection Support, or choose another "
      "Yield/Criterion.");
  return solver(std::make_shared<const Constraints>(constraints(states)));
}



template <int dim>
bool
CutBody<dim>::holds_all_after(const unsigned int n_split) const
{
  const auto states = newest_seam->states_after(n_split, split_state());
  return severed.n_floating(*newest_seam, states) <= severed.floating().size();
}



namespace
{
/** What a scene may ask for instead of contact. */
template <int dim>
std::string
way_without_contact(const Scene<dim> &scene)
{
  return scene.blade.travels ? "Blade/Drive = force"
                             : "Division/Split rows = opened or free";
}
} // namespace


template <int dim>
typename CutBody<dim>::Constraints
CutBody<dim>::constraints_after(const unsigned int n_split) const
{
  if (!newest_seam)
    return constraints();
  if (!holds_all_after(n_split))
    throw FloatingPieceError(
      "The cut frees a part that nothing holds when row " +
      std::to_string(n_split) +
      " splits, and the blade would push it away. Hold it in subsection "
      "Support, or set " +
      way_without_contact(the_scene) + ".");
  return constraints(newest_seam->states_after(n_split, split_state()));
}



template <int dim>
std::shared_ptr<CondensedSolver<dim>>
CutBody<dim>::condensed_solver(const unsigned int n_split)
{
  const auto solver =
    std::dynamic_pointer_cast<CondensedSolver<dim>>(this->solver(
      std::make_shared<const Constraints>(constraints_after(n_split))));
  if (!solver)
    throw SolverError(
      "Contact cannot be found on the unknowns of this cut, since they are "
      "tied to others. Set " +
      (present_board ? ""
                     : std::string("Division/Solve = every row anew or ")) +
      way_without_contact(the_scene) + ".");
  return solver;
}



template <int dim>
std::shared_ptr<CondensedSolver<dim>>
CutBody<dim>::condensed_solver()
{
  return condensed_solver(n_split_rows);
}



#define INSTANTIATE(dim)                                                      \
  template CutBody<dim>::Constraints CutBody<dim>::constraints_without_seam() \
    const;                                                                    \
  template CutBody<dim>::Constraints CutBody<dim>::constraints(               \
    const PairStates &) const;                                                \
  template CutBody<dim>::Constraints CutBody<dim>::constraints() const;       \
  template LA::Vector CutBody<dim>::opening() const;                          \
  template void CutBody<dim>::take_finite_strain();                           \
  template void CutBody<dim>::set_load_factor(const double);                  \
  template Choice<SolverKind> CutBody<dim>::solver_choice() const;            \
  template Choice<CutStrategy> CutBody<dim>::cut_strategy() const;            \
  template void CutBody<dim>::expect_single_states();                         \
  template std::optional<CutStages> CutBody<dim>::stages() const;             \
  template std::shared_ptr<TangentSolver> CutBody<dim>::solver(               \
    std::shared_ptr<const Constraints>);                                      \
  template std::shared_ptr<TangentSolver> CutBody<dim>::solver();             \
  template std::shared_ptr<TangentSolver> CutBody<dim>::solver_without(       \
    const unsigned int);                                                      \
  template bool CutBody<dim>::holds_all_after(const unsigned int) const;      \
  template CutBody<dim>::Constraints CutBody<dim>::constraints_after(         \
    const unsigned int) const;                                                \
  template std::vector<EntryHat<dim>> CutBody<dim>::find_entry_hats() const;  \
  template std::shared_ptr<CondensedSolver<dim>>                              \
  CutBody<dim>::condensed_solver();                                           \
  template std::shared_ptr<CondensedSolver<dim>>                              \
  CutBody<dim>::condensed_solver(const unsigned int);

INSTANTIATE(2)
INSTANTIATE(3)

#undef INSTANTIATE
} // namespace Setsudan
