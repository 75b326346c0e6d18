#pragma once

#include <deal.II/lac/vector.h>

#include <setsudan/output/frame_content.h>
#include <setsudan/output/output_directory.h>

#include <future>
#include <string>
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
template <int dim>
class FrameWriter
{
public:
  /** @param directory must live as long as the writer. */
  explicit FrameWriter(const OutputDirectory &directory);

  /**
   * Write a frame: displacement, stress, maximum shear, side and piece, on
   * quadratic cells. Called by all processes. Nothing that is handed over must
   * live longer than the call.
   *
   * @param displacement with ghosts.
   * @param error_squares see ErrorEstimate; empty if errors are not estimated.
   * @throw SceneError where this frame, or the one before, cannot be written.
   */
  void
  write(const unsigned int frame,
        ElasticModel<dim> &model,
        const LA::Vector &displacement,
        const ElementLabels &labels,
        const dealii::Vector<double> &error_squares = {});

  /** Wait until all files are whole.
   *
   * @throw SceneError where the last frame could not be written. */
  void
  finish();

  /** Frame numbers, which are the times in ParaView, and file names. */
  std::vector<std::pair<double, std::string>> sequence;

private:
  const OutputDirectory &directory;
  /** The frame that is being written; its end waits for that. */
  std::future<void> pending;
};
} // namespace Setsudan
