// SPDX-License-Identifier: LGPL-2.1-or-later
#include <setsudan/parameters/exceptions.h>
#include <setsudan/simulation/contact_way.h>
#include <setsudan/solver/no_equilibrium.h>

#include <algorithm>
#include <optional>
#include <utility>

namespace Setsudan
{
using namespace dealii;

template <int dim>
NonlinearContact<dim>::Stage::Stage(const NonlinearContact &contact,
                                    const unsigned int n_split,
                                    const unsigned int n_ahead)
  : n_split(n_split)
  , n_ahead(n_ahead)
  , constraints(contact.body.constraints_after(n_split))
  , springs(contact.springs())
  , vectors(contact.basis.vectors_of_stage(n_split, n_ahead))
  , tangent(contact.body.model(),
            constraints,
            contact.vectors_of(vectors),
            springs)
{
}



template <int dim>
NonlinearContact<dim>::NonlinearContact(CutBody<dim> &body,
                                        const BladeProfile &profile,
                                        const LA::Vector &displacement)
  : ContactBase<dim>(body, profile, displacement)
  , n_changes(body.n_changes())
{
  // Says whether all that is cut is held.
  body.constraints_after(this->n_rows());
}



template <int dim>
NonlinearContact<dim>::~NonlinearContact() = default;



template <int dim>
typename NonlinearContact<dim>::Stage &
NonlinearContact<dim>::stage(const unsigned int n_split,
                             const unsigned int n_ahead) const
{
  // The present one, and those of two trials: each has a factor.
  constexpr unsigned int most_kept = 3;
  const auto found =
    std::find_if(stages.begin(), stages.end(), [&](const Stage &known) {
      return known.n_split == n_split && known.n_ahead == n_ahead;
    });
  if (found != stages.end())
    stages.splice(stages.begin(), stages, found);
  else
    {
      if (stages.size() == most_kept)
        stages.pop_back();
      stages.emplace_front(*this, n_split, n_ahead);
    }
  return stages.front();
}



template <int dim>
std::vector<UnknownForces>
NonlinearContact<dim>::vectors_of(
  const std::vector<unsigned int> &numbers) const
{
  std::vector<UnknownForces> vectors;
  for (const unsigned int number : numbers)
    vectors.push_back(basis.vectors()[number]);
  return vectors;
}



template <int dim>
LA::Vector
NonlinearContact<dim>::on_body(const std::vector<double> &forces) const
{
  return this->nodal_forces(
    this->on_unknowns(forces, 0, basis.vectors().size()));
}



template <int dim>
std::vector<UnknownForces>
NonlinearContact<dim>::springs() const
{
  return body.board() ? body.board()->springs() : std::vector<UnknownForces>();
}



template <int dim>
ContactEquilibrium<dim>
NonlinearContact<dim>::follow(const BladeProfile &of_blade,
                              const unsigned int n_split,
                              const unsigned int n_ahead,
                              const BladeMotion &motion,
                              const Equilibrium &from) const
{
  Stage &here      = stage(n_split, n_ahead);
  Equilibrium last = from;
  // Another time has passed since then than from where it was reached.
  if (!body.model().internal.empty())
    last.internal = evaluate_laws(body.model(), last.displacement);
  Way way(*this, here, of_blade, motion, last);
  unsigned int n_steps = 0;
  std::optional<SolverError> failure;
  const double reached = follow_in_parts(
    [&](const double behind, const double part) -> std::optional<unsigned int> {
      std::optional<Equilibrium> next;
      if (!succeeds(
            [&] {
              next = way.go(last, behind, part);
              return next.has_value();
            },
            failure))
        return {};
      last = std::move(*next);
      n_steps += last.n_steps;
      return last.n_steps;
    });
  if (reached < 1)
    {
      if (failure)
        throw *failure;
      throw_no_equilibrium(body.model(),
                           here.constraints,
                           body.scene().solver,
                           last.displacement,
                           reached);
    }
  last.n_steps = n_steps;
  return last;
}



template <int dim>
ContactEquilibrium<dim>
NonlinearContact<dim>::begin(const unsigned int n_split,
                             const unsigned int n_ahead,
                             const BladeMotion &motion,
                             const LA::Vector &displacement) const
{
  Equilibrium from;
  from.n_split      = n_split;
  from.travel       = motion.travel;
  from.displacement = displacement;
  from.internal     = evaluate_laws(body.model(), displacement);
  return follow(profile, n_split, n_ahead, motion, from);
}



template <int dim>
ContactEquilibrium<dim>
NonlinearContact<dim>::reach(const unsigned int n_split,
                             const unsigned int n_ahead,
                             const BladeMotion &motion,
                             const Equilibrium &from) const
{
  return follow(profile, n_split, n_ahead, motion, from);
}



template <int dim>
ContactEquilibrium<dim>
NonlinearContact<dim>::without_blade(const BladeMotion &motion,
                                     const Equilibrium &from) const
{
  return follow(this->no_profile, this->n_rows(), 0, motion, from);
}



template <int dim>
State<dim>
NonlinearContact<dim>::state(const Equilibrium &equilibrium,
                             const unsigned int row) const
{
  State<dim> state =
    loaded_state(body,
                 this->blade_load(*equilibrium.path, row, equilibrium.travel),
                 1,
                 this->board_load(*equilibrium.path, equilibrium.travel));
  set_solution(body.model(),
               {equilibrium.displacement,
                equilibrium.internal.forces,
                equilibrium.quality,
                equilibrium.n_steps},
               state);
  this->measure_board(state);
  return state;
}



template class NonlinearContact<2>;
template class NonlinearContact<3>;
} // namespace Setsudan
