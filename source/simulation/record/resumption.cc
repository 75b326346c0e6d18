// SPDX-License-Identifier: LGPL-2.1-or-later
#include <deal.II/base/mpi.h>
#include <deal.II/base/utilities.h>

#include <setsudan/simulation/record/resumption.h>

#include <sstream>

namespace Setsudan
{
using namespace dealii;

namespace
{
/** The scene in words, wherever its results go. */
std::string
scene_text(const Parameters &parameters, const std::string &directory)
{
  return text_in(directory,
                 parameters.with({{"Output", "Directory", directory, ""}}));
}

/** Where two texts differ first, in words; empty where they do not. */
std::string
first_difference(const std::string &there, const std::string &here)
{
  std::istringstream lines_there(there), lines_here(here);
  std::string a, b;
  const auto setting = [](const std::string &line) {
    return "'" + Utilities::trim(line.substr(0, line.find('#'))) + "'";
  };
  while (std::getline(lines_there, a) && std::getline(lines_here, b))
    if (a != b)
      return setting(a) + " there and " + setting(b) + " here";
  return there == here ? "" : "one has more parameters";
}

template <int dim>
void
check_scene(const Scene<dim> &scene,
            const Parameters &parameters,
            const std::string &file_name)
{
  const auto &directory = scene.output.directory;
  const Parameters earlier(
    file_name, read_scene_file(file_name), Scene<dim>::declare);
  const std::string difference = first_difference(
    scene_text(earlier, directory), scene_text(parameters, directory));
  if (!difference.empty())
    throw SceneError("The run in '" + directory +
                     "' is of another scene and cannot be resumed with this "
                     "one: " +
                     difference + ".");
}
} // namespace


template <int dim>
EarlierRun
find_earlier_run(const Scene<dim> &scene,
                 const Parameters &parameters,
                 const MPI_Comm communicator)
{
  parameters.require(scene.output.checkpoint !=
                       OutputParameters::Checkpoint::none,
                     "Output",
                     "Checkpoint",
                     "auto or every row, for a run that is to be resumed");
  const OutputDirectory directory(
    scene.output.directory, communicator, OutputDirectory::Earlier::kept);
  EarlierRun run;
  const std::string file_name = directory.path + "/parameters.prm";
  if (!Utilities::MPI::broadcast(communicator, directory.has("parameters.prm")))
    return run;
  check_scene(scene, parameters, file_name);
  // The file stays until all have read it.
  MPI_Barrier(communicator);
  run.checkpoint = read_checkpoint(directory, communicator);
  run.finished   = !run.checkpoint;
  if (run.checkpoint && run.checkpoint->stage == Checkpoint::Stage::begun)
    run.checkpoint.reset();
  if (!run.checkpoint)
    return run;
  const auto n_there = run.checkpoint->displacement.size();
  const auto n_here  = Utilities::MPI::n_mpi_processes(communicator);
  if (n_there != n_here)
    throw SceneError("The run in '" + directory.path + "' is one on " +
                     std::to_string(n_there) +
                     " process(es) and cannot be resumed on " +
                     std::to_string(n_here) + ".");
  return run;
}



template <int dim>
void
repeat_surgeries(const Checkpoint &checkpoint, CutBody<dim> &body)
{
  const auto &scene = body.scene();
  for (unsigned int cut = 0; cut <= checkpoint.event.cut; ++cut)
    {
      if (!body.begin_cut(scene.cut.cuts[cut]))
        continue;
      const bool divided = cut < checkpoint.event.cut ||
                           checkpoint.stage == Checkpoint::Stage::divided;
      const unsigned int n_split =
        divided ? body.seam().rows().size() : checkpoint.event.row;
      if (n_split == 0 && !scene.needs_seam())
        continue;
      body.split_nodes();
      for (unsigned int row = 0; row < n_split; ++row)
        if (!body.is_left_out(row))
          body.release_row(row);
      if (divided)
        body.finish_cut();
    }
}



template EarlierRun
find_earlier_run(const Scene<2> &, const Parameters &, const MPI_Comm);
template void
repeat_surgeries(const Checkpoint &, CutBody<2> &);
template EarlierRun
find_earlier_run(const Scene<3> &, const Parameters &, const MPI_Comm);
template void
repeat_surgeries(const Checkpoint &, CutBody<3> &);
} // namespace Setsudan
