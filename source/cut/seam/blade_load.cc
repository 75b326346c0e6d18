// SPDX-License-Identifier: LGPL-2.1-or-later
#include <setsudan/blade/blade_edge.h>
#include <setsudan/cut/seam/blade_load.h>

#include <algorithm>
#include <cmath>
#include <iterator>
#include <numeric>

namespace Setsudan
{
using namespace dealii;

template <int dim>
BladeLoad<dim>
no_blade(const ElasticModel<dim> &model)
{
  return {model.discretization.zero_vector(), {}, {}};
}



namespace
{
/** The point of a row's front at a position along the edge: on the lines
 * between its nodes, or at its end. Nodes at one position count as one in
 * their middle. */
template <int dim>
Point<dim>
point_on_front(const std::vector<NodePair<dim>> &pairs,
               const Row &row,
               const double position)
{
  const auto &at         = row.positions;
  const double tolerance = 1e-10 * (at.back() - at.front());
  const auto middle      = [&](const double where) {
    Tensor<1, dim> sum;
    unsigned int n = 0;
    for (unsigned int i = 0; i < at.size(); ++i)
      if (std::abs(at[i] - where) <= tolerance)
        {
          sum += pairs[row.front[i]].position;
          ++n;
        }
    return Point<dim>(sum / n);
  };
  const double inside = std::clamp(position, at.front(), at.back());
  const double behind = *std::lower_bound(at.begin(), at.end(), inside);
  const double ahead =
    *std::prev(std::upper_bound(at.begin(), at.end(), inside));
  if (behind - ahead <= tolerance)
    return middle(ahead);
  const Tensor<1, dim> way = middle(behind) - middle(ahead);
  return middle(ahead) + (inside - ahead) / (behind - ahead) * way;
}



/** What each node of a front takes of a force that is spread evenly over it. A
 * front without a length, in 2D, hands it to all of its nodes alike. */
std::vector<NodeShare>
share_uniform_load(const double force, const Row &row)
{
  const double whole =
    std::accumulate(row.lengths.begin(), row.lengths.end(), 0.);
  std::vector<NodeShare> shares;
  for (unsigned int i = 0; i < row.lengths.size(); ++i)
    shares.push_back(
      {i,
       force * (whole > 0 ? row.lengths[i] / whole : 1. / row.lengths.size())});
  return shares;
}
} // namespace


template <int dim>
BladeLoad<dim>
blade_on_row(const ElasticModel<dim> &model,
             const Seam<dim> &seam,
             const unsigned int row,
             const Tensor<1, dim> &direction,
             const EdgeLoads &edge_loads)
{
  const auto &pairs    = seam.pairs();
  const Row &front     = seam.rows()[row];
  BladeLoad<dim> blade = no_blade(model);
  blade.row            = row;
  auto shares          = share_edge_loads(edge_loads.points, front.positions);
  for (const auto &load : edge_loads.points)
    blade.forces.push_back(
      {point_on_front(pairs, front, load.position), load.force * direction});
  if (edge_loads.uniform != 0)
    for (const auto &share : share_uniform_load(edge_loads.uniform, front))
      {
        shares.push_back(share);
        blade.forces.push_back(
          {pairs[front.front[share.node]].position, share.force * direction});
      }
  for (const auto &share : shares)
    for (unsigned int c = 0; c < dim; ++c)
      {
        // Half on each side, which is one node as long as the front is tied.
        const auto &pair = pairs[front.front[share.node]];
        for (const auto index : {pair.minus[c], pair.plus[c]})
          if (blade.nodal_forces.in_local_range(index))
            blade.nodal_forces(index) += share.force / 2 * direction[c];
      }
  blade.nodal_forces.compress(VectorOperation::add);
  return blade;
}



template BladeLoad<2>
no_blade(const ElasticModel<2> &);
template BladeLoad<2>
blade_on_row(const ElasticModel<2> &,
             const Seam<2> &,
             const unsigned int,
             const Tensor<1, 2> &,
             const EdgeLoads &);
template BladeLoad<3>
no_blade(const ElasticModel<3> &);
template BladeLoad<3>
blade_on_row(const ElasticModel<3> &,
             const Seam<3> &,
             const unsigned int,
             const Tensor<1, 3> &,
             const EdgeLoads &);
} // namespace Setsudan
