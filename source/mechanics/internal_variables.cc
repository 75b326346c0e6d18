// SPDX-License-Identifier: LGPL-2.1-or-later
#include <setsudan/mechanics/internal_variables.h>

#include <algorithm>

namespace Setsudan
{
using namespace dealii;

template <int dim>
InternalVariables<dim>::InternalVariables(
  const Discretization<dim> &discretization,
  const MaterialParameters<dim> &materials,
  const unsigned int n_points)
  : discretization(discretization)
  , n_points(n_points)
{
  if (!materials.has_internal_variables())
    return;
  const unsigned int n_cells = discretization.triangulation.n_active_cells();
  begin.resize(n_cells);
  n_of_point.resize(n_cells);
  for (const auto &cell : discretization.dof_handler.active_cell_iterators())
    if (cell->is_locally_owned())
      {
        const auto &law =
          *materials.of_element(discretization.element(cell)).law;
        const unsigned int c = cell->active_cell_index();
        begin[c]             = accepted.size();
        n_of_point[c]        = law.n_internal();
        accepted.resize(accepted.size() + n_points * n_of_point[c]);
        for (unsigned int q = 0; q < n_points; ++q)
          law.initialize({accepted.data() + first(c, q), n_of_point[c]});
      }
  trial = accepted;
}



template <int dim>
unsigned int
InternalVariables<dim>::first(const unsigned int cell,
                              const unsigned int point) const
{
  return begin[cell] + point * n_of_point[cell];
}



template <int dim>
bool
InternalVariables<dim>::empty() const
{
  return begin.empty();
}



template <int dim>
History
InternalVariables<dim>::history(const unsigned int cell,
                                const unsigned int point)
{
  if (empty())
    return {{nullptr, 0}, {nullptr, 0}, step};
  const unsigned int from = first(cell, point), n = n_of_point[cell];
  return {{accepted.data() + from, n}, {trial.data() + from, n}, step};
}



template <int dim>
ArrayView<const double>
InternalVariables<dim>::present(const unsigned int cell,
                                const unsigned int point) const
{
  return {trial.data() + first(cell, point), n_of_point[cell]};
}



template <int dim>
void
InternalVariables<dim>::accept()
{
  accepted = trial;
  step     = 0;
}



template <int dim>
CellData
InternalVariables<dim>::by_cell() const
{
  CellData data;
  if (empty())
    return data;
  for (const auto &cell : discretization.dof_handler.active_cell_iterators())
    if (cell->is_locally_owned())
      {
        const unsigned int c = cell->active_cell_index();
        const auto from      = accepted.begin() + begin[c];
        data[path_of_cell<dim>(cell)].assign(from,
                                             from + n_points * n_of_point[c]);
      }
  return data;
}



template <int dim>
void
InternalVariables<dim>::set(const CellData &data)
{
  if (empty())
    return;
  const auto own = exchange_cell_data(data, discretization);
  for (const auto &cell : discretization.dof_handler.active_cell_iterators())
    if (cell->is_locally_owned())
      {
        const auto &values = own.at(path_of_cell<dim>(cell));
        std::copy(values.begin(),
                  values.end(),
                  accepted.begin() + begin[cell->active_cell_index()]);
      }
  trial = accepted;
}



template class InternalVariables<2>;
template class InternalVariables<3>;
} // namespace Setsudan
