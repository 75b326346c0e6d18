#pragma once

#include <setsudan/body/body.h>
#include <setsudan/body/nodes.h>
#include <setsudan/output/output_directory.h>

#include <array>
#include <vector>

namespace Setsudan
{
/**
 * A piece of a divided body as a body of its own: its nodes and elements,
 * numbered from 0 in the order that they had in the uncut body. A box that is
 * part of a box so gets the paper's numbers.
 */
template <int dim>
struct PieceMesh
{
  /** Rest positions of the nodes. */
  std::vector<dealii::Point<dim>> nodes;
  /** The nodes' numbers in the uncut body. */
  std::vector<unsigned int> numbers_in_body;
  /** Nodes of each element, in the order of nodes.h. */
  std::vector<std::array<unsigned int, n_element_nodes<dim>>> elements;
  /** The elements' numbers in the uncut body. */
  std::vector<unsigned int> elements_in_body;

  double
  volume() const;
};

/** The pieces of a mesh, in the order of their numbers in `pieces`. */
template <int dim>
std::vector<PieceMesh<dim>>
make_piece_meshes(const CoarseMesh<dim> &mesh,
                  const std::vector<unsigned int> &pieces,
                  const Body<dim> &body);

/** Write a piece as a gmsh file (MSH 4.1, 20-node hexahedra or 8-node
 * quadrilaterals), its numbers plus 1, since gmsh counts from 1. */
template <int dim>
void
write_piece_msh(const PieceMesh<dim> &piece,
                const OutputDirectory &directory,
                const std::string &name);

/** Write a piece for ParaView, with its numbers. */
template <int dim>
void
write_piece_vtu(const PieceMesh<dim> &piece,
                const OutputDirectory &directory,
                const std::string &name);
} // namespace Setsudan
