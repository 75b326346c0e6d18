#include <deal.II/base/mpi.h>

#include <setsudan/cut/node_pairs.h>

#include <algorithm>
#include <cstdint>

namespace Setsudan
{
using namespace dealii;

template <int dim>
bool
NodePair<dim>::is_double() const
{
  return minus != plus;
}



namespace
{
/** What one side's cell knows of a node of a cut face, as plain numbers, since
 * it is sent to the other processes: index of the face in the surface, side,
 * node of the cell, supported components, unknowns. */
template <int dim>
using Report = std::array<std::uint64_t, 4 + dim>;

template <int dim>
std::vector<Report<dim>>
report_own_sides(const ElasticModel<dim> &model, const CutSurface<dim> &surface)
{
  std::multimap<unsigned int, std::pair<unsigned int, unsigned int>> sides;
  for (unsigned int f = 0; f < surface.size(); ++f)
    {
      sides.emplace(surface[f].minus.first, std::make_pair(f, 0));
      sides.emplace(surface[f].plus.first, std::make_pair(f, 1));
    }

  std::vector<Report<dim>> reports;
  const auto &discretization = model.discretization;
  for (const auto &cell : discretization.dof_handler.active_cell_iterators())
    if (cell->is_locally_owned())
      {
        const auto range = sides.equal_range(discretization.element(cell));
        if (range.first == range.second)
          continue;
        const auto nodes = discretization.node_indices(cell);
        for (auto it = range.first; it != range.second; ++it)
          {
            const auto [f, side] = it->second;
            const auto &cell_face =
              side == 0 ? surface[f].minus : surface[f].plus;
            for (unsigned int node = 0; node < nodes.size(); ++node)
              if (node_is_on_face<dim>(node, cell_face.second))
                {
                  Report<dim> report{{f, side, node, 0}};
                  for (unsigned int c = 0; c < dim; ++c)
                    {
                      report[4 + c] = nodes[node][c];
                      if (model.supports.is_constrained(nodes[node][c]))
                        report[3] |= 1u << c;
                    }
                  reports.push_back(report);
                }
          }
      }
  return reports;
}
} // namespace


template <int dim>
std::vector<NodePair<dim>>
collect_node_pairs(const ElasticModel<dim> &model,
                   const CutSurface<dim> &surface,
                   const Body<dim> &body)
{
  // A pair is put together within its face, where its number is unique.
  std::map<std::pair<unsigned int, unsigned int>, NodePair<dim>> by_face;
  for (const auto &reports : Utilities::MPI::all_gather(
         model.discretization.communicator, report_own_sides(model, surface)))
    for (const auto &report : reports)
      {
        const auto &face        = surface[report[0]];
        const bool is_minus     = report[1] == 0;
        const unsigned int cell = is_minus ? face.minus.first : face.plus.first;
        const unsigned int node = report[2];
        const unsigned int number = body.numbering.node_number(cell, node);
        NodePair<dim> &pair       = by_face[{report[0], number}];
        pair.number               = number;
        pair.normal               = face.normal;
        pair.is_corner =
          vertices_of_node<dim>(node)[0] == vertices_of_node<dim>(node)[1];
        if (is_minus)
          pair.position = body.mesh.node_position(cell, node);
        for (unsigned int c = 0; c < dim; ++c)
          (is_minus ? pair.minus : pair.plus)[c] = report[4 + c];
        pair.supported |= std::bitset<dim>(report[3]);
      }

  // The faces that meet at a node name the same pair.
  std::map<std::array<types::global_dof_index, 2>, NodePair<dim>> unique;
  for (const auto &[key, pair] : by_face)
    {
      const auto inserted = unique.emplace(
        std::array<types::global_dof_index, 2>{{pair.minus[0], pair.plus[0]}},
        pair);
      if (!inserted.second)
        {
          inserted.first->second.normal += pair.normal;
          inserted.first->second.supported |= pair.supported;
        }
    }
  std::vector<NodePair<dim>> pairs;
  for (auto &[key, pair] : unique)
    {
      pair.normal /= pair.normal.norm();
      pairs.push_back(pair);
    }
  std::sort(pairs.begin(), pairs.end(), [](const auto &a, const auto &b) {
    return std::tie(a.number, a.minus) < std::tie(b.number, b.minus);
  });
  return pairs;
}



template struct NodePair<2>;
template struct NodePair<3>;
template std::vector<NodePair<2>>
collect_node_pairs(const ElasticModel<2> &,
                   const CutSurface<2> &,
                   const Body<2> &);
template std::vector<NodePair<3>>
collect_node_pairs(const ElasticModel<3> &,
                   const CutSurface<3> &,
                   const Body<3> &);
} // namespace Setsudan
