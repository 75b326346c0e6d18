#include <deal.II/base/mpi.h>

#include <setsudan/simulation/simulation.h>

#include <CLI/CLI.hpp>

#include <cstdlib>
#include <iostream>
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
  bool validate         = false;
  bool print_parameters = false;
};

/** Read the scene, and do what the command line asks for with it. */
template <int dim>
void
run(const CommandLine &command_line,
    const std::vector<SceneEntry> &entries,
    const MPI_Comm communicator)
{
  const bool speaks =
    dealii::Utilities::MPI::this_mpi_process(communicator) == 0;
  const Parameters parameters(command_line.scene.empty() ? "default scene"
                                                         : command_line.scene,
                              entries,
                              Scene<dim>::declare);
  if (command_line.print_parameters && speaks)
    parameters.print(std::cout);
  if (command_line.scene.empty())
    return;
  const Scene<dim> scene(parameters);
  if (command_line.validate && speaks)
    std::cout << command_line.scene << " is a valid scene." << std::endl;
  if (!command_line.validate && !command_line.print_parameters)
    Simulation<dim>(scene, parameters, communicator).run();
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
} // namespace


int
main(int argc, char **argv)
{
  // A program that was not started by mpirun need not wait for Open MPI's
  // daemon, which takes longer than a small scene.
  setenv("OMPI_MCA_ess_singleton_isolated", "1", 0);
  dealii::Utilities::MPI::MPI_InitFinalize mpi(argc, argv, 1);
  const MPI_Comm communicator = MPI_COMM_WORLD;
  const bool speaks =
    dealii::Utilities::MPI::this_mpi_process(communicator) == 0;

  CommandLine command_line;
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
  app.add_flag("--validate", command_line.validate, "Check the scene and stop");
  app.add_flag("--print-parameters",
               command_line.print_parameters,
               "Print all parameters and stop");
  try
    {
      app.parse(argc, argv);
      if (command_line.scene.empty() && !command_line.print_parameters)
        throw CLI::RequiredError("SCENE");
    }
  catch (const CLI::ParseError &error)
    {
      // --help and --version come this way too, as errors of code 0.
      if (speaks)
        app.exit(error);
      return error.get_exit_code() == 0 ? success : wrong_command_line;
    }

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
      // All processes read the same scene, and stop at the same error.
      if (speaks)
        std::cerr << "setsudan: " << error.what() << std::endl;
      return failure;
    }
  catch (const std::exception &error)
    {
      // What fails on all processes is said by the first.
      if (!speaks)
        sleep(1);
      std::cerr << "setsudan: " << error.what() << std::endl;
      // Others may be waiting for a process that has failed alone.
      if (dealii::Utilities::MPI::n_mpi_processes(communicator) > 1)
        MPI_Abort(communicator, failure);
      return failure;
    }
  return success;
}
