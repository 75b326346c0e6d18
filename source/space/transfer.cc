#include <deal.II/base/mpi.h>

#include <setsudan/space/transfer.h>

#include <algorithm>
#include <map>

namespace Setsudan
{
using namespace dealii;

namespace
{
using CellValues = std::vector<double>;

/** The process at which a cell's values are left and asked for: the processes
 * of the two meshes know nothing of each other's cells but their names. */
unsigned int
rendezvous_process(const CellPath &path, const MPI_Comm communicator)
{
  return path.element % Utilities::MPI::n_mpi_processes(communicator);
}

/** The values on the cells of this process. */
template <int dim>
std::map<unsigned int, std::vector<std::pair<CellPath, CellValues>>>
collect_values(const Discretization<dim> &discretization,
               const LA::Vector &displacement)
{
  std::map<unsigned int, std::vector<std::pair<CellPath, CellValues>>> values;
  for (const auto &cell : discretization.dof_handler.active_cell_iterators())
    if (cell->is_locally_owned())
      {
        CellValues of_cell;
        for (const auto &node : discretization.node_indices(cell))
          for (const auto index : node)
            of_cell.push_back(displacement(index));
        const CellPath path = path_of_cell<dim>(cell);
        values[rendezvous_process(path, discretization.communicator)]
          .emplace_back(path, of_cell);
      }
  return values;
}

/** The values of the cells that each process asks for. */
std::map<CellPath, CellValues>
exchange(const std::map<unsigned int,
                        std::vector<std::pair<CellPath, CellValues>>> &values,
         const std::map<unsigned int, std::vector<CellPath>> &wanted,
         const MPI_Comm communicator)
{
  std::map<CellPath, CellValues> left_here;
  for (const auto &[rank, cells] :
       Utilities::MPI::some_to_some(communicator, values))
    left_here.insert(cells.begin(), cells.end());

  std::map<unsigned int, std::vector<std::pair<CellPath, CellValues>>> answers;
  for (const auto &[rank, paths] :
       Utilities::MPI::some_to_some(communicator, wanted))
    for (const auto &path : paths)
      answers[rank].emplace_back(path, left_here.at(path));

  std::map<CellPath, CellValues> result;
  for (const auto &[rank, cells] :
       Utilities::MPI::some_to_some(communicator, answers))
    result.insert(cells.begin(), cells.end());
  return result;
}
} // namespace


template <int dim>
LA::Vector
transfer(const Discretization<dim> &from,
         const LA::Vector &displacement,
         const Discretization<dim> &to)
{
  std::map<unsigned int, std::vector<CellPath>> wanted;
  for (const auto &cell : to.dof_handler.active_cell_iterators())
    if (cell->is_locally_owned())
      {
        const CellPath path = path_of_cell<dim>(cell);
        wanted[rendezvous_process(path, to.communicator)].push_back(path);
      }
  const auto values =
    exchange(collect_values(from, displacement), wanted, to.communicator);

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



template LA::Vector
transfer(const Discretization<2> &,
         const LA::Vector &,
         const Discretization<2> &);
template LA::Vector
transfer(const Discretization<3> &,
         const LA::Vector &,
         const Discretization<3> &);
} // namespace Setsudan
