// SPDX-License-Identifier: LGPL-2.1-or-later
#include <deal.II/base/mpi.h>

#include <setsudan/parameters/exceptions.h>
#include <setsudan/simulation/accuracy/choose_refinement.h>
#include <setsudan/simulation/messages.h>
#include <setsudan/simulation/simulation.h>

#include <sstream>

namespace Setsudan
{
using namespace dealii;

template <int dim>
Simulation<dim>::Simulation(const Scene<dim> &scene,
                            const Parameters &parameters,
                            const MPI_Comm communicator,
                            TimerOutput &timer,
                            const std::optional<Checkpoint> &checkpoint)
  : scene(scene)
  , timer(timer)
  , checkpoint(checkpoint)
  , results(scene,
            parameters,
            communicator,
            timer,
            checkpoint ? OutputDirectory::Earlier::kept
                       : OutputDirectory::Earlier::removed)
  , checkpoints(scene.output.checkpoint,
                results.directory,
                results.progress,
                communicator)
  , body(scene,
         checkpoint ? checkpoint->refinement
                    : choose_refinement(scene, results.progress, communicator),
         communicator)
  , drive(Drive<dim>::make(scene, body.model().is_linear()))
{
  if (checkpoint)
    return;
  // From now on the directory is that of a run that has begun.
  checkpoints.make({});
  results.write_parameters(parameters);
  if (scene.material.strain == LawParameters::Strain::small &&
      parameters.text("Material", "Law") != "auto")
    results.progress.warn(
      "Material/Law has no effect with Deformation/Strain = small, which takes "
      "Hooke's law.");
}



template <int dim>
void
Simulation<dim>::run()
{
  results.progress.info(describe_body(body));
  if (const auto line = describe_strain(scene.material))
    results.progress.info(*line);
  for (const auto &sentence : warn_of_memory(scene))
    results.progress.warn(sentence);
  for (const auto &joint : describe_open_joints(scene))
    results.progress.warn(joint);
  try
    {
      make_cuts();
    }
  catch (const NoEquilibriumError &error)
    {
      results.record("arrest", event);
      results.progress.info(describe_instability(body, event, error.what()));
    }
  if (const auto sentence =
        describe_unfelt_work(state.motion.value_or(BladeMotion())))
    results.progress.info(*sentence);
  results.finish();
  results.write_summary();
  checkpoints.finish();
  std::ostringstream line;
  line << "Results in " << scene.output.directory << ": " << n_frames
       << " states, " << body.n_pieces()
       << (body.n_pieces() == 1 ? " piece" : " pieces");
  const std::string doubts = results.describe_doubts();
  results.progress.info(line.str() +
                        (doubts.empty() ? "." : "; " + doubts + "."));
}



template <int dim>
void
Simulation<dim>::make_cuts()
{
  bool goes_on = true;
  body.set_load_factor(
    scene.time.load_factor(checkpoint ? scene.time.duration() : 0));
  if (checkpoint)
    goes_on = resume();
  else
    {
      rest();
      if (body.board())
        lie();
      if (scene.time.passes())
        pass_time();
    }
  if (scene.cut.cuts.empty())
    deform_only();
  for (unsigned int cut = checkpoint ? checkpoint->event.cut + 1 : 0;
       goes_on && cut < scene.cut.cuts.size();
       ++cut)
    {
      if (cut > 0)
        checkpoint_if_due(Checkpoint::Stage::divided);
      goes_on = make_cut(cut);
    }
}



template <int dim>
bool
Simulation<dim>::make_cut(const unsigned int cut)
{
  if (!begin_cut(cut))
    return true;
  if (scene.needs_seam())
    {
      // What a blade that travels has done in earlier cuts.
      const auto motion = state.motion;
      // A body on a board lies there already.
      if (!body.board())
        state = solve(body.blade_on_row(0), 1);
      if (motion)
        state.motion = motion->at_entry();
      split_nodes();
    }
  const unsigned int first_row = open_notch();
  deform(first_row);
  return make_cut_from(first_row);
}



template <int dim>
bool
Simulation<dim>::make_cut_from(const unsigned int first_row)
{
  const unsigned int n_rows = body.seam().rows().size();
  for (unsigned int row = first_row; row < n_rows; ++row)
    {
      if (row > 0 && body.is_left_out(row))
        {
          ++event.released_rows;
          continue;
        }
      if (row > first_row)
        {
          move_front(row);
          deform(row);
        }
      while (!state.yields && drive->moves_on(state))
        deform(row);
      if (!row_yields(row))
        {
          arrest();
          return false;
        }
      if (row == 0 && !scene.needs_seam())
        split_nodes();
      const unsigned int n_rows =
        state.motion ? state.motion->n_rows_to_split : 1;
      for (unsigned int i = 1; i < n_rows; ++i)
        release_row(row++);
      release_row(row);
      settle(row + 1);
    }
  finish_cut();
  return true;
}



template <int dim>
bool
Simulation<dim>::begin_cut(const unsigned int cut)
{
  const TimerOutput::Scope section(timer, "find cut");
  const Cut<dim> &chosen = scene.cut.cuts[cut];
  if (!body.begin_cut(chosen))
    {
      results.progress.info("Cut " + std::to_string(cut) + " (" + chosen.text +
                            "): nothing is left to cut, earlier cuts have "
                            "opened it or its pieces have been dropped.");
      return false;
    }
  event.cut           = cut;
  event.released_rows = 0;
  // Where the blade begins anew.
  if (event.motion)
    event.motion->travel = 0;
  results.warn_anew();
  results.progress.info(describe_cut(body, cut));
  if (const auto line = describe_edge(scene))
    results.progress.info(*line);
  if (const auto line = describe_resolution(body))
    results.progress.info(*line);
  if (chosen.surface.n_open > 0)
    results.progress.info("  " + std::to_string(chosen.surface.n_open) +
                          " element faces of it lie on the surface of the "
                          "body, which is open there "
                          "already: they are left out.");
  if (chosen.surface.roughness > 1e-6)
    results.progress.warn(describe_roughness(chosen));
  return true;
}



template <int dim>
void
Simulation<dim>::deform(const unsigned int row)
{
  const auto advance = [&] {
    const TimerOutput::Scope section(timer, "solve");
    return drive->advance(body, row, state);
  };
  accept(advance(), advance);

  if (row > 0 && !state.motion)
    results.record("release", event);
  event.row             = row;
  event.depth           = body.seam().rows()[row].depth;
  event.row_pieces      = body.pieces_of_row(row);
  const bool is_at_stop = !state.yields && !scene.blade.path.stops.empty();
  results.record(is_at_stop ? "travel" : "deform", event);
  results.show_row(event, body.seam().rows().size());
  results.write_state(body,
                      state,
                      event,
                      row == 0 || row + 1 == body.seam().rows().size() ||
                        !state.yields);
  checkpoint_if_due(Checkpoint::Stage::row);
}



template <int dim>
bool
Simulation<dim>::row_yields(const unsigned int row)
{
  if (state.yields && drive->is_checked(row))
    results.record("yield", event);
  return state.yields;
}



template <int dim>
void
Simulation<dim>::arrest()
{
  results.record("arrest", event);
  results.progress.info(
    describe_arrest(scene, event, body.seam().rows().size()));
}



template <int dim>
void
Simulation<dim>::split_nodes()
{
  const TimerOutput::Scope section(timer, "surgery");
  state.displacement = body.split_nodes(state.displacement);
  state.opening      = body.model().discretization.zero_vector();
  state.internal     = internal_forces(body.model(), state.displacement);

  // The same blade, by the new unknowns.
  state.blade = body.blade_on_row(0);

  // A fully tied seam is the uncut body: what is solved stays in equilibrium.
  const double unbalanced = unbalanced_part(body, state);
  std::ostringstream line;
  line.precision(2);
  line << "  seam of " << body.seam().n_double_pairs()
       << " node pairs; relative residual with all of them tied: "
       << unbalanced;
  // The foundation under a body on a board leaves a little.
  const double allowed = std::max({body.board() ? 1e-8 : 1e-10,
                                   100 * state.quality.residual,
                                   10 * body.mesh().round_off()});
  if (!(unbalanced <= allowed))
    {
      line << ", which must not exceed " << allowed
           << ": it is not the uncut body.";
      throw InvariantError("The" + line.str().substr(1));
    }
  results.progress.show(line.str());
  results.progress.show(describe_solve(body));
}



template <int dim>
void
Simulation<dim>::release_row(const unsigned int row)
{
  const TimerOutput::Scope section(timer, "release ties");
  const auto known = body.floating_pieces();
  body.release_row(row);
  say_what_is_loose(known);
  ++event.released_rows;
}



template <int dim>
void
Simulation<dim>::settle(const unsigned int row)
{
  const auto settled = [&] {
    const TimerOutput::Scope section(timer, "solve");
    return drive->settle(body, row, state);
  };
  if (auto settled_state = settled())
    {
      accept(std::move(*settled_state), [&] { return *settled(); });
      results.record("release", event);
      results.write_state(body, state, event, false);
    }
}



template <int dim>
void
Simulation<dim>::say_what_is_loose(const std::vector<FloatingPiece> &known)
{
  for (const auto &line : describe_loose_pieces(body, known))
    results.progress.info(line);
}



template <int dim>
void
Simulation<dim>::finish_cut()
{
  const auto known = body.floating_pieces();
  body.finish_cut();
  say_what_is_loose(known);
  const auto finished = [&] {
    const TimerOutput::Scope section(timer, "solve");
    return drive->finish(body, state);
  };
  accept(finished(), finished);
  if (const auto line = describe_path_left_out(scene, state))
    results.progress.info(*line);
  if (!state.motion)
    results.record("release", event);
  results.record("divide", event);
  results.write_state(body, state, event, true);
  results.write_pieces(body, state);
}



template <int dim>
State<dim>
Simulation<dim>::solve(const BladeLoad<dim> &blade, const double load_factor)
{
  const TimerOutput::Scope section(timer, "solve");
  return solve_state(body, blade, load_factor, state.displacement);
}



template class Simulation<2>;
template class Simulation<3>;
} // namespace Setsudan
