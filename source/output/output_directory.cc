// SPDX-License-Identifier: LGPL-2.1-or-later
#include <deal.II/base/mpi.h>

#include <setsudan/output/output_directory.h>
#include <setsudan/parameters/exceptions.h>

#include <algorithm>
#include <cerrno>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <regex>
#include <vector>

#include <fcntl.h>
#include <unistd.h>

namespace Setsudan
{
using namespace dealii;
namespace fs = std::filesystem;

namespace
{
/** What says where and when frames are written. */
void
declare_frames(ParameterHandler &handler)
{
  Setsudan::declare(handler,
                    "Output",
                    "Directory",
                    "results/cut",
                    Patterns::Anything(),
                    "Where the results go, relative to where the program is "
                    "started. Those of an earlier run there are replaced, "
                    "if its parameters.prm says that this program wrote it.");
  Setsudan::declare(handler,
                    "Output",
                    "Frames",
                    "every row",
                    Patterns::Selection("every row|stages|none"),
                    "Which solved states are written for ParaView: every row; "
                    "stages (the body at rest, the first deformation of each "
                    "cut, its last row or its arrest, and the pieces); or "
                    "none.");
  Setsudan::declare(handler,
                    "Output",
                    "Time",
                    "frame",
                    Patterns::Selection("frame|depth|travel"),
                    "What ParaView takes for time: the number of the frame; "
                    "depth: how far the row under the blade lies behind the "
                    "entry, for scenes of one cut; travel: the depths of all "
                    "cuts added up. Where the blade stands still, times grow "
                    "by a millionth of the body's size, since no two frames "
                    "can have the same.");
}
} // namespace


void
OutputParameters::declare(ParameterHandler &handler)
{
  declare_frames(handler);
  Setsudan::declare(handler,
                    "Output",
                    "Node tables",
                    "false",
                    Patterns::Bool(),
                    "Write every solved state as a table of its nodes too.");
  Setsudan::declare(handler,
                    "Output",
                    "CalculiX decks",
                    "false",
                    Patterns::Bool(),
                    "Write every solved state as an input deck of CalculiX "
                    "too, which solves it again, and its displacements as a "
                    "table with the deck's numbers of nodes.");
  Setsudan::declare(handler,
                    "Output",
                    "Units",
                    "none",
                    Patterns::Selection("none|comment|row"),
                    "Whether statistics.csv says the units of its columns: not "
                    "at all (doc/results.md has them), in a line that begins "
                    "with '# units:' before the names, or in a row behind the "
                    "names.");
  Setsudan::declare(handler,
                    "Output",
                    "Checkpoint",
                    "auto",
                    Patterns::Selection("auto|every row|none"),
                    "When the file 'checkpoint' is written, from which "
                    "--resume goes on; it is removed when the run ends. auto: "
                    "so often that it takes no more than about 2 % of the "
                    "time, and when the run is interrupted; none: a run that "
                    "is stopped must be started anew.");
  Setsudan::declare(handler,
                    "Output",
                    "Piece shape",
                    "rest",
                    Patterns::Selection("rest|deformed"),
                    "The shape in which the pieces are written as bodies: as "
                    "they were before the cut, or as its last state has left "
                    "them.");
}



OutputParameters::OutputParameters(const Parameters &parameters)
  : directory(parameters.text("Output", "Directory"))
  , node_tables(parameters.truth("Output", "Node tables"))
  , calculix_decks(parameters.truth("Output", "CalculiX decks"))
  , pieces_deformed(parameters.text("Output", "Piece shape") == "deformed")
{
  const std::string name = parameters.text("Output", "Frames");
  frames                 = name == "every row" ? Frames::every_row
                           : name == "stages"  ? Frames::stages
                                               : Frames::none;
  const std::string said = parameters.text("Output", "Units");
  units                  = said == "none"      ? Units::none
                           : said == "comment" ? Units::comment
                                               : Units::row;
  const std::string what = parameters.text("Output", "Time");
  time                   = what == "frame"   ? Time::frame
                           : what == "depth" ? Time::depth
                                             : Time::travel;
  const std::string when = parameters.text("Output", "Checkpoint");
  checkpoint             = when == "auto"        ? Checkpoint::automatic
                           : when == "every row" ? Checkpoint::every_row
                                                 : Checkpoint::none;
  parameters.require(
    !directory.empty(), "Output", "Directory", "the name of a directory");
}



namespace
{
const std::string temporary_prefix = ".writing-";

const std::string parameters_name = "parameters.prm";

/** As long as there is no parameters.prm, this file tells that the directory is
 * a run's. */
const std::string mark = temporary_prefix + "mark";

/** The files in a directory whose names match, sorted. */
std::vector<fs::path>
find_files(const fs::path &path, const std::regex &pattern)
{
  std::vector<fs::path> matching;
  for (const auto &entry : fs::directory_iterator(path))
    if (entry.is_regular_file() &&
        std::regex_match(entry.path().filename().string(), pattern))
      matching.push_back(entry.path());
  std::sort(matching.begin(), matching.end());
  return matching;
}

/** The files of a run. */
std::vector<fs::path>
find_results(const fs::path &path)
{
  return find_files(
    path,
    std::regex(
      R"(parameters\.prm|checkpoint|cut\.pvd|statistics\.csv|summary\.json|)"
      R"(nodes_\d+\.csv|stage_\d+\.(inp|csv)|frame_\d+(\.\d+)?\.p?vtu|blade_\d+\.vtu|)"
      R"(piece_\d+\.(msh|vtu)|)"
      R"(pieces\.csv|validation\.vtu)"));
}

bool
is_signed(const fs::path &file)
{
  std::ifstream stream(file);
  std::string line;
  return std::getline(stream, line) &&
         line.compare(0,
                      OutputDirectory::signature.size(),
                      OutputDirectory::signature) == 0;
}

/** Why files must not be removed; nothing where they may be. */
std::string
why_kept(const fs::path &path,
         const std::vector<fs::path> &results,
         const std::vector<std::string> &inputs)
{
  for (const auto &result : results)
    for (const auto &input : inputs)
      if (std::error_code error; fs::equivalent(result, input, error))
        return "the run reads '" + input +
               "' in it, which its own results would replace";
  if (!results.empty() && !is_signed(path / parameters_name) &&
      !is_signed(path / mark))
    return "it holds '" + results.front().filename().string() + "'" +
           (results.size() > 1
              ? " and " + std::to_string(results.size() - 1) + " more files"
              : "") +
           " of names that a run writes, but no parameters.prm which says that "
           "they are an earlier run's, to be replaced";
  return "";
}

/** Remove the files of an earlier run, such that a removal that is interrupted
 * leaves no directory that looks complete, or like somebody else's. */
void
remove_results(const fs::path &path, const std::vector<fs::path> &results)
{
  std::ofstream(path / mark) << OutputDirectory::signature << '\n';
  fs::remove(path / parameters_name);
  for (const auto &file : results)
    fs::remove(file);
}

/** Make `path` a directory one can write to, without the files of an earlier
 * run; the answer is what stands in the way. */
std::string
prepare_directory(const fs::path &path,
                  const OutputDirectory::Earlier earlier,
                  const std::vector<std::string> &inputs)
{
  try
    {
      fs::create_directories(path);
      const fs::path probe = path / (temporary_prefix + "probe");
      errno                = 0;
      if (!(std::ofstream(probe) << "probe" << std::flush))
        return std::string("it cannot be written: ") + std::strerror(errno);
      fs::remove(probe);
      const auto results = find_results(path);
      const bool removes = earlier == OutputDirectory::Earlier::removed;
      const auto problem = removes ? why_kept(path, results, inputs) : "";
      if (!problem.empty())
        return problem;
      if (removes)
        remove_results(path, results);
      for (const auto &file : find_files(path, std::regex(R"(\.writing-.*)")))
        if (file.filename() != mark || fs::exists(path / parameters_name))
          fs::remove(file);
    }
  catch (const fs::filesystem_error &error)
    {
      return "it cannot be written: " + error.code().message();
    }
  return "";
}

void
write_stream(const std::string &file_name,
             const std::function<void(std::ostream &)> &write_to)
{
  try
    {
      // The first failure is caught where it happens, when errno still tells
      // its reason.
      errno = 0;
      std::ofstream stream;
      stream.exceptions(std::ios::failbit | std::ios::badbit);
      stream.open(file_name, std::ios::binary);
      write_to(stream);
      stream.close();
    }
  catch (const std::ios::failure &)
    {
      throw std::runtime_error(std::strerror(errno));
    }
}

/** Wait until the disk has a file, or a directory's names of files. */
void
synchronize(const std::string &name)
{
  const int file     = ::open(name.c_str(), O_RDONLY);
  const bool written = file >= 0 && ::fsync(file) == 0;
  const int error    = errno;
  if (file >= 0)
    ::close(file);
  if (!written)
    throw std::runtime_error(std::strerror(error));
}
} // namespace


const std::string OutputDirectory::signature = "# Written by setsudan";



OutputDirectory::OutputDirectory(const std::string &path,
                                 const MPI_Comm communicator,
                                 const Earlier earlier,
                                 const std::vector<std::string> &inputs)
  : path(path)
{
  std::string problem;
  if (Utilities::MPI::this_mpi_process(communicator) == 0)
    problem = prepare_directory(path, earlier, inputs);
  problem = Utilities::MPI::broadcast(communicator, problem);
  if (!problem.empty())
    throw SceneError("the output directory '" + path +
                     "' cannot be used: " + problem +
                     "; choose another with Output/Directory or --output");
}



bool
OutputDirectory::has(const std::string &name) const
{
  return fs::is_regular_file(fs::path(path) / name);
}



void
OutputDirectory::remove(const std::string &name) const
{
  std::error_code error;
  fs::remove(fs::path(path) / name, error);
  if (error)
    throw OutputError("The file '" + (fs::path(path) / name).string() +
                      "' cannot be removed: " + error.message() + ".");
}



void
OutputDirectory::write(
  const std::string &name,
  const std::function<void(std::ostream &)> &write_to) const
{
  write_file(name, [&](const std::string &file_name) {
    write_stream(file_name, write_to);
  });
}



void
OutputDirectory::write_durably(
  const std::string &name,
  const std::function<void(std::ostream &)> &write_to) const
{
  write_file(name, [&](const std::string &file_name) {
    write_stream(file_name, write_to);
    synchronize(file_name);
  });
  synchronize(path);
}



void
OutputDirectory::write_file(
  const std::string &name,
  const std::function<void(const std::string &)> &write_to) const
{
  const fs::path temporary = fs::path(path) / (temporary_prefix + name);
  try
    {
      write_to(temporary.string());
      fs::rename(temporary, fs::path(path) / name);
      if (name == parameters_name)
        fs::remove(fs::path(path) / mark);
    }
  catch (const std::exception &error)
    {
      std::error_code ignored;
      fs::remove(temporary, ignored);
      throw OutputError("The file '" + (fs::path(path) / name).string() +
                        "' cannot be written: " + error.what() + ".");
    }
}
} // namespace Setsudan
