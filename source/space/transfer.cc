// SPDX-License-Identifier: LGPL-2.1-or-later
#include <deal.II/base/mpi.h>

#include <setsudan/space/transfer.h>

#include <algorithm>
#include <map>

namespace Setsudan
{
using namespace dealii;

template <int dim>
CellData
exchange_cell_data(const CellData &data, const Discretization<dim> &to)
{
  const MPI_Comm communicator = to.communicator;
  // The processes know nothing of each other's cells but their names, and meet
  // at a process that follows from the name.
  const auto rendezvous = [&](const CellPath &path) {
    return path.element % Utilities::MPI::n_mpi_processes(communicator);
  };
  using List = std::vector<std::pair<CellPath, std::vector<double>>>;
  std::map<unsigned int, List> given;
  for (const auto &item : data)
    given[rendezvous(item.first)].emplace_back(item);
  std::map<unsigned int, std::vector<CellPath>> wanted;
  for (const auto &cell : to.dof_handler.active_cell_iterators())
    if (cell->is_locally_owned())
      {
        const CellPath path = path_of_cell<dim>(cell);
        wanted[rendezvous(path)].push_back(path);
      }

  CellData left_here, result;
  for (const auto &[rank, cells] :
       Utilities::MPI::some_to_some(communicator, given))
    left_here.insert(cells.begin(), cells.end());
  std::map<unsigned int, List> answers;
  for (const auto &[rank, paths] :
       Utilities::MPI::some_to_some(communicator, wanted))
    for (const auto &path : paths)
      answers[rank].emplace_back(path, left_here.at(path));
  for (const auto &[rank, cells] :
       Utilities::MPI::some_to_some(communicator, answers))
    result.insert(cells.begin(), cells.end());
  return result;
}



template <int dim>
LA::Vector
transfer(const Discretization<dim> &from,
         const LA::Vector &displacement,
         const Discretization<dim> &to)
{
  CellData data;
  for (const auto &cell : from.dof_handler.active_cell_iterators())
    if (cell->is_locally_owned())
      {
        auto &of_cell = data[path_of_cell<dim>(cell)];
        for (const auto &node : from.node_indices(cell))
          for (const auto index : node)
            of_cell.push_back(displacement(index));
      }
  const auto values = exchange_cell_data(data, to);

  LA::Vector result = to.zero_vector();
  for (const auto &cell : to.dof_handler.active_cell_iterators())
    if (cell->is_locally_owned())
      {
        const auto &of_cell = values.at(path_of_cell<dim>(cell));
        unsigned int i      = 0;
        for (const auto &node : to.node_indices(cell))
          for (const auto index : node)
            {
              if (to.owned.is_element(index))
                result(index) = of_cell[i];
              ++i;
            }
      }
  result.compress(VectorOperation::insert);
  return result;
}



template CellData
exchange_cell_data(const CellData &, const Discretization<2> &);
template LA::Vector
transfer(const Discretization<2> &,
         const LA::Vector &,
         const Discretization<2> &);
template CellData
exchange_cell_data(const CellData &, const Discretization<3> &);
template LA::Vector
transfer(const Discretization<3> &,
         const LA::Vector &,
         const Discretization<3> &);
} // namespace Setsudan
