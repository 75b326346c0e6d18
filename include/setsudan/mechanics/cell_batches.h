// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <deal.II/base/aligned_vector.h>
#include <deal.II/base/partitioner.h>
#include <deal.II/lac/la_parallel_vector.h>

#include <setsudan/kernel/stiffness_kernel.h>
#include <setsudan/material/material_parameters.h>
#include <setsudan/space/cell_geometry.h>

#include <memory>
#include <optional>
#include <vector>

namespace Setsudan
{
/**
 * This process's cells in batches, as the kernel takes them: the stiffness of
 * the body without its matrix. Cells of the same shape share what depends on
 * it; 27 points of a general one take 2 kB.
 *
 * For serendipity and full quadratic elements.
 */
template <int dim>
class CellBatches
{
public:
  using Cell        = typename Discretization<dim>::Cell;
  using Vector      = dealii::LinearAlgebra::distributed::Vector<double>;
  using Partitioner = dealii::Utilities::MPI::Partitioner;
  /** Of all batches, one behind the other: see CellBatch::tangent. */
  using Tangent = dealii::AlignedVector<double>;

  /** @param discretization must live as long. */
  CellBatches(const Discretization<dim> &discretization,
              const MaterialParameters<dim> &materials);

  /** Let vectors have these unknowns too, besides this process's own and those
   * of its cells. */
  void
  add_ghost_indices(const dealii::IndexSet &unknowns);

  /** How vectors are distributed. */
  const std::shared_ptr<const Partitioner> &
  partitioner() const;

  /** Add K u of this process's cells.
   *
   * @param displacement with ghosts up to date.
   * @param forces       also of ghosts, not yet handed to their owners.
   * @param tangent      in the place of Hooke's law; or null. */
  void
  apply(const Vector &displacement,
        Vector &forces,
        const Tangent *tangent = nullptr) const;

  /** Whether the kernels know the laws of all cells under finite strain. */
  bool
  is_neo_hookean() const;

  /** Add the internal forces of this process's cells, which are neo-Hookean;
   * vectors as those of apply().
   *
   * @return the energy that they store, infinite where a volume is not
   *   positive; the forces have no meaning there. */
  double
  add_neo_hooke(const Vector &displacement, Vector &forces);

  /** The tangent about a displacement.
   *
   * @param before from which its stress is extrapolated, or null. */
  std::shared_ptr<const Tangent>
  tangent(const Vector &displacement, const Vector *before);

  /** A copy of this process's own part of a vector, with room for ghosts. */
  Vector
  copy_in(const LA::Vector &vector) const;

  /** The opposite of copy_in(). */
  LA::Vector
  copy_out(const Vector &vector) const;

  /** The positions of the nodes, with ghosts, made when first asked for. */
  const Vector &
  positions();

  unsigned int
  size() const;

  CellBatch
  operator[](const unsigned int batch) const;

  /** The same with a tangent, or without where that is null. */
  CellBatch
  with_tangent(const unsigned int batch, const Tangent *tangent) const;

  /** Whether a batch has the shapes and the moduli of the one before. */
  bool
  same_as_previous(const unsigned int batch) const;

  unsigned int
  n_nodes() const;

  /** This process's cells, batch by batch. */
  const std::vector<Cell> &
  cells() const;

  const StiffnessKernel<dim> &kernel;

private:
  void
  set_partitioner(const dealii::IndexSet &ghosts);

  /** Ask the materials for the laws that the kernels know. */
  void
  find_forms();

  using Numbers = dealii::AlignedVector<double>;

  /** What all batches of cells of one shape and one formulation share, or what
   * one batch has for itself. */
  struct Geometry
  {
    Numbers gradients;
    Numbers pressures;
    bool is_uniform;
    bool is_mixed;
  };

  bool
  is_mixed(const Cell &cell) const;

  /** Make a batch of these cells, and empty the list; `geometry` is at the last
   * cell before. */
  void
  append(std::vector<Cell> &batch, CellGeometry<dim> &geometry);

  const Discretization<dim> &discretization;
  const MaterialParameters<dim> &materials;
  std::shared_ptr<const Partitioner> known;
  std::vector<std::shared_ptr<const Geometry>> geometries;
  std::vector<unsigned int> n_cells_of_batch;
  std::vector<Cell> all_cells;
  Numbers moduli;
  /** The laws of the batches; nothing where one of them is not known. */
  std::optional<std::vector<NeoHookeForm>> forms;
  dealii::AlignedVector<unsigned int> nodes;
  std::unique_ptr<Vector> node_positions;
};

/**
 * The nodal forces K u by which the elements resist a displacement, with no
 * constraint applied; neither has ghosts.
 */
template <int dim>
LA::Vector
internal_forces(const CellBatches<dim> &batches,
                const LA::Vector &displacement);
} // namespace Setsudan
