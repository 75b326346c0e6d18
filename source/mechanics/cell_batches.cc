// SPDX-License-Identifier: LGPL-2.1-or-later
#include <deal.II/base/mpi.h>

#include <setsudan/mechanics/cell_batches.h>

namespace Setsudan
{
using namespace dealii;

namespace
{
/** What cells have, in the order of a batch; without lanes where it is the same
 * for all. */
AlignedVector<double>
interleaved(const std::vector<std::vector<double>> &of_cells,
            const bool is_same)
{
  AlignedVector<double> numbers;
  if (of_cells.empty())
    return numbers;
  const unsigned int n_lanes = is_same ? 1 : of_cells.size();
  numbers.resize(of_cells[0].size() * n_lanes);
  for (unsigned int i = 0; i < of_cells[0].size(); ++i)
    for (unsigned int lane = 0; lane < n_lanes; ++lane)
      numbers[i * n_lanes + lane] = of_cells[lane][i];
  return numbers;
}
} // namespace

template <int dim>
CellBatches<dim>::CellBatches(const Discretization<dim> &discretization,
                              const MaterialParameters<dim> &materials)
  : kernel(stiffness_kernel<dim>())
  , discretization(discretization)
  , materials(materials)
{
  Assert(discretization.type != ElementType::linear,
         ExcMessage("The kernels are for elements with nodes on their lines."));
  CellGeometry<dim> geometry(discretization);
  // All cells of a batch have the same formulation.
  for (const bool mixed : {false, true})
    if (!mixed || materials.any_is_mixed())
      {
        std::vector<Cell> batch;
        for (const auto &cell :
             discretization.dof_handler.active_cell_iterators())
          if (cell->is_locally_owned() && is_mixed(cell) == mixed)
            {
              batch.push_back(cell);
              if (batch.size() == kernel.n_lanes)
                append(batch, geometry);
            }
        append(batch, geometry);
      }
  find_forms();
  set_partitioner(discretization.relevant);
}



template <int dim>
bool
CellBatches<dim>::is_mixed(const Cell &cell) const
{
  return materials.of_element(discretization.element(cell)).is_mixed;
}



template <int dim>
void
CellBatches<dim>::append(std::vector<Cell> &batch, CellGeometry<dim> &geometry)
{
  if (batch.empty())
    return;
  n_cells_of_batch.push_back(batch.size());
  for (const auto &cell : batch)
    all_cells.push_back(cell);
  batch.resize(kernel.n_lanes, batch.back());
  for (const double Hooke::*modulus : {&Hooke::lambda, &Hooke::mu})
    for (const auto &cell : batch)
      moduli.push_back(
        materials.of_element(discretization.element(cell)).at_rest.*modulus);

  const bool is_shared = geometry.reinit(batch[0]) && !geometries.empty() &&
                         geometries.back()->is_uniform &&
                         geometries.back()->is_mixed == is_mixed(batch[0]);
  std::vector<std::vector<double>> gradients{geometry.gradients()}, pressures;
  if (is_mixed(batch[0]))
    pressures.push_back(geometry.pressures());
  bool is_uniform = true;
  for (unsigned int lane = 1; lane < batch.size(); ++lane)
    {
      is_uniform = geometry.reinit(batch[lane]) && is_uniform;
      gradients.push_back(geometry.gradients());
      if (!pressures.empty())
        pressures.push_back(geometry.pressures());
    }
  geometries.push_back(is_shared && is_uniform
                         ? geometries.back()
                         : std::make_shared<const Geometry>(
                             Geometry{interleaved(gradients, is_uniform),
                                      interleaved(pressures, false),
                                      is_uniform,
                                      !pressures.empty()}));
  batch.clear();
}



template <int dim>
void
CellBatches<dim>::add_ghost_indices(const IndexSet &unknowns)
{
  IndexSet ghosts = known->ghost_indices();
  ghosts.add_indices(unknowns);
  ghosts.subtract_set(discretization.owned);
  const bool is_new = ghosts.n_elements() > known->n_ghost_indices();
  if (Utilities::MPI::logical_or(is_new, discretization.communicator))
    set_partitioner(ghosts);
}



template <int dim>
void
CellBatches<dim>::set_partitioner(const IndexSet &ghosts)
{
  known = std::make_shared<const Partitioner>(
    discretization.owned, ghosts, discretization.communicator);
  node_positions.reset();
  nodes.resize(size() * n_nodes() * kernel.n_lanes);
  for (unsigned int batch = 0, first = 0; batch < size(); ++batch)
    {
      for (unsigned int lane = 0; lane < kernel.n_lanes; ++lane)
        {
          const auto &cell =
            all_cells[first + std::min(lane, n_cells_of_batch[batch] - 1)];
          const auto indices = discretization.node_indices(cell);
          for (unsigned int node = 0; node < n_nodes(); ++node)
            {
              // deal.II numbers the components of a node one after the other.
              Assert(indices[node][dim - 1] == indices[node][0] + dim - 1,
                     ExcInternalError());
              nodes[(batch * n_nodes() + node) * kernel.n_lanes + lane] =
                known->global_to_local(indices[node][0]);
            }
        }
      first += n_cells_of_batch[batch];
    }
}



template <int dim>
const std::shared_ptr<const Utilities::MPI::Partitioner> &
CellBatches<dim>::partitioner() const
{
  return known;
}



template <int dim>
void
CellBatches<dim>::apply(const Vector &displacement,
                        Vector &forces,
                        const Tangent *const tangent) const
{
  const auto apply_batch = discretization.type == ElementType::serendipity
                             ? kernel.apply_serendipity
                             : kernel.apply_quadratic;
  for (unsigned int batch = 0; batch < size(); ++batch)
    apply_batch(
      with_tangent(batch, tangent), displacement.begin(), forces.begin());
}



template <int dim>
typename CellBatches<dim>::Vector
CellBatches<dim>::copy_in(const LA::Vector &vector) const
{
  Vector copy(known);
  if (vector.has_ghost_elements())
    {
      for (const auto index : discretization.owned)
        copy(index) = vector(index);
      return copy;
    }
  const double *const values = vector.trilinos_vector()[0];
  std::copy(values, values + copy.locally_owned_size(), copy.begin());
  return copy;
}



template <int dim>
LA::Vector
CellBatches<dim>::copy_out(const Vector &vector) const
{
  LA::Vector copy = discretization.zero_vector();
  std::copy(vector.begin(),
            vector.begin() + vector.locally_owned_size(),
            copy.trilinos_vector()[0]);
  return copy;
}



template <int dim>
const typename CellBatches<dim>::Vector &
CellBatches<dim>::positions()
{
  if (!node_positions)
    {
      node_positions = std::make_unique<Vector>(known);
      double *value  = node_positions->begin();
      for (const auto &site : discretization.dof_locations())
        *value++ = site.position[site.component];
      node_positions->update_ghost_values();
    }
  return *node_positions;
}



template <int dim>
unsigned int
CellBatches<dim>::size() const
{
  return n_cells_of_batch.size();
}



template <int dim>
CellBatch
CellBatches<dim>::operator[](const unsigned int batch) const
{
  const Geometry &geometry = *geometries[batch];
  CellBatch view;
  view.nodes     = &nodes[batch * n_nodes() * kernel.n_lanes];
  view.gradients = geometry.gradients.data();
  view.next_gradients =
    batch + 1 < size() && geometries[batch + 1] != geometries[batch]
      ? geometries[batch + 1]->gradients.data()
      : nullptr;
  view.moduli     = &moduli[2 * batch * kernel.n_lanes];
  view.pressures  = geometry.is_mixed ? geometry.pressures.data() : nullptr;
  view.is_uniform = geometry.is_uniform;
  view.n_cells    = n_cells_of_batch[batch];
  return view;
}



template <int dim>
CellBatch
CellBatches<dim>::with_tangent(const unsigned int batch,
                               const Tangent *const tangent) const
{
  CellBatch view = (*this)[batch];
  if (tangent != nullptr)
    view.tangent = tangent->data() + batch * (tangent->size() / size());
  return view;
}



template <int dim>
bool
CellBatches<dim>::same_as_previous(const unsigned int batch) const
{
  const unsigned int n      = 2 * kernel.n_lanes;
  const double *const first = &moduli[batch * n];
  return batch > 0 && geometries[batch] == geometries[batch - 1] &&
         std::equal(first, first + n, first - n);
}



template <int dim>
unsigned int
CellBatches<dim>::n_nodes() const
{
  return discretization.fe.n_dofs_per_cell() / dim;
}



template <int dim>
const std::vector<typename CellBatches<dim>::Cell> &
CellBatches<dim>::cells() const
{
  return all_cells;
}



template <int dim>
LA::Vector
internal_forces(const CellBatches<dim> &batches, const LA::Vector &displacement)
{
  auto u = batches.copy_in(displacement);
  typename CellBatches<dim>::Vector f(batches.partitioner());
  u.update_ghost_values();
  batches.apply(u, f);
  f.compress(VectorOperation::add);
  return batches.copy_out(f);
}



template class CellBatches<2>;
template class CellBatches<3>;
template LA::Vector
internal_forces(const CellBatches<2> &, const LA::Vector &);
template LA::Vector
internal_forces(const CellBatches<3> &, const LA::Vector &);
} // namespace Setsudan
