// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <setsudan/output/frames/vtu.h>
#include <setsudan/output/output_directory.h>

#include <future>
#include <memory>
#include <string>
#include <utility>
#include <vector>

namespace Setsudan
{
/**
 * Writes solved states as frame_NNNN.vtu (or, over several processes, as
 * frame_NNNN.pvtu with one .vtu file each), and the sequence as cut.pvd.
 *
 * Files are compressed and written in the background, one frame after the
 * other, while the next state is solved.
 */
class FrameWriter
{
public:
  /** @param directory must live as long as the writer. */
  explicit FrameWriter(const OutputDirectory &directory);

  /**
   * Write what each process shows of a frame. Called by all processes.
   *
   * @param time of the frame in the sequence; it is larger than that before.
   * @param blade its surface, which is blade_NNNN.vtu; null if there is none.
   * @throw SceneError where this frame, or the one before, cannot be written.
   */
  void
  write(const unsigned int frame,
        const double time,
        const MPI_Comm communicator,
        const std::shared_ptr<const VtuGrid> &content,
        const std::shared_ptr<const VtuGrid> &blade = nullptr);

  /** Wait until all files are whole.
   *
   * @throw SceneError where the last frame could not be written. */
  void
  finish();

  /** The times in ParaView and the names of the files that are shown there. */
  std::vector<std::pair<double, std::string>> sequence;

private:
  const OutputDirectory &directory;
  /** The frame that is being written; its end waits for that. */
  std::future<void> pending;
};
} // namespace Setsudan
