#pragma once

#include <setsudan/parameters/parameters.h>

#include <functional>
#include <iosfwd>
#include <string>

namespace Setsudan
{
/** Subsection `Output`. */
struct OutputParameters
{
  enum class Frames
  {
    every_row,
    stages,
    none
  };

  std::string directory;
  Frames frames;
  bool node_tables;
  bool calculix_decks;
  /** Whether the pieces have the shape of the last state, or that at rest. */
  bool pieces_deformed;

  static void
  declare(dealii::ParameterHandler &handler);

  explicit OutputParameters(const Parameters &parameters);
};

/**
 * Where the results of a run go. Every file is written under a temporary name
 * and renamed when it is whole, so that nobody ever reads half a file.
 */
class OutputDirectory
{
public:
  /**
   * Make the directory, and remove what an earlier run left in it. Called by
   * all processes; the first one acts.
   *
   * @throw SceneError on all processes where that is not possible.
   */
  OutputDirectory(const std::string &path, const MPI_Comm communicator);

  /**
   * Write a file as a whole. Called by the process that has it.
   *
   * @throw std::runtime_error where that is not possible, with the reason.
   */
  void
  write(const std::string &name,
        const std::function<void(std::ostream &)> &write_to) const;

  /** The same for writers that want a name; it ends like `name`. */
  void
  write_file(
    const std::string &name,
    const std::function<void(const std::string &file_name)> &write_to) const;

  const std::string path;
};
} // namespace Setsudan
