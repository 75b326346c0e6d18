// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <setsudan/simulation/cut_body.h>
#include <setsudan/solver/condensed/condensed_solver.h>

#include <functional>
#include <map>
#include <memory>
#include <vector>

namespace Setsudan
{
/** Forces on the unknowns of a body, the same on all processes. */
struct StageForces
{
  std::vector<UnknownForces> vectors;
  /** The numbers of those that are of interest while the first rows are split,
   * ascending. */
  std::function<std::vector<unsigned int>(unsigned int n_split)> of_stage;
};

/**
 * What forces do to each other in the stages of a cut: in each one the work of
 * every force in the displacement under every other one, and in that under the
 * body's loads.
 */
template <int dim>
class StageCompliance
{
public:
  /** In the way that the scene and the sizes ask for.
   *
   * @param body must live as long.
   * @param last the most rows that will be split.
   * @throw SolverError, FloatingPieceError where the body in that stage is not
   *   what it can be. */
  static std::unique_ptr<StageCompliance<dim>>
  make(CutBody<dim> &body, StageForces forces, const unsigned int last);

  virtual ~StageCompliance() = default;

  /** While the first rows are split: of all forces, and in the last row and
   * column of the loads, whose displacement is counted from the lift on. The
   * same on all processes, until the next call; only the lower triangle is set.
   * Of two forces of which neither is of the stage there is nothing to be
   * known.
   */
  virtual const dealii::LAPACKFullMatrix<double> &
  products(const unsigned int n_split) = 0;

  /** The work of each force in the lift. */
  virtual const std::vector<double> &
  work_in_lift() const = 0;

  /** Whether this is of what the body is now. */
  virtual bool
  is_of_present_body() const = 0;
};

/** That of a body which is condensed onto the cut: the products are sums over
 * the free unknowns of the interface, which each stage adds to. */
template <int dim>
class CondensedStageCompliance : public StageCompliance<dim>
{
public:
  CondensedStageCompliance(CutBody<dim> &body,
                           const StageForces &forces,
                           const unsigned int last);

  const dealii::LAPACKFullMatrix<double> &
  products(const unsigned int n_split) override;

  const std::vector<double> &
  work_in_lift() const override;

  bool
  is_of_present_body() const override;

private:
  /** Products of all vectors over the first unknowns. */
  struct Products
  {
    dealii::LAPACKFullMatrix<double> matrix;
    unsigned int n_summed = 0;
  };

  void
  advance(Products &products, const unsigned int n_free) const;

  CutBody<dim> &body;
  const std::shared_ptr<CondensedSolver<dim>> solver;
  /** The free unknowns of each stage. */
  std::vector<unsigned int> n_free;
  typename CondensedSolver<dim>::Compliance compliance;
  Products of_stage;
  /** The same in stages ahead of that, which are looked at in ascending order
   * before the next one is. */
  Products ahead;
  unsigned int last_asked = 0;
};

/**
 * That by the solver of each stage, iterative or not, on all processes: one
 * solve for each force of the stage, which begins with the displacement of the
 * stage before. Only the products are gathered.
 *
 * With displacements d, which are not exact, and residuals r = f - K d the
 * products are taken as
 *   d_i . f_j + r_i . d_j,
 * which is symmetric, and wrong by the product of two errors only.
 */
template <int dim>
class IterativeStageCompliance : public StageCompliance<dim>
{
public:
  IterativeStageCompliance(CutBody<dim> &body,
                           StageForces forces,
                           const unsigned int last);

  const dealii::LAPACKFullMatrix<double> &
  products(const unsigned int n_split) override;

  const std::vector<double> &
  work_in_lift() const override;

  bool
  is_of_present_body() const override;

private:
  /** Vectors of what a process has of them, as columns. */
  using Columns = std::vector<std::vector<double>>;

  dealii::LAPACKFullMatrix<double>
  solve_stage(const unsigned int n_split);

  /** A force as a vector; the one behind the last is that of the loads. */
  LA::Vector
  force(const unsigned int number) const;

  /** The products of a stage.
   *
   * @param residuals of its displacements, in their order. */
  dealii::LAPACKFullMatrix<double>
  multiply(const Columns &residuals) const;

  CutBody<dim> &body;
  const StageForces forces;
  /** What the body was when this began: see CutBody. */
  const unsigned int n_changes;
  LA::Vector loads;
  std::vector<double> in_lift;
  /** Of the stage that was solved last, those of forces that move anything. */
  std::map<unsigned int, std::vector<double>> displacements;
  /** The products of stages that may be asked for again. */
  std::map<unsigned int, dealii::LAPACKFullMatrix<double>> known;
  unsigned int last_asked = 0;
};
} // namespace Setsudan
