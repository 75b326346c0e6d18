// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <setsudan/blade/blade_edge.h>
#include <setsudan/blade/sliding_blade.h>
#include <setsudan/contact/board.h>
#include <setsudan/contact/entry_hats.h>
#include <setsudan/cut/seam/seam.h>
#include <setsudan/cut/surface/cut_surface.h>
#include <setsudan/solver/condensed/unknown_forces.h>

#include <optional>
#include <utility>
#include <vector>

namespace Setsudan
{
/** The faces of a cut and their node pairs. */
template <int dim>
struct CutFaces
{
  const CutSurface<dim> &surface;
  const std::vector<NodePair<dim>> &pairs;
};

/** What of a blade touches the walls and the front of a cut. */
struct TouchingBlade
{
  SlidingBlade sliding;
  /** Whether each wall meets a flank of its own; else they meet each other. */
  bool has_flanks = false;
  /** Whether the front rests on its edge. */
  bool has_edge = true;
  /** Whether the edge holds what rests on it across the cut. */
  bool edge_holds = false;
};

/**
 * The vectors of which the conditions of contact at a cut are made, each a
 * combination of unknowns: as a row it gives a mean displacement, as a force it
 * is what a contact pressure exerts.
 *
 * Pressure and gaps are those of the hats of the corners of element faces, see
 * FaceHat.
 */
template <int dim>
class ContactBasis
{
public:
  /** Pairs and their weights. */
  using NodeWeights = std::vector<std::pair<unsigned int, double>>;

  enum class Wall
  {
    minus,
    plus
  };

  /** A corner of the cut, on which a hat stands, or one of an outer face at its
   * entry. */
  struct Hat
  {
    /** The row that it belongs to: it is there when that is split. */
    unsigned int row;
    /** The integral of the hat, and the mean depth over it: how far behind the
     * entry it lies, along the blade's direction. */
    double area;
    double depth;
    /** The integral of its part across the whole cut, for walls in steps. */
    double across;
    /** The pairs on the faces around it, and their weights. */
    NodeWeights weights;
    /** Of an outer face, where it is and what it is on; nothing on the cut. */
    std::optional<EntryHat<dim>> outer = {};

    /** Whether a wall has it: on an outer face there is one wall. */
    bool
    is_of(const Wall wall) const
    {
      return !outer || outer->is_plus == (wall == Wall::plus);
    }

    /** Whether it is there while the first rows are split. */
    bool
    is_there(const unsigned int n_split) const
    {
      return outer || row < n_split;
    }
  };

  /** What a vector of a hat measures on one of the two walls. */
  enum class Component
  {
    /** The displacement out of the cut, off the other wall. */
    outward,
    /** That along the blade's direction. */
    along,
    /** That along its edge, where it slices. */
    aside
  };
  /** A node of the front of a row, on which the edge may rest. */
  struct EdgeNode
  {
    unsigned int pair;
    unsigned int row;
    /** Of the row. */
    double depth;
  };

  /** The same on all processes.
   *
   * @param surface the faces of the cut.
   * @param earlier the cuts before it, whose walls may meet.
   * @param board null if there is none; it must live as long.
   * @param outer hats on outer faces, for a blade with flanks. */
  ContactBasis(const ElasticModel<dim> &model,
               const CutSurface<dim> &surface,
               const Seam<dim> &seam,
               const BladeEdge<dim> &edge,
               const TouchingBlade &blade,
               const std::vector<CutFaces<dim>> &earlier,
               const BoardContacts<dim> *board,
               const std::vector<EntryHat<dim>> &outer = {});

  /** Of a body without a cut, on a board. */
  ContactBasis(const MPI_Comm communicator, const BoardContacts<dim> &board);

  MPI_Comm
  communicator() const
  {
    return mpi_communicator;
  }

  const std::vector<Hat> &
  hats() const
  {
    return all_hats;
  }

  const std::vector<EdgeNode> &
  edge_nodes() const
  {
    return all_edge_nodes;
  }

  /** Whether a hat has vectors for each wall; else it has one, which measures
   * how far the walls are apart. */
  bool
  has_flanks() const
  {
    return blade.has_flanks;
  }

  /** The part of a hat's integral that belongs to nodes which can be moved
   * apart while the first rows are split. At the others walls are tied, or
   * supported: no gap can be required there, and what presses on both sides
   * cancels. */
  double
  split_area(const unsigned int hat, const unsigned int n_split) const;

  /** Whether the edge holds what rests on it across the cut. */
  bool
  edge_holds() const
  {
    return blade.edge_holds;
  }

  /** The number of a hat's vector, if it has flanks, and of what the edge
   * measures at a node: its displacement along the blade's direction and, as
   * far as it is dragged, aside. The next one is that across the cut, if the
   * edge holds it. */
  unsigned int
  vector_of_hat(const unsigned int hat,
                const Wall wall,
                const Component component) const;
  unsigned int
  vector_of_edge_node(const unsigned int node) const;

  /** The vectors of a hat are these up to those of the next one; those of outer
   * faces are the last ones. */
  unsigned int
  first_vector_of_hat(const unsigned int hat) const;

  /** The vectors of the corners of earlier cuts, each of which measures how far
   * the walls are apart there, are so many from the first one on. */
  unsigned int
  n_earlier_corners() const
  {
    return areas_of_earlier_corners.size();
  }
  unsigned int
  first_vector_of_earlier_corners() const
  {
    return vector_of_edge_node(all_edge_nodes.size());
  }

  /** The integral of its hat. */
  double
  area_of_earlier_corner(const unsigned int corner) const
  {
    return areas_of_earlier_corners[corner];
  }

  /** The board, or null. */
  const BoardContacts<dim> *
  board() const
  {
    return the_board;
  }
  unsigned int
  n_board_corners() const
  {
    return the_board ? the_board->corners().size() : 0;
  }
  /** The vector of a corner on the board along one of the board's directions.
   */
  unsigned int
  vector_of_board_corner(const unsigned int corner,
                         const unsigned int direction) const
  {
    return first_vector_of_earlier_corners() + n_earlier_corners() +
           dim * corner + direction;
  }

  const std::vector<UnknownForces> &
  vectors() const
  {
    return all_vectors;
  }

  /** The vectors that may be pressed on while the first rows are split, and
   * those of hats that are there when some more are; ascending. */
  std::vector<unsigned int>
  vectors_of_stage(const unsigned int n_split,
                   const unsigned int n_ahead) const;

private:
  /** The hats on the cut. */
  void
  make_hats(const ElasticModel<dim> &model,
            const CutSurface<dim> &surface,
            const Seam<dim> &seam,
            const BladeEdge<dim> &edge);

  unsigned int
  n_vectors_of_wall() const
  {
    return blade.sliding.rubs_aside() ? 3 : 2;
  }
  void
  make_flank_vectors(const Seam<dim> &seam, const BladeEdge<dim> &edge);
  void
  add_outer_hats(const std::vector<EntryHat<dim>> &outer,
                 const BladeEdge<dim> &edge);
  void
  make_edge_vectors(const Seam<dim> &seam, const BladeEdge<dim> &edge);

  /** A vector that measures how far walls are apart. */
  void
  add_gap_vector(const std::vector<NodePair<dim>> &pairs,
                 const NodeWeights &weights);
  void
  add_earlier_walls(const ElasticModel<dim> &model, const CutFaces<dim> &cut);

  void
  add_board(const BoardContacts<dim> &board);

  const TouchingBlade blade;
  const MPI_Comm mpi_communicator;
  const BoardContacts<dim> *const the_board;

  std::vector<Hat> all_hats;
  unsigned int n_hats_on_cut = 0;
  std::vector<EdgeNode> all_edge_nodes;
  std::vector<UnknownForces> all_vectors;
  std::vector<double> areas_of_earlier_corners;
  /** The row with which a pair opens; beyond the last one where it never does.
   */
  std::vector<unsigned int> row_of_opening;
};
} // namespace Setsudan
