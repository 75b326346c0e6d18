// SPDX-License-Identifier: LGPL-2.1-or-later
#include <setsudan/cut/seam/seam.h>
#include <setsudan/parameters/exceptions.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <set>

namespace Setsudan
{
using namespace dealii;

template <int dim>
Seam<dim>::Seam(const std::vector<NodePair<dim>> &pairs,
                const std::vector<Row> &rows)
  : node_pairs(pairs)
  , node_rows(rows)
  , is_left_out(pairs.size(), false)
{
  choose_dependent_sides();
}



template <int dim>
void
Seam<dim>::choose_dependent_sides()
{
  std::set<types::global_dof_index> taken;
  for (const auto &pair : node_pairs)
    {
      const bool constrained = pair.is_double() && !pair.supported.all();
      if (!constrained)
        dependent_sides.push_back(Dependent::none);
      else if (taken.insert(pair.plus[0]).second)
        dependent_sides.push_back(Dependent::plus);
      else if (taken.insert(pair.minus[0]).second)
        dependent_sides.push_back(Dependent::minus);
      else
        throw CutError(
          "The cut meets itself or an earlier cut in a way that leaves no two "
          "sides at a node. Cut in another order, or along smoother surfaces.");
    }
}



template <int dim>
const typename NodePair<dim>::NodeIndices &
Seam<dim>::dependent(const unsigned int pair) const
{
  return dependent_sides[pair] == Dependent::plus ? node_pairs[pair].plus
                                                  : node_pairs[pair].minus;
}



template <int dim>
const typename NodePair<dim>::NodeIndices &
Seam<dim>::independent(const unsigned int pair) const
{
  return dependent_sides[pair] == Dependent::plus ? node_pairs[pair].minus
                                                  : node_pairs[pair].plus;
}



template <int dim>
const std::vector<NodePair<dim>> &
Seam<dim>::pairs() const
{
  return node_pairs;
}



template <int dim>
const std::vector<Row> &
Seam<dim>::rows() const
{
  return node_rows;
}



template <int dim>
PairStates
Seam<dim>::states_after(const unsigned int n_split, const PairState split) const
{
  PairStates states(node_pairs.size(), PairState::tied);
  for (unsigned int row = 0; row < n_split; ++row)
    for (const unsigned int pair : node_rows[row].pairs)
      states[pair] = split;
  for (unsigned int p = 0; p < states.size(); ++p)
    if (is_left_out[p])
      states[p] = PairState::free;
  return states;
}



template <int dim>
PairStates
Seam<dim>::released(PairStates states, const unsigned int row) const
{
  for (const unsigned int pair : node_rows[row].pairs)
    states[pair] = PairState::free;
  return states;
}



template <int dim>
void
Seam<dim>::leave_out(const std::vector<unsigned int> &pieces,
                     const std::set<unsigned int> &left_out)
{
  for (unsigned int p = 0; p < node_pairs.size(); ++p)
    if (left_out.count(pieces[node_pairs[p].element]) > 0 ||
        left_out.count(pieces[node_pairs[p].plus_element]) > 0)
      is_left_out[p] = true;
  for (auto &row : node_rows)
    {
      Row joined = row;
      joined.front.clear();
      joined.positions.clear();
      joined.lengths.clear();
      for (unsigned int i = 0; i < row.front.size(); ++i)
        if (!is_left_out[row.front[i]])
          {
            joined.front.push_back(row.front[i]);
            joined.positions.push_back(row.positions[i]);
            joined.lengths.push_back(row.lengths[i]);
          }
      row = std::move(joined);
    }
}



template <int dim>
std::vector<PieceLink<dim>>
Seam<dim>::links(const PairStates &states,
                 const std::vector<unsigned int> &pieces) const
{
  std::vector<PieceLink<dim>> links;
  for (unsigned int p = 0; p < node_pairs.size(); ++p)
    {
      const NodePair<dim> &pair = node_pairs[p];
      const std::array<unsigned int, 2> sides{
        {pieces[pair.plus_element], pieces[pair.element]}};
      if (sides[0] == sides[1] || dependent_sides[p] == Dependent::none)
        continue;
      if (states[p] == PairState::tied)
        for (unsigned int c = 0; c < dim; ++c)
          links.push_back(
            {sides, pair.position, Tensor<1, dim>(Point<dim>::unit_vector(c))});
      else if (states[p] == PairState::opened &&
               !pair.supported[pair.normal_component()])
        links.push_back({sides, pair.position, pair.normal});
    }
  return links;
}



template <int dim>
unsigned int
Seam<dim>::n_double_pairs() const
{
  unsigned int n = 0;
  for (const auto &pair : node_pairs)
    n += pair.is_double();
  return n;
}



template <int dim>
IndexSet
Seam<dim>::coupled_indices(const types::global_dof_index n_unknowns) const
{
  IndexSet indices(n_unknowns);
  for (const auto &pair : node_pairs)
    {
      indices.add_indices(pair.minus.begin(), pair.minus.end());
      indices.add_indices(pair.plus.begin(), pair.plus.end());
    }
  indices.compress();
  return indices;
}



template <int dim>
void
Seam<dim>::add_constraints(const PairStates &states,
                           AffineConstraints<double> &constraints) const
{
  for (unsigned int p = 0; p < node_pairs.size(); ++p)
    {
      if (dependent_sides[p] == Dependent::none || states[p] == PairState::free)
        continue;
      const auto &normal    = node_pairs[p].normal;
      const auto &supported = node_pairs[p].supported;
      auto constrained      = dependent(p);
      auto free             = independent(p);
      if (states[p] == PairState::tied)
        {
          for (unsigned int c = 0; c < dim; ++c)
            {
              if (constraints.is_constrained(constrained[c]))
                std::swap(constrained[c], free[c]);
              if (supported[c] || constraints.is_constrained(constrained[c]))
                continue;
              constraints.add_line(constrained[c]);
              constraints.add_entry(constrained[c], free[c], 1);
            }
          continue;
        }
      const unsigned int c = node_pairs[p].normal_component();
      if (constraints.is_constrained(constrained[c]))
        std::swap(constrained, free);
      if (supported[c] || constraints.is_constrained(constrained[c]))
        continue;
      // n.(u+ - u-) = 0, which the two sides enter with opposite signs.
      constraints.add_line(constrained[c]);
      constraints.add_entry(constrained[c], free[c], 1);
      for (unsigned int other = 0; other < dim; ++other)
        if (other != c && normal[other] != 0)
          {
            const double slope = normal[other] / normal[c];
            constraints.add_entry(constrained[c], constrained[other], -slope);
            constraints.add_entry(constrained[c], free[other], slope);
          }
    }
}



template <int dim>
LA::Vector
Seam<dim>::opening(const PairStates &states,
                   const ElasticModel<dim> &model,
                   const double thickness) const
{
  // Pair by pair, since a node of an earlier pair may have moved already.
  std::map<types::global_dof_index, double> moved;
  for (unsigned int p = 0; p < node_pairs.size(); ++p)
    {
      const NodePair<dim> &pair = node_pairs[p];
      const unsigned int c      = node_pairs[p].normal_component();
      if (states[p] != PairState::opened ||
          dependent_sides[p] == Dependent::none || pair.supported[c])
        continue;
      double missing = thickness;
      for (unsigned int d = 0; d < dim; ++d)
        missing -=
          pair.normal[d] * (moved[pair.plus[d]] - moved[pair.minus[d]]);
      moved[dependent(p)[c]] +=
        (dependent_sides[p] == Dependent::plus ? 1 : -1) * missing /
        pair.normal[c];
    }
  LA::Vector displacement = model.discretization.zero_vector();
  for (const auto &[index, value] : moved)
    if (value != 0 && model.discretization.owned.is_element(index))
      displacement(index) = value;
  displacement.compress(VectorOperation::insert);
  distribute(model.hanging, displacement);
  return displacement;
}



template class Seam<2>;
template class Seam<3>;
} // namespace Setsudan
