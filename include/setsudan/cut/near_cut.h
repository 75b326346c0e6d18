#pragma once

#include <setsudan/body/body.h>
#include <setsudan/cut/cut_parameters.h>
#include <setsudan/elasticity/refinement.h>

namespace Setsudan
{
/**
 * How the body is to be refined: everywhere by `global_levels`, and near its
 * cuts as the scene asks for. All cells that touch a cut are refined alike, so
 * that the nodes of its two sides match and none of them hangs.
 */
template <int dim>
Refinement
refine_near_cuts(const Body<dim> &body,
                 const CutParameters<dim> &cut,
                 const unsigned int global_levels,
                 const MPI_Comm communicator);
} // namespace Setsudan
