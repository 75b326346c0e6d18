// SPDX-License-Identifier: LGPL-2.1-or-later
#include <setsudan/mesh/geometry.h>
#include <setsudan/output/pieces/piece_table.h>

#include <algorithm>
#include <iomanip>
#include <ostream>

namespace Setsudan
{
using namespace dealii;

template <int dim>
std::vector<PieceSummary<dim>>
summarize_pieces(const Body<dim> &body, const std::vector<unsigned int> &pieces)
{
  std::vector<PieceSummary<dim>> summaries(
    *std::max_element(pieces.begin(), pieces.end()) + 1);
  for (unsigned int element = 0; element < pieces.size(); ++element)
    {
      const auto nodes = body.mesh.node_positions(element);
      auto &summary    = summaries[pieces[element]];
      ++summary.n_elements;
      summary.volume += volume_of_element<dim>(nodes);
      summary.center += first_moment_of_element<dim>(nodes);
    }
  for (auto &summary : summaries)
    summary.center /= summary.volume;
  return summaries;
}



template <int dim>
void
write_piece_table(const std::vector<PieceSummary<dim>> &pieces,
                  const Tensor<1, dim> &body_force,
                  std::ostream &out)
{
  out << "piece,elements,volume,center_x,center_y,center_z,weight_x,weight_y,"
         "weight_z\n"
      << std::setprecision(12);
  const auto write = [&](const Tensor<1, dim> &vector) {
    for (unsigned int c = 0; c < 3; ++c)
      out << ',' << (c < dim ? vector[c % dim] : 0.);
  };
  for (unsigned int p = 0; p < pieces.size(); ++p)
    {
      out << p << ',' << pieces[p].n_elements << ',' << pieces[p].volume;
      write(pieces[p].center);
      write(pieces[p].volume * body_force);
      out << '\n';
    }
}



template std::vector<PieceSummary<2>>
summarize_pieces(const Body<2> &, const std::vector<unsigned int> &);
template std::vector<PieceSummary<3>>
summarize_pieces(const Body<3> &, const std::vector<unsigned int> &);
template void
write_piece_table(const std::vector<PieceSummary<2>> &,
                  const Tensor<1, 2> &,
                  std::ostream &);
template void
write_piece_table(const std::vector<PieceSummary<3>> &,
                  const Tensor<1, 3> &,
                  std::ostream &);
} // namespace Setsudan
