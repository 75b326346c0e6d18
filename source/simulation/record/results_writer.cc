// SPDX-License-Identifier: LGPL-2.1-or-later
#include <deal.II/base/mpi.h>

#include <setsudan/mesh/geometry.h>
#include <setsudan/output/pieces/calculix_deck.h>
#include <setsudan/output/pieces/piece_mesh.h>
#include <setsudan/output/pieces/piece_table.h>
#include <setsudan/output/tables/node_table.h>
#include <setsudan/parameters/exceptions.h>
#include <setsudan/parameters/lists.h>
#include <setsudan/simulation/record/frame_facts.h>
#include <setsudan/simulation/record/results_writer.h>

#include <algorithm>
#include <cmath>
#include <sstream>

namespace Setsudan
{
using namespace dealii;

namespace
{
OutputDirectory
open_directory(const Parameters &parameters,
               const std::string &path,
               const MPI_Comm communicator,
               const OutputDirectory::Earlier earlier)
{
  try
    {
      auto inputs = parameters.files();
      if (!parameters.text("Body", "File").empty())
        inputs.push_back(parameters.path("Body", "File"));
      return OutputDirectory(path, communicator, earlier, inputs);
    }
  catch (const SceneError &error)
    {
      parameters.reject("Output",
                        "Directory",
                        std::string("a directory for this run's files: ") +
                          error.what());
    }
}
} // namespace



template <int dim>
ResultsWriter<dim>::ResultsWriter(const Scene<dim> &scene,
                                  const Parameters &parameters,
                                  const MPI_Comm communicator,
                                  TimerOutput &timer,
                                  const OutputDirectory::Earlier earlier)
  : progress(communicator)
  , directory(
      open_directory(parameters, scene.output.directory, communicator, earlier))
  , scene(scene)
  , timer(timer)
  , is_first_process(Utilities::MPI::this_mpi_process(communicator) == 0)
  , n_processes(Utilities::MPI::n_mpi_processes(communicator))
  , frames(directory)
  , statistics(scene.output.units, scene.length_unit, scene.force_unit)
{
}



template <int dim>
ResultsWriter<dim>::~ResultsWriter()
{
  try
    {
      if (is_first_process)
        statistics.finish(directory);
    }
  catch (const std::exception &)
    {
      // What stands in the way has been said where it was met first.
    }
}



template <int dim>
void
ResultsWriter<dim>::write_parameters(const Parameters &parameters) const
{
  if (is_first_process)
    directory.write("parameters.prm", [&](std::ostream &out) {
      out << text_in(directory.path, parameters);
    });
}



template <int dim>
void
ResultsWriter<dim>::finish()
{
  const TimerOutput::Scope section(timer, "frames and tables");
  frames.finish();
  if (is_first_process)
    statistics.finish(directory);
}



template <int dim>
void
ResultsWriter<dim>::write_summary() const
{
  if (is_first_process)
    summary.write({doubts.n_states, n_processes, progress.seconds()},
                  directory);
}



template <int dim>
WriterState
ResultsWriter<dim>::save()
{
  // What is resumed from must be there.
  finish();
  return {statistics.table,
          summary,
          frames.sequence,
          doubts,
          warned,
          earlier_depths,
          framed_at,
          cut_began,
          progress.seconds()};
}



template <int dim>
void
ResultsWriter<dim>::restore(const WriterState &record)
{
  statistics.table = record.table;
  summary          = record.summary;
  frames.sequence  = record.sequence;
  doubts           = record.doubts;
  warned           = record.warned;
  earlier_depths   = record.earlier_depths;
  framed_at        = record.framed_at;
  cut_began        = record.cut_began;
  progress.continue_from(record.seconds);
}



template <int dim>
void
ResultsWriter<dim>::record(const std::string &name, Event &event)
{
  const TimerOutput::Scope section(timer, "frames and tables");
  event.name    = name;
  event.seconds = progress.seconds();
  summary.add(event);
  if (is_first_process)
    statistics.add(event, directory);
}



template <int dim>
Vector<double>
ResultsWriter<dim>::error_squares_of(const CutBody<dim> &body,
                                     const State<dim> &state) const
{
  // At rest there is no error.
  if (scene.accuracy.estimate && state.error_squares.size() == 0)
    return Vector<double>(
      body.model().discretization.triangulation.n_active_cells());
  return state.error_squares;
}



template <int dim>
double
ResultsWriter<dim>::next_time(const Event &event)
{
  if (scene.output.time == OutputParameters::Time::frame)
    return event.frame;
  if (event.cut != framed_at.first)
    earlier_depths += framed_at.second;
  const double way =
    event.motion && scene.output.time == OutputParameters::Time::travel
      ? event.motion->travel
      : event.depth;
  framed_at         = {event.cut, way};
  const double time = earlier_depths + way;
  if (frames.sequence.empty())
    return time;
  return std::max(
    time, frames.sequence.back().first + 1e-6 * scene.body.mesh.extent());
}



template <int dim>
void
ResultsWriter<dim>::write_state(const CutBody<dim> &body,
                                const State<dim> &state,
                                const Event &event,
                                const bool is_stage)
{
  const TimerOutput::Scope section(timer, "frames and tables");
  using Frames      = OutputParameters::Frames;
  const bool framed = scene.output.frames == Frames::every_row ||
                      (scene.output.frames == Frames::stages && is_stage);
  // The body at rest is none that has been solved for.
  if (scene.output.calculix_decks && event.frame > 0)
    write_deck(body, state, "stage_" + Utilities::to_string(event.frame, 4));
  if (!framed && !scene.output.node_tables)
    return;
  const LA::Vector displacement =
    body.model().discretization.with_ghosts(state.displacement);
  if (framed)
    {
      const double time = next_time(event);
      frames.write(event.frame,
                   time,
                   body.communicator(),
                   std::make_shared<const VtuGrid>(
                     frame_content(scene.body,
                                   body.model(),
                                   displacement,
                                   body.labels(),
                                   error_squares_of(body, state),
                                   frame_facts(body, state, event, time))),
                   blade_of_state(body, state));
    }
  if (scene.output.node_tables)
    write_node_table(scene.body,
                     body.model(),
                     body.walls(),
                     displacement,
                     directory,
                     "nodes_" + Utilities::to_string(event.frame, 4) + ".csv");
}



template <int dim>
void
ResultsWriter<dim>::write_deck(const CutBody<dim> &body,
                               const State<dim> &state,
                               const std::string &name) const
{
  const auto constraints = body.constraints();
  const auto prescribed  = lift_of(body, state);
  // Pressures that follow the surface, as the forces that they come to.
  LA::Vector forces = all_forces(state);
  forces += follower_forces(body.model(), state.displacement);
  const auto problem = gather_problem<dim>({body.mesh(),
                                            body.model(),
                                            constraints,
                                            prescribed,
                                            forces,
                                            state.displacement},
                                           scene.body);
  if (is_first_process)
    write_calculix_deck(problem, directory, name);
}



template <int dim>
void
ResultsWriter<dim>::write_pieces(const CutBody<dim> &body,
                                 const State<dim> &state)
{
  const TimerOutput::Scope section(timer, "frames and tables");
  const auto displacements = gather_displacements(
    body.model().discretization,
    body.mesh().cells.size(),
    body.model().discretization.with_ghosts(state.displacement));
  if (!is_first_process)
    return;

  double volume_of_body = 0;
  for (unsigned int e = 0; e < scene.body.mesh.cells.size(); ++e)
    volume_of_body += volume_of_element(scene.body.mesh.node_positions(e));
  double volume       = 0;
  unsigned int number = 0;
  for (auto &piece :
       make_piece_meshes(body.mesh(), body.labels().piece, scene.body))
    {
      volume += piece.volume();
      set_displacements(displacements, piece);
      for (const unsigned int element : piece.elements_in_body)
        piece.materials.push_back(scene.material.number(element));
      if (scene.output.pieces_deformed)
        deform(piece);
      const std::string name = "piece_" + std::to_string(number++);
      write_piece_msh(piece, directory, name + ".msh");
      write_piece_vtu(piece, directory, name + ".vtu");
    }
  directory.write("pieces.csv", [&](std::ostream &out) {
    write_piece_table(summarize_pieces(scene.body, body.labels().piece),
                      scene.loads.body_force,
                      out);
  });
  if (!(std::abs(volume - volume_of_body) <= 1e-12 * volume_of_body))
    throw InvariantError("The pieces' volumes sum up to " + short_text(volume) +
                         " and the body's is " + short_text(volume_of_body) +
                         ": material was lost or made by the surgery.");
}



template <int dim>
void
ResultsWriter<dim>::show_row(const Event &event, const unsigned int n_rows)
{
  if (event.row == 0)
    cut_began = progress.seconds();
  std::ostringstream line;
  line.precision(4);
  line << "  row " << event.row + 1 << "/" << n_rows << "  depth "
       << event.depth << " " << scene.length_unit << "  force "
       << event.blade_force << " " << scene.force_unit << "  "
       << (scene.yield.compares_energies() ? "energy " : "stress ")
       << event.cutting_stress << " of " << event.required_stress << " "
       << scene.yield.unit(scene.force_unit, scene.length_unit) << " required";
  if (event.row > 0)
    line << "  " << progress.time_left(cut_began, event.row, n_rows);
  progress.show(line.str());
}



template class ResultsWriter<2>;
template class ResultsWriter<3>;
} // namespace Setsudan
