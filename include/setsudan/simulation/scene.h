// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <setsudan/blade/blade.h>
#include <setsudan/body/body_parameters.h>
#include <setsudan/body/supports.h>
#include <setsudan/contact/board.h>
#include <setsudan/cut/seam/rows.h>
#include <setsudan/cut/surface/cut_parameters.h>
#include <setsudan/cut/yield/yield_criterion.h>
#include <setsudan/material/material_parameters.h>
#include <setsudan/material/rate_law.h>
#include <setsudan/mechanics/loads.h>
#include <setsudan/output/output_directory.h>
#include <setsudan/simulation/accuracy/accuracy_parameters.h>
#include <setsudan/simulation/time_parameters.h>
#include <setsudan/solver/solver_parameters.h>

#include <memory>
#include <string>
#include <vector>

namespace Setsudan
{
/** The dimension that a scene file asks for: 2 or 3.
 *
 * @throw SceneError where it asks for another. */
unsigned int
scene_dimension(const std::vector<SceneEntry> &entries);

/** All parameters as the text of a scene file in `directory`: the body's file,
 * if it has one, is named as it is found from there. */
std::string
text_in(const std::string &directory, const Parameters &parameters);

/** Everything a run needs to know: the parameters of all rooms, checked one by
 * one and against each other. */
template <int dim>
struct Scene
{
  static void
  declare(dealii::ParameterHandler &handler);

  /** @throw SceneError for what is not possible. */
  explicit Scene(const Parameters &parameters);

  /** Whether the walls of a cut touch the blade and each other by contact. */
  bool
  has_contact() const
  {
    return blade.travels ||
           division.split_rows == DivisionParameters::SplitRows::wedged;
  }

  /** Whether the time matters in which the body is deformed, and is known. */
  bool
  has_time() const
  {
    return time.passes() || (material.is_viscous() && blade.path.has_times());
  }

  /** Whether the nodes of a cut are duplicated before its first row is asked
   * whether it yields. */
  bool
  needs_seam() const
  {
    return yield.compares_energies() || has_contact();
  }

  const std::string length_unit;
  const std::string force_unit;
  const BodyParameters<dim> body_parameters;
  const Body<dim> body;
  const Supports<dim> supports;
  const LoadParameters<dim> loads;
  const RateLaw rate;
  const TimeParameters time;
  const BladeParameters<dim> blade;
  /** As the blade finds it. Not const: a program of one's own may give a
   * material another law. */
  MaterialParameters<dim> material;
  const CutParameters<dim> cut;
  const BoardParameters<dim> board;
  const YieldParameters yield;
  const std::unique_ptr<const YieldCriterion<dim>> criterion;
  const DivisionParameters division;
  const AccuracyParameters accuracy;
  const SolverParameters solver;
  const OutputParameters output;
};
} // namespace Setsudan
