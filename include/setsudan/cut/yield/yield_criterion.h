// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <setsudan/cut/seam/blade_load.h>
#include <setsudan/cut/seam/row_areas.h>
#include <setsudan/cut/yield/cutting_stress.h>
#include <setsudan/solver/tangent_solver.h>

#include <functional>
#include <memory>

namespace Setsudan
{
/** The interface of a body that is being cut to the yield criteria. */
template <int dim>
class YieldingBody
{
public:
  virtual ~YieldingBody() = default;

  virtual const ElasticModel<dim> &
  model() const = 0;

  /** The seam of the newest cut. */
  virtual const Seam<dim> &
  seam() const = 0;

  /** The cells that meet it. */
  virtual const SeamCells<dim> &
  seam_cells() const = 0;

  /** The area that splitting a row opens. */
  virtual const RowArea &
  area_of_row(const unsigned int row) = 0;

  /** What the blade's load does as a row splits. */
  virtual BladeAdvance
  advance_of_blade(const unsigned int row) const = 0;

  /** The solver as if the ties of one row were taken off.
   *
   * @throw FloatingPieceError where that leaves a part which nothing holds. */
  virtual std::shared_ptr<TangentSolver>
  solver_without(const unsigned int row) = 0;
};

/** The response of a linear body to forces: a solved displacement with what
 * belongs to it. Responses can be superposed. */
struct LinearResponse
{
  LA::Vector displacement;
  /** All nodal forces. */
  LA::Vector forces;
  /** See TangentSolver::solve(). */
  LA::Vector lift;
  /** How many times the blade's load is in the forces. */
  double blade_factor;
};

/** Decides whether a row yields: the requirement of the scene's criterion, with
 * the blade's sharpness in it. */
template <int dim>
class YieldCriterion
{
public:
  /** @param materials must live as long. */
  static std::unique_ptr<const YieldCriterion<dim>>
  make(const YieldParameters &parameters,
       const MaterialParameters<dim> &materials,
       const double sharpness);

  virtual ~YieldCriterion() = default;

  /**
   * The driving and the required quantity of a row under base + factor x
   * per_load, as a function of the factor.
   *
   * @param per_load null, if only the factor 0 will be asked for.
   * @param quality of the state, to which that of further solves is added.
   */
  virtual std::function<CuttingStress(double)>
  evaluate(YieldingBody<dim> &body,
           const unsigned int row,
           const LinearResponse &base,
           const LinearResponse *per_load,
           SolveQuality &quality) const = 0;

  /**
   * The driving quantity of a row from a recovered stress; 0 of a criterion
   * that does not depend on the stress there.
   *
   * @param displacement with ghosts.
   */
  virtual double
  reached_by(const YieldingBody<dim> &body,
             const unsigned int row,
             const LA::Vector &displacement,
             const RecoveredStress<dim> &recovered) const = 0;

  /** The least that a row of the body may require. */
  virtual double
  smallest_requirement() const = 0;
};
} // namespace Setsudan
