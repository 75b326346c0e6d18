// SPDX-License-Identifier: LGPL-2.1-or-later
#include <deal.II/base/conditional_ostream.h>
#include <deal.II/base/mpi.h>
#include <deal.II/base/timer.h>

#include <CLI/CLI.hpp>
#include <setsudan/kernel/blas.h>
#include <setsudan/material/presets.h>
#include <setsudan/parameters/text_lines.h>
#include <setsudan/simulation/interruption.h>
#include <setsudan/simulation/record/resumption.h>
#include <setsudan/simulation/simulation.h>
#include <setsudan/simulation/validation.h>

#include <csignal>
#include <cstdlib>
#include <iostream>
#include <new>
#include <optional>
#include <string>
#include <vector>

#include <unistd.h>

using namespace Setsudan;

namespace
{
enum ExitStatus
{
  success            = 0,
  failure            = 1,
  wrong_command_line = 2
};

struct CommandLine
{
  std::string scene;
  std::vector<std::string> assignments;
  std::optional<std::string> output;
  bool resume           = false;
  bool validate         = false;
  bool verbose          = false;
  bool print_parameters = false;
  bool print_materials  = false;
};

/** Say what was understood of a scene, and where an output directory is named
 * write it as a frame. */
template <int dim>
void
say_what_is_valid(const CommandLine &command_line,
                  const Scene<dim> &scene,
                  const MPI_Comm communicator)
{
  const auto validation = validate(scene, communicator);
  if (dealii::Utilities::MPI::this_mpi_process(communicator) != 0)
    return;
  std::cout << command_line.scene << " is a valid scene.\n";
  for (const auto &line : validation.lines)
    std::cout << line << '\n';
  if (command_line.output)
    {
      const OutputDirectory directory(
        scene.output.directory, MPI_COMM_SELF, OutputDirectory::Earlier::kept);
      directory.write("validation.vtu", [&](std::ostream &out) {
        write_vtu(validation_grid(scene, validation), out);
      });
      std::cout << "What it selects is in " << directory.path
                << "/validation.vtu.\n";
    }
  std::cout << std::flush;
}

/** Read the scene, and do what the command line asks for with it. */
template <int dim>
void
run(const CommandLine &command_line,
    const std::vector<SceneEntry> &entries,
    const MPI_Comm communicator)
{
  const bool speaks =
    dealii::Utilities::MPI::this_mpi_process(communicator) == 0;
  const std::string name =
    command_line.scene.empty() ? "default scene" : command_line.scene;
  const Presets presets;
  const Parameters given(name, entries, Scene<dim>::declare);
  auto all_entries = presets.entries(given);
  std::optional<Parameters> with_preset;
  if (!all_entries.empty())
    {
      all_entries.insert(all_entries.end(), entries.begin(), entries.end());
      with_preset.emplace(name, all_entries, Scene<dim>::declare);
    }
  const Parameters &parameters = with_preset ? *with_preset : given;
  if (command_line.print_parameters && speaks)
    parameters.print(std::cout);
  if (command_line.scene.empty())
    return;
  // Without a communicator its sections wait for no other process.
  dealii::ConditionalOStream out(std::cout, speaks);
  dealii::TimerOutput timer(
    out, dealii::TimerOutput::never, dealii::TimerOutput::wall_times);
  timer.enter_subsection("read scene");
  const Scene<dim> scene(parameters);
  timer.leave_subsection();
  if (command_line.validate)
    say_what_is_valid(command_line, scene, communicator);
  if (command_line.validate || command_line.print_parameters)
    return;
  for (const auto &line : presets.describe(given))
    out << line << std::endl;
  note_interruptions();
  EarlierRun earlier;
  if (command_line.resume)
    earlier = find_earlier_run(scene, parameters, communicator);
  if (earlier.finished)
    {
      out << "The run in " << scene.output.directory
          << " has ended: there is nothing to resume." << std::endl;
      return;
    }
  timer.enter_subsection("set up body");
  Simulation<dim> simulation(
    scene, parameters, communicator, timer, earlier.checkpoint);
  timer.leave_subsection();
  simulation.run();
  if (command_line.verbose)
    timer.print_wall_time_statistics(communicator);
}

/** Say what is wrong. */
void
say_error(const std::string &message)
{
  std::cerr << "setsudan: " << without_control_characters(message) << std::endl;
}

std::vector<SceneEntry>
collect_entries(const CommandLine &command_line)
{
  std::vector<SceneEntry> entries;
  if (!command_line.scene.empty())
    entries = read_scene_file(command_line.scene);
  for (const auto &assignment : command_line.assignments)
    entries.push_back(parse_assignment(assignment));
  if (command_line.output)
    entries.push_back(
      {"Output", "Directory", *command_line.output, "--output"});
  return entries;
}

/** What must be known before MPI begins. */
void
prepare_environment()
{
  // A program that was not started by mpirun need not wait for Open MPI's
  // daemon, which takes longer than a small scene.
  if (getenv("OMPI_COMM_WORLD_SIZE") == nullptr)
    {
      setenv("OMPI_MCA_ess_singleton_isolated", "1", 0);
      // Its directories have one name for all such programs, each of which
      // removes them when it ends: one that starts then would fail.
      setenv("OMPI_MCA_orte_create_session_dirs", "0", 0);
    }
  // A file that may not grow is said in words, like a disk that is full.
  std::signal(SIGXFSZ, SIG_IGN);
}

/** The processes of the communicator that share this one's machine. */
unsigned int
n_processes_here(const MPI_Comm communicator)
{
  MPI_Comm here;
  MPI_Comm_split_type(
    communicator, MPI_COMM_TYPE_SHARED, 0, MPI_INFO_NULL, &here);
  const unsigned int n = dealii::Utilities::MPI::n_mpi_processes(here);
  MPI_Comm_free(&here);
  return n;
}

/** Read the command line. @return the exit status, where that is all. */
std::optional<int>
read(int argc, char **argv, const bool speaks, CommandLine &command_line)
{
  CLI::App app("Setsudan cuts soft bodies with finite elements.", "setsudan");
  app.set_version_flag("--version", "setsudan " SETSUDAN_VERSION);
  app.add_option("SCENE", command_line.scene, "The scene file (.prm)");
  app
    .add_option("--set",
                command_line.assignments,
                "Set a parameter: 'Subsection/Name=value'; may be repeated")
    ->allow_extra_args(false);
  app.add_option("--output",
                 command_line.output,
                 "Output directory, instead of the scene's");
  app.add_flag("--resume",
               command_line.resume,
               "Go on with a run of this scene that was stopped");
  app.add_flag("--validate",
               command_line.validate,
               "Check the scene, say what it selects, and stop; with --output "
               "write it as a frame for ParaView");
  app.add_flag(
    "--verbose",
    command_line.verbose,
    "Say which kernels and threads the program computes with, and at "
    "the end where the time went");
  app.add_flag("--print-parameters",
               command_line.print_parameters,
               "Print all parameters and stop");
  app.add_flag("--print-materials",
               command_line.print_materials,
               "Print the materials of Material/Preset with their sources and "
               "stop");
  try
    {
      app.parse(argc, argv);
      if (command_line.scene.empty() && !command_line.print_parameters &&
          !command_line.print_materials)
        throw CLI::RequiredError("SCENE");
    }
  catch (const CLI::ParseError &error)
    {
      // --help and --version come this way too, as errors of code 0.
      if (speaks)
        app.exit(error);
      return error.get_exit_code() == 0 ? success : wrong_command_line;
    }
  if (command_line.print_materials)
    {
      if (speaks)
        Presets().print(std::cout);
      return success;
    }
  return {};
}
} // namespace


int
main(int argc, char **argv)
{
  start_with_fitting_blas(argv);
  prepare_environment();
  dealii::Utilities::MPI::MPI_InitFinalize mpi(argc, argv, 1);
  const MPI_Comm communicator = MPI_COMM_WORLD;
  const bool speaks =
    dealii::Utilities::MPI::this_mpi_process(communicator) == 0;
  share_cores(n_processes_here(communicator));

  CommandLine command_line;
  if (const auto status = read(argc, argv, speaks, command_line))
    return *status;
  if (command_line.verbose && speaks)
    std::cout << describe_blas() << std::endl;

  // Where all processes stop at the same error or state.
  const auto fail_together = [&](const std::exception &error) {
    if (speaks)
      say_error(error.what());
    return failure;
  };
  try
    {
      const auto entries = collect_entries(command_line);
      if (scene_dimension(entries) == 2)
        run<2>(command_line, entries, communicator);
      else
        run<3>(command_line, entries, communicator);
    }
  catch (const SceneError &error)
    {
      return fail_together(error);
    }
  catch (const RunInterrupted &error)
    {
      return fail_together(error);
    }
  catch (const std::exception &error)
    {
      // What fails on all processes is said by the first.
      if (!speaks)
        sleep(1);
      say_error(dynamic_cast<const std::bad_alloc *>(&error) != nullptr
                  ? "The memory does not suffice for this body. Take fewer "
                    "elements or less refinement, or more processes on more "
                    "machines."
                  : error.what());
      // Others may be waiting for a process that has failed alone.
      if (dealii::Utilities::MPI::n_mpi_processes(communicator) > 1)
        MPI_Abort(communicator, failure);
      return failure;
    }
  return success;
}
