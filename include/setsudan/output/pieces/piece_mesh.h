// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <array>
#include <setsudan/body/body.h>
#include <setsudan/mechanics/elastic_model.h>
#include <setsudan/output/frames/vtu.h>
#include <setsudan/output/output_directory.h>
#include <string>
#include <vector>

namespace Setsudan
{
/** A named part of a piece. */
struct PieceGroup
{
  std::string name;
  int number;
  unsigned int dimension;
  /** The group's cells, faces, lines or vertices, each by its nodes in the
   * order of nodes.h. */
  std::vector<std::vector<unsigned int>> entities;
};

/**
 * A piece of a divided body as a body of its own: its nodes and elements,
 * numbered from 0 in the order that they had in the uncut body. A box that is
 * part of a box so gets the paper's numbers. Elements are those of the body
 * before refinement.
 */
template <int dim>
struct PieceMesh
{
  std::vector<dealii::Point<dim>> nodes;
  /** The nodes' numbers in the uncut body. */
  std::vector<unsigned int> numbers_in_body;
  /** The displacements of the nodes in the last state. */
  std::vector<dealii::Point<dim>> displacements;
  /** Nodes of each element, in the order of nodes.h. */
  std::vector<std::array<unsigned int, n_element_nodes<dim>>> elements;
  /** The elements' numbers in the uncut body. */
  std::vector<unsigned int> elements_in_body;
  /** The number of each element's material. */
  std::vector<unsigned int> materials;
  /** The body's groups, as far as they are in this piece. */
  std::vector<PieceGroup> groups;

  double
  volume() const;
};

/** The pieces of a mesh, in the order of their numbers in `pieces`. */
template <int dim>
std::vector<PieceMesh<dim>>
make_piece_meshes(const CoarseMesh<dim> &mesh,
                  const std::vector<unsigned int> &pieces,
                  const Body<dim> &body);

/** Displacements of the nodes of the elements of the body, by element. */
template <int dim>
using ElementDisplacements =
  std::vector<std::array<dealii::Tensor<1, dim>, n_element_nodes<dim>>>;

/**
 * The displacement at the nodes that the body had before refinement; called by
 * all processes, the first one gets all of it.
 *
 * @param displacement with ghosts.
 */
template <int dim>
ElementDisplacements<dim>
gather_displacements(const Discretization<dim> &discretization,
                     const unsigned int n_elements,
                     const LA::Vector &displacement);

/** Set the displacements of a piece's nodes. */
template <int dim>
void
set_displacements(const ElementDisplacements<dim> &displacements,
                  PieceMesh<dim> &piece);

/** Move the nodes of a piece by their displacements. */
template <int dim>
void
deform(PieceMesh<dim> &piece);

/** Write a piece as a gmsh file (MSH 4.1, 20-node hexahedra or 8-node
 * quadrilaterals) with its groups, its numbers plus 1, since gmsh counts from
 * 1. Elements without a group are in one that is called `piece`. */
template <int dim>
void
write_piece_msh(const PieceMesh<dim> &piece,
                const OutputDirectory &directory,
                const std::string &name);

/** The nodes and elements of a piece for VTK, with their numbers. */
template <int dim>
VtuGrid
grid_of_piece(const PieceMesh<dim> &piece);

/** Write a piece for ParaView, with its numbers, displacement and materials. */
template <int dim>
void
write_piece_vtu(const PieceMesh<dim> &piece,
                const OutputDirectory &directory,
                const std::string &name);
} // namespace Setsudan
