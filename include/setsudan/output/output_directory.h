// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <setsudan/parameters/parameters.h>

#include <functional>
#include <iosfwd>
#include <string>
#include <vector>
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

  /** What counts as time in the sequence of frames. */
  enum class Time
  {
    frame,
    depth,
    travel
  };

  Time time;

  /** How statistics.csv says the units of its columns. */
  enum class Units
  {
    none,
    comment,
    row
  };

  Units units;
  bool node_tables;
  bool calculix_decks;
  /** How often the run makes a checkpoint, from which it can be resumed. */
  enum class Checkpoint
  {
    automatic,
    every_row,
    none
  };
  Checkpoint checkpoint;
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
  /** What becomes of the files of an earlier run. */
  enum class Earlier
  {
    removed,
    /** All but those under temporary names, whose writer was killed. */
    kept
  };

  /**
   * Make the directory, and remove what an earlier run left in it. Called by
   * all processes; the first one acts.
   *
   * Only a directory whose parameters.prm says that this program wrote it holds
   * an earlier run. Files of the same names in others are somebody's, and those
   * that the present run reads stay in any case.
   *
   * @param inputs the files that the run reads.
   * @throw SceneError on all processes where that is not possible, before
   * anything is removed.
   */
  OutputDirectory(const std::string &path,
                  const MPI_Comm communicator,
                  const Earlier earlier                  = Earlier::removed,
                  const std::vector<std::string> &inputs = {});

  /** Whether a file is there; asked by the first process. */
  bool
  has(const std::string &name) const;

  void
  remove(const std::string &name) const;

  /**
   * Write a file as a whole. Called by the process that has it.
   *
   * @throw OutputError where that is not possible, with the reason.
   */
  void
  write(const std::string &name,
        const std::function<void(std::ostream &)> &write_to) const;

  /** The same, and wait until the disk has it. */
  void
  write_durably(const std::string &name,
                const std::function<void(std::ostream &)> &write_to) const;

  /** The same for writers that want a name; it ends like `name`. */
  void
  write_file(
    const std::string &name,
    const std::function<void(const std::string &file_name)> &write_to) const;

  /** Begins the parameters.prm of a run, as a comment. */
  static const std::string signature;

  const std::string path;
};
} // namespace Setsudan
