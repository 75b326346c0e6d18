// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <deal.II/base/index_set.h>
#include <deal.II/distributed/tria.h>
#include <deal.II/dofs/dof_handler.h>
#include <deal.II/fe/fe_system.h>
#include <deal.II/fe/mapping.h>
#include <deal.II/lac/affine_constraints.h>

#include <setsudan/body/body.h>
#include <setsudan/body/supports.h>
#include <setsudan/element/element_type.h>
#include <setsudan/mesh/nodes.h>
#include <setsudan/mesh/refinement.h>
#include <setsudan/space/linear_algebra.h>

#include <array>
#include <memory>
#include <vector>

namespace Setsudan
{
/**
 * The finite element space of the displacement on one mesh, distributed over
 * the processes. A new one is made when the mesh is cut.
 */
template <int dim>
class Discretization
{
public:
  using Cell  = typename dealii::DoFHandler<dim>::active_cell_iterator;
  using Index = dealii::types::global_dof_index;

  /** The unknowns of one node: its displacement components. */
  using NodeIndices = std::array<Index, dim>;

  /** @param mesh must live as long; a surgery on it does not matter, since it
   * moves no node. */
  Discretization(const CoarseMesh<dim> &mesh,
                 const Refinement &refinement,
                 const MPI_Comm communicator,
                 const ElementType type = ElementType::serendipity);

  /** The element of the body that `cell` is. */
  unsigned int
  element(const Cell &cell) const;

  bool
  is_curved() const;

  /** The shape of the cells: isoparametric where the body is curved. */
  const dealii::Mapping<dim> &
  mapping() const;

  /** The points of Gauss's rule along each direction of a cell, with which
   * matrices and loads are integrated: exactly in parallelepipeds. */
  unsigned int
  n_gauss_points() const;

  /** The nodes of all cells in reference coordinates: those of nodes.h as far
   * as the type has them, then others. */
  const std::vector<dealii::Point<dim>> &
  nodes() const;

  /** The nodes of a cell in the reference coordinates of its element. */
  std::vector<dealii::Point<dim>>
  points_in_element(const Cell &cell) const;

  std::vector<dealii::Point<dim>>
  node_positions(const Cell &cell) const;

  /** The unknowns of every node of a cell. */
  std::vector<NodeIndices>
  node_indices(const Cell &cell) const;

  /** A vector of which each process holds its own part, all zero. */
  LA::Vector
  zero_vector() const;

  /** A copy of `vector` that can be read on all cells this process knows. */
  LA::Vector
  with_ghosts(const LA::Vector &vector) const;

  /** Where an unknown of this process lies. */
  struct DofLocation
  {
    dealii::Point<dim> position;
    unsigned int component;
  };

  /** The dof_locations of this process's unknowns, in the order of their
   * numbers. */
  const std::vector<DofLocation> &
  dof_locations() const;

  const MPI_Comm communicator;
  const ElementType type;
  const dealii::FESystem<dim> fe;
  dealii::parallel::distributed::Triangulation<dim> triangulation;
  dealii::DoFHandler<dim> dof_handler;
  dealii::IndexSet owned;
  dealii::IndexSet relevant;

private:
  void
  make_mapping();

  /** Positions of the nodes of a body with curved sides, without ghosts. */
  LA::Vector
  curved_positions() const;

  void
  find_sites();

  const CoarseMesh<dim> &mesh;
  /** Positions of the nodes, as unknowns of the space, of a curved body. */
  LA::Vector positions;
  std::unique_ptr<dealii::Mapping<dim>> shape;
  std::vector<DofLocation> all_sites;
  /** What vectors are copied from, which takes less time than to make them. */
  LA::Vector zero, zero_with_ghosts;
};
} // namespace Setsudan
