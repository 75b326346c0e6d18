// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <setsudan/body/body.h>
#include <setsudan/contact/face_hats.h>
#include <setsudan/cut/surface/cut_parameters.h>
#include <setsudan/mechanics/balance.h>
#include <setsudan/parameters/parameters.h>
#include <setsudan/solver/condensed/unknown_forces.h>

#include <array>
#include <vector>

namespace Setsudan
{
/** Subsection `Board`: a rigid plane on which a body lies that is not glued to
 * it. */
template <int dim>
struct BoardParameters
{
  static void
  declare(dealii::ParameterHandler &handler);

  /** @throw SceneError for a plane that cuts through the body or does not
   * touch it. */
  BoardParameters(const Parameters &parameters, const Body<dim> &body);

  bool is_given;
  /** A point of the plane, and its unit normal towards the body. */
  dealii::Point<dim> point;
  dealii::Tensor<1, dim> normal;
  /** Coulomb's coefficient. */
  double friction;
  /** The outer faces of the body that may come to lie on it. */
  std::vector<CellFace> faces;

  double
  distance(const dealii::Point<dim> &p) const
  {
    return (p - point) * normal;
  }

private:
  void
  read_plane(const Parameters &parameters);
  void
  find_faces(const Body<dim> &body);
};

/**
 * The corners of the faces that may lie on a board, and the elastic foundation
 * that carries the body while its contacts are looked for: a spring along each
 * direction of each corner, as stiff as the body is. What the springs exert is
 * taken out of every solution (see Foundation).
 */
template <int dim>
class BoardContacts
{
public:
  struct Corner
  {
    FaceHat<dim> hat;
    /** The mean distance from the board, of the body at rest. */
    double gap;
    /** Of its springs: force on the corner's vector per work of it. */
    double stiffness;
    /** Whether supports let it move along the board's normal; else the board
     * does nothing there. */
    bool moves;
  };

  /** @param stiffness of the body: the least Young's modulus.
   * @param extent of the body. */
  BoardContacts(const ElasticModel<dim> &model,
                const BoardParameters<dim> &board,
                const double stiffness,
                const double extent);

  /** Coulomb's coefficient. */
  const double friction;

  const std::vector<Corner> &
  corners() const
  {
    return all_corners;
  }

  /** The board's normal, and orthonormal directions in it. */
  const std::array<dealii::Tensor<1, dim>, dim> &
  directions() const
  {
    return all_directions;
  }

  /** For each corner and each direction, a combination of unknowns: what the
   * mean displacement is times the hat's area, and what a pressure exerts. */
  std::vector<UnknownForces>
  vectors() const;

  /** The springs along those of corners that move: the foundation's stiffness
   * is the sum of their squares. */
  std::vector<UnknownForces>
  springs() const;

private:
  void
  mark_supported(const ElasticModel<dim> &model);

  std::array<dealii::Tensor<1, dim>, dim> all_directions;
  std::vector<Corner> all_corners;
};

/** What a board does to a body in a state. */
template <int dim>
struct BoardLoad
{
  /** Without ghosts: its forces, and those that the foundation exerts on top
   * where a solver has it. */
  LA::Vector nodal_forces;
  LA::Vector foundation_forces;
  /** The forces of its corners, with which the nodal ones are in equilibrium.
   */
  std::vector<PointForce<dim>> forces;
  /** Along its normal. */
  double force = 0;
  /** The piece whose friction comes nearest to Coulomb's, as a whole, or
   * exceeds it the most, and their ratio. */
  unsigned int sliding_piece = 0;
  double part_of_friction    = 0;
  /** How far a node has passed the board. */
  double passed = 0;
};

/** How far a blade's edge travels in a cut, from its entry, until a part of it
 * that is over the cut meets a board; infinite where it does not go towards it.
 */
template <int dim>
double
travel_to_board(const BoardParameters<dim> &board,
                const CoarseMesh<dim> &mesh,
                const Cut<dim> &cut);

/** How far it may travel: a little further, since strains of a last row may be
 * large which are taken as small. */
template <int dim>
double
last_travel_on_board(const BoardParameters<dim> &board,
                     const CoarseMesh<dim> &mesh,
                     const Cut<dim> &cut);

/** Whether some corner moves along a board's normal; else it does nothing. */
template <int dim>
bool
carries_something(const BoardContacts<dim> &board);

/** How far a node of a deformed body has passed a board: not at all in the mean
 * over a hat, but single nodes may, and faces that were not expected to come
 * to it. Called by all processes.
 *
 * @param displacement without ghosts. */
template <int dim>
double
depth_beyond_board(const ElasticModel<dim> &model,
                   const BoardParameters<dim> &board,
                   const LA::Vector &displacement);
} // namespace Setsudan
