#pragma once

#include <setsudan/simulation/cut_body.h>

#include <functional>

namespace Setsudan
{
/** How the body answers to forces: a solved displacement with what belongs to
 * it. Answers can be superposed. */
template <int dim>
struct Response
{
  LA::Vector displacement;
  /** All nodal forces. */
  LA::Vector forces;
  /** See AssembledSolver::solve(). */
  LA::Vector prescribed;
};

/**
 * What the scene's criterion makes of a row under base + factor x per_load, as
 * a function of the factor. With the criterion `energy release` the body is
 * solved without the row's ties for that; its seam must have been made.
 *
 * @param per_load nothing, if only the factor 0 will be asked for.
 * @param quality  of the state, to which that of further solves is added.
 */
template <int dim>
std::function<CuttingStress(double)>
judge_row(const Scene<dim> &scene,
          CutBody<dim> &body,
          const unsigned int row,
          const Response<dim> &base,
          const Response<dim> *per_load,
          SolveQuality &quality);

/** The least that a row of the body may require. */
template <int dim>
double
smallest_requirement(const Scene<dim> &scene);
} // namespace Setsudan
