#include <setsudan/cut/seam.h>

#include <cmath>

namespace Setsudan
{
using namespace dealii;

template <int dim>
Seam<dim>::Seam(const std::vector<NodePair<dim>> &pairs,
                const std::vector<Row> &rows)
  : node_pairs(pairs)
  , node_rows(rows)
  , states(pairs.size(), State::tied)
{
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
typename Seam<dim>::State
Seam<dim>::state(const unsigned int pair) const
{
  return states[pair];
}



template <int dim>
void
Seam<dim>::set_row_state(const unsigned int row, const State state)
{
  for (const unsigned int pair : node_rows[row].pairs)
    states[pair] = state;
}



template <int dim>
void
Seam<dim>::set_all_states(const State state)
{
  states.assign(states.size(), state);
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
unsigned int
Seam<dim>::normal_component(const unsigned int pair) const
{
  const auto &normal     = node_pairs[pair].normal;
  unsigned int component = 0;
  for (unsigned int c = 1; c < dim; ++c)
    if (std::abs(normal[c]) > std::abs(normal[component]))
      component = c;
  return component;
}



template <int dim>
void
Seam<dim>::add_constraints(AffineConstraints<double> &constraints) const
{
  for (unsigned int p = 0; p < node_pairs.size(); ++p)
    {
      const NodePair<dim> &pair = node_pairs[p];
      if (!pair.is_double() || pair.supported.all() || states[p] == State::free)
        continue;
      if (states[p] == State::tied)
        {
          for (unsigned int c = 0; c < dim; ++c)
            if (!pair.supported[c])
              {
                constraints.add_line(pair.plus[c]);
                constraints.add_entry(pair.plus[c], pair.minus[c], 1);
              }
          continue;
        }
      const unsigned int c = normal_component(p);
      if (pair.supported[c])
        continue;
      constraints.add_line(pair.plus[c]);
      constraints.add_entry(pair.plus[c], pair.minus[c], 1);
      for (unsigned int other = 0; other < dim; ++other)
        if (other != c && pair.normal[other] != 0)
          {
            const double slope = pair.normal[other] / pair.normal[c];
            constraints.add_entry(pair.plus[c], pair.plus[other], -slope);
            constraints.add_entry(pair.plus[c], pair.minus[other], slope);
          }
    }
}



template <int dim>
LA::Vector
Seam<dim>::opening(const Discretization<dim> &discretization,
                   const double thickness) const
{
  LA::Vector displacement = discretization.zero_vector();
  for (unsigned int p = 0; p < node_pairs.size(); ++p)
    {
      const NodePair<dim> &pair = node_pairs[p];
      const unsigned int c      = normal_component(p);
      if (states[p] == State::opened && pair.is_double() &&
          !pair.supported[c] && discretization.owned.is_element(pair.plus[c]))
        displacement(pair.plus[c]) = thickness / pair.normal[c];
    }
  displacement.compress(VectorOperation::insert);
  return displacement;
}



template class Seam<2>;
template class Seam<3>;
} // namespace Setsudan
