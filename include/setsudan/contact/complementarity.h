// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

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
    /** Along the vectors, as far as the multipliers cause them. */
    LinearInParameter displacements;
    /** The shared unknown, which is 0 where there is none. */
    std::array<double, 2> shared;

    /** For boost::serialization. */
    template <typename Archive>
    void
    serialize(Archive &archive, const unsigned int)
    {
      archive &active &multipliers &gaps &displacements &shared;
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

  /** @param products G, which must live as long.
   * @param shared if there is one.
   * @param redundant the conditions that may follow from others; each has a
   *   little compliance of its own, which tells their multipliers apart.
   * @param followers conditions that hold with equality, and multipliers of any
   *   sign, while another one does: their numbers and those of the others. */
  Complementarity(
    const dealii::LAPACKFullMatrix<double> &products,
    std::vector<VectorSum> measured,
    std::vector<VectorSum> exerted,
    LinearInParameter required,
    std::optional<SharedUnknown> shared                          = {},
    std::vector<unsigned int> redundant                          = {},
    std::vector<std::pair<unsigned int, unsigned int>> followers = {});

  unsigned int
  size() const;


  /**
   * The active set of the solution at p, by the primal-dual active set method;
   * where that returns to a set that it has left already, by principal pivoting
   * on the violated condition of least index (Murty), which ends for every
   * P-matrix.
   *
   * @param guess empty, or the active set of a solution near it.
   * @throw SolverError where there is no solution, as it may be with friction.
   */
  ActiveSet
  active_set(const double p, ActiveSet guess = {}) const;

  /** The piece of an active set, whether or not it holds anywhere. */
  Piece
  piece(const ActiveSet &active) const;

  /** The end of a piece that holds at p, beyond p; nothing where it holds for
   * all that follow.
   *
   * @param heading 1 where larger p follow, -1 where smaller ones do. */
  std::optional<Breakpoint>
  end_of(const Piece &piece, const double p, const int heading = 1) const;

private:
  struct Solved
  {
    dealii::Vector<double> multipliers;
    double shared = 0;
  };

  /** Solve for the multipliers of the active conditions; the others are 0.
   *
   * @param required one or more right-hand sides. */
  std::vector<Solved>
  solve(const ActiveSet &active,
        const std::vector<dealii::Vector<double>> &required) const;

  /** What is wrong with an active set at p: none of it, if it is that of the
   * solution. */
  std::vector<unsigned int>
  violations(const ActiveSet &active,
             const dealii::Vector<double> &required) const;

  /** Set the followers as those that they follow are. */
  void
  follow(ActiveSet &active) const;

  ActiveSet
  pivot(ActiveSet active, const dealii::Vector<double> &required) const;

  /** G F^T times multipliers, of which few are not 0. */
  dealii::Vector<double>
  displacements(const dealii::Vector<double> &multipliers) const;

  /** The gaps that displacements leave. */
  dealii::Vector<double>
  gaps(const dealii::Vector<double> &displacements,
       const double shared,
       const dealii::Vector<double> &required) const;

  const dealii::LAPACKFullMatrix<double> &products;
  const std::vector<VectorSum> measured;
  const std::vector<VectorSum> exerted;
  const LinearInParameter required;
  const std::optional<SharedUnknown> shared;
  std::vector<double> own_compliance;
  const std::vector<std::pair<unsigned int, unsigned int>> followers;
  ActiveSet is_follower;
};
} // namespace Setsudan
