// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <setsudan/contact/active_block.h>

#include <deal.II/lac/lapack_full_matrix.h>
#include <deal.II/lac/vector.h>

#include <array>
#include <optional>
#include <utility>
#include <vector>

namespace Setsudan
{
/** Quantities that are linear in a parameter p: constant + p slope. */
struct LinearInParameter
{
  dealii::Vector<double> constant;
  dealii::Vector<double> slope;

  double
  operator()(const unsigned int i, const double p) const
  {
    return constant[i] + p * slope[i];
  }

  /** For boost::serialization. */
  template <typename Archive>
  void
  serialize(Archive &archive, const unsigned int)
  {
    archive &constant &slope;
  }
};

/** Which of some unilateral conditions hold with equality. */
using ActiveSet = std::vector<bool>;

/** A combination of up to three vectors: their numbers and factors. */
using VectorSum = std::array<std::pair<unsigned int, double>, 3>;

/**
 * One more unknown x that gaps share, and its equation:
 *   gap = W multiplier + measured x - required,
 *   exerted . multiplier = stiffness x.
 * With a stiffness that is small beside that of W it is free, and 0 where no
 * active condition knows it.
 */
struct SharedUnknown
{
  dealii::Vector<double> measured;
  dealii::Vector<double> exerted;
  double stiffness;
};

/**
 * Springs that the products know but the problem does not have: each along what
 * a condition measures, with a force of stiffness times that, whether or not
 * the condition is active. They hold a body that is held by its contacts alone,
 * so that there are products at all, and are taken out of every solution.
 */
struct Foundation
{
  /** Of each condition; 0 where it has none. */
  dealii::Vector<double> stiffness;
  /** What each condition measures where its gap is 0. */
  dealii::Vector<double> closed;
};

/** The conditions of a linear complementarity problem. */
struct ContactConditions
{
  /** What the gap of each measures, and what its multiplier exerts. */
  std::vector<VectorSum> measured;
  std::vector<VectorSum> exerted;
  LinearInParameter required;
  std::optional<SharedUnknown> shared = {};
  /** Those that may follow from others; each has a little compliance of its
   * own, which tells their multipliers apart. */
  std::vector<unsigned int> redundant = {};
  /** The leader of each: its own number, or that of another condition. A
   * follower is an equation, gap = 0 with a multiplier of any sign, as of a
   * wall that sticks. It is there where an active set has it, and ends with its
   * leader; it does not begin again with it, since what comes to touch has no
   * friction before it slips. Empty: none follows. */
  std::vector<unsigned int> leader     = {};
  std::optional<Foundation> foundation = {};
};

/**
 * A linear complementarity problem with a parameter p: multipliers and gaps
 * with
 *   gap = W multiplier - required(p) >= 0,  multiplier >= 0,
 *   multiplier . gap = 0.
 * W = R G F^T is the compliance (Delassus) matrix of unilateral contact: G has
 * the displacements along some vectors under forces along them, a row of R says
 * what a gap measures, and one of F what a multiplier exerts. Without friction
 * these are the same and W is symmetric and positive definite, in which case
 * there is one solution for each p, continuous and piecewise linear in p.
 */
class Complementarity
{
public:
  /** The solutions that one active set gives, linear in p. */
  struct Piece
  {
    ActiveSet active;
    LinearInParameter multipliers;
    LinearInParameter gaps;
    /** The forces of the foundation's springs, each along what its condition
     * measures; empty where there are none. */
    LinearInParameter springs;
    /** Along the vectors, as far as multipliers and springs cause them. */
    LinearInParameter displacements;
    /** The shared unknown, which is 0 where there is none. */
    std::array<double, 2> shared{};

    /** For boost::serialization. */
    template <typename Archive>
    void
    serialize(Archive &archive, const unsigned int)
    {
      archive &active &multipliers &gaps &springs &displacements &shared;
    }
  };

  /** Where a piece ends: the condition that would be violated beyond. */
  struct Breakpoint
  {
    double p;
    unsigned int condition;

    /** For boost::serialization. */
    template <typename Archive>
    void
    serialize(Archive &archive, const unsigned int)
    {
      archive &p &condition;
    }
  };

  /** @param products G, which must live as long. */
  Complementarity(const dealii::LAPACKFullMatrix<double> &products,
                  ContactConditions conditions);

  unsigned int
  size() const;

  /** Replace a condition that has no spring, in a problem without a shared
   * unknown.
   *
   * @param required as constant and slope. */
  void
  replace(const unsigned int condition,
          const VectorSum &measured,
          const VectorSum &exerted,
          const std::array<double, 2> &required);

  /**
   * The active set of the solution at p, by the primal-dual active set method;
   * where that returns to a set that it has left already, by principal pivoting
   * on the violated condition of least index (Murty), which ends for every
   * P-matrix.
   *
   * @param guess empty, or the active set of a solution near it.
   * @throw SolverError where there is no solution, as it may be with friction,
   *   or where nothing holds the body.
   */
  ActiveSet
  active_set(const double p, ActiveSet guess = {}) const;

  /** The piece that holds at p: that of the active set there. */
  Piece
  solution(const double p, ActiveSet guess = {}) const;

  /** Let a condition become active, or no longer, and then end what follows
   * it. */
  void
  flip(ActiveSet &active, const unsigned int condition) const;

  /** The piece of an active set, whether or not it holds anywhere. */
  Piece
  piece(const ActiveSet &active) const;

  /** The end of a piece that holds at p, beyond p; nothing where it holds for
   * all that follow. Followers end none.
   *
   * @param heading 1 where larger p follow, -1 where smaller ones do. */
  std::optional<Breakpoint>
  end_of(const Piece &piece, const double p, const int heading = 1) const;

private:
  /** The right-hand side of a problem. */
  struct Side
  {
    dealii::Vector<double> required;
    /** See Foundation; empty where there is none. */
    dealii::Vector<double> closed;
  };
  struct Solved
  {
    dealii::Vector<double> multipliers;
    dealii::Vector<double> springs;
    double shared = 0;
  };

  Side
  side(const double p) const;

  bool
  is_follower(const unsigned int i) const;

  double
  spring(const unsigned int i) const;

  /** What a condition measures. */
  double
  measure(const unsigned int condition,
          const dealii::Vector<double> &displacements) const;

  /** Add the displacements under a force along a sum of vectors. */
  void
  add_displacements(const VectorSum &vectors,
                    const double force,
                    dealii::Vector<double> &displacements) const;

  /** Of the matrix for all that may be unknown: the multipliers of all
   * conditions, then the springs of all, then what they share. */
  double
  entry(const unsigned int row, const unsigned int column) const;

  /** For the rows of the block, with the springs that are known. */
  dealii::LAPACKFullMatrix<double>
  right_hand_sides(const ActiveSet &active,
                   const std::vector<Side> &sides,
                   std::vector<Solved> &solved) const;

  /** Solve for the multipliers of the active conditions and the springs of the
   * others. */
  std::vector<Solved>
  solve(const ActiveSet &active, const std::vector<Side> &sides) const;

  /** The piece of an active set, and what is wrong with it at p: nothing, if it
   * is that of the solution there. */
  struct Tried
  {
    Piece piece;
    std::vector<unsigned int> violated;
  };

  /** Try an active set. One factorization has the values at p and the slopes.
   */
  Tried
  try_at(const ActiveSet &active, const double p) const;

  std::vector<unsigned int>
  violations(const ActiveSet &active,
             const dealii::Vector<double> &multipliers,
             const dealii::Vector<double> &gaps,
             const dealii::Vector<double> &required) const;

  Piece
  pivot(ActiveSet active, const double p) const;

  /** G times the forces of a solution, of which few are not 0. */
  dealii::Vector<double>
  displacements(const Solved &solved) const;

  /** The gaps that displacements leave. */
  dealii::Vector<double>
  gaps(const dealii::Vector<double> &displacements,
       const double shared,
       const dealii::Vector<double> &required) const;

  const dealii::LAPACKFullMatrix<double> &products;
  ContactConditions conditions;
  std::vector<double> own_compliance;
  /** Whether W is symmetric and positive definite, as without friction. */
  bool is_definite;
  /** What was solved last: the next active set is near that. */
  mutable ActiveBlock block;
};
} // namespace Setsudan
