// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <setsudan/body/body.h>

#include <iosfwd>
#include <vector>

namespace Setsudan
{
/** What a piece is as a whole, in the body at rest. */
template <int dim>
struct PieceSummary
{
  unsigned int n_elements = 0;
  double volume           = 0;
  dealii::Point<dim> center;
};

/** @param pieces the piece of every element (see find_pieces()). */
template <int dim>
std::vector<PieceSummary<dim>>
summarize_pieces(const Body<dim> &body,
                 const std::vector<unsigned int> &pieces);

/** Write pieces.csv: a line for each piece.
 *
 * @param body_force per volume; its sum over a piece is the piece's weight. */
template <int dim>
void
write_piece_table(const std::vector<PieceSummary<dim>> &pieces,
                  const dealii::Tensor<1, dim> &body_force,
                  std::ostream &out);
} // namespace Setsudan
