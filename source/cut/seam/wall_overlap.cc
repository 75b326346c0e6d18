// SPDX-License-Identifier: LGPL-2.1-or-later
#include <deal.II/base/mpi.h>

#include <setsudan/cut/seam/wall_overlap.h>

namespace Setsudan
{
using namespace dealii;

namespace
{
/** n.(u+ - u-) of every pair; of a pair whose sides are on two
 * processes each gives its part. */
template <int dim>
std::vector<double>
gaps_of(const std::vector<NodePair<dim>> &pairs,
        const LA::Vector &displacement,
        const MPI_Comm communicator)
{
  std::vector<double> gaps;
  for (const auto &pair : pairs)
    {
      double gap = 0;
      for (unsigned int c = 0; c < dim; ++c)
        {
          if (displacement.in_local_range(pair.plus[c]))
            gap += pair.normal[c] * displacement(pair.plus[c]);
          if (displacement.in_local_range(pair.minus[c]))
            gap -= pair.normal[c] * displacement(pair.minus[c]);
        }
      gaps.push_back(gap);
    }
  std::vector<double> sums(gaps.size());
  Utilities::MPI::sum(gaps, communicator, sums);
  return sums;
}
} // namespace



template <int dim>
WallOverlap<dim>
find_wall_overlap(const std::vector<CutWall<dim>> &walls,
                  const LA::Vector &displacement,
                  const MPI_Comm communicator)
{
  WallOverlap<dim> overlap;
  for (unsigned int w = 0; w < walls.size(); ++w)
    {
      const auto &pairs = walls[w].pairs;
      const auto gaps   = gaps_of(pairs, displacement, communicator);
      for (unsigned int p = 0; p < pairs.size(); ++p)
        if (pairs[p].is_double() && walls[w].states[p] == PairState::free &&
            -gaps[p] > overlap.depth)
          overlap = {-gaps[p], pairs[p].position, w};
    }
  return overlap;
}



template struct WallOverlap<2>;
template struct WallOverlap<3>;
template WallOverlap<2>
find_wall_overlap(const std::vector<CutWall<2>> &,
                  const LA::Vector &,
                  const MPI_Comm);
template WallOverlap<3>
find_wall_overlap(const std::vector<CutWall<3>> &,
                  const LA::Vector &,
                  const MPI_Comm);
} // namespace Setsudan
