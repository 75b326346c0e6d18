#pragma once

#include <setsudan/elasticity/elastic_model.h>
#include <setsudan/output/vtu.h>

namespace Setsudan
{
/** What a cell of the body is called in a frame, one value per element. */
struct ElementLabels
{
  /** The side of the newest cut: -1, +1, or 0 where it does not reach. */
  std::vector<int> side;
  /** The separate body it belongs to. */
  std::vector<unsigned int> piece;
};

/**
 * What a frame shows of this process's cells: displacement, stress and maximum
 * shear on cells of 3^dim points, which hold quadratic fields exactly, or on
 * the corners of linear ones; and of each cell its side, piece and material.
 *
 * @param displacement  with ghosts.
 * @param error_squares see ErrorEstimate; empty if errors are not estimated.
 */
template <int dim>
VtuCells
frame_content(ElasticModel<dim> &model,
              const LA::Vector &displacement,
              const ElementLabels &labels,
              const dealii::Vector<double> &error_squares);
} // namespace Setsudan
