#include <deal.II/base/mpi.h>

#include <setsudan/elasticity/transfer.h>

namespace Setsudan
{
using namespace dealii;

namespace
{
/** Call `action(place, index)` for every unknown of this process's cells, with
 * its place in a vector that holds the elements' values one by one. */
template <int dim>
void
for_each_place(const Discretization<dim> &discretization,
               const std::function<void(types::global_dof_index,
                                        types::global_dof_index)> &action)
{
  for (const auto &cell : discretization.dof_handler.active_cell_iterators())
    if (cell->is_locally_owned())
      {
        types::global_dof_index place =
          types::global_dof_index(discretization.element(cell)) *
          n_element_nodes<dim> * dim;
        for (const auto &node : discretization.node_indices(cell))
          for (const auto index : node)
            action(place++, index);
      }
}
} // namespace


template <int dim>
LA::Vector
transfer(const Discretization<dim> &from,
         const LA::Vector &displacement,
         const Discretization<dim> &to)
{
  const MPI_Comm communicator = from.communicator;
  // The processes agree on the elements only, so the values travel by element:
  // each process holds a range of them in between.
  const types::global_dof_index n_values =
    from.triangulation.n_global_active_cells() * n_element_nodes<dim> * dim;
  const IndexSet range = Utilities::MPI::create_evenly_distributed_partitioning(
    communicator, n_values);
  LA::Vector by_element(range, communicator);
  for_each_place<dim>(from, [&](const auto place, const auto index) {
    const double value = displacement(index);
    by_element.set(1, &place, &value);
  });
  by_element.compress(VectorOperation::insert);

  IndexSet needed(n_values);
  for_each_place<dim>(
    to, [&](const auto place, const auto) { needed.add_index(place); });
  needed.compress();
  LA::Vector readable(range, needed, communicator);
  readable = by_element;

  LA::Vector result = to.zero_vector();
  for_each_place<dim>(to, [&](const auto place, const auto index) {
    if (to.owned.is_element(index))
      result(index) = readable(place);
  });
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
