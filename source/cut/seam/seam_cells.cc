// SPDX-License-Identifier: LGPL-2.1-or-later
#include <setsudan/cut/seam/seam_cells.h>

#include <map>

namespace Setsudan
{
using namespace dealii;

template <int dim>
SeamCells<dim>::SeamCells(const ElasticModel<dim> &model, const Seam<dim> &seam)
  : evaluator(model.discretization,
              model.materials,
              node_points(model.discretization),
              &model.internal)
  , of_pairs(seam.pairs().size())
{
  const auto &discretization = model.discretization;
  // A node may be in several pairs, where an earlier cut ends at this one.
  std::multimap<types::global_dof_index, unsigned int> pairs_of;
  for (unsigned int p = 0; p < seam.pairs().size(); ++p)
    {
      const NodePair<dim> &pair = seam.pairs()[p];
      pairs_of.emplace(pair.minus[0], p);
      if (pair.plus[0] != pair.minus[0])
        pairs_of.emplace(pair.plus[0], p);
    }
  for (const auto &cell : discretization.dof_handler.active_cell_iterators())
    if (cell->is_locally_owned())
      {
        bool meets       = false;
        const auto nodes = discretization.node_indices(cell);
        for (unsigned int node = 0; node < nodes.size(); ++node)
          {
            const auto found = pairs_of.equal_range(nodes[node][0]);
            for (auto pair = found.first; pair != found.second; ++pair)
              {
                of_pairs[pair->second].emplace_back(cells.size(), node);
                meets = true;
              }
          }
        if (meets)
          cells.push_back(cell);
      }
}



template <int dim>
std::vector<typename SeamCells<dim>::AdjacentCell>
SeamCells<dim>::at_front(const Row &row) const
{
  std::map<unsigned int, AdjacentCell> meetings;
  for (const unsigned int pair : row.front)
    for (const auto &[cell, node] : of_pairs[pair])
      {
        auto &meeting = meetings[cell];
        meeting.cell  = cells[cell];
        meeting.nodes.push_back(node);
        meeting.pairs.push_back(pair);
      }
  std::vector<AdjacentCell> result;
  for (auto &[cell, meeting] : meetings)
    result.push_back(std::move(meeting));
  return result;
}



template class SeamCells<2>;
template class SeamCells<3>;
} // namespace Setsudan
