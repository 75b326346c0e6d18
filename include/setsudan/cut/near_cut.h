#pragma once

#include <setsudan/body/body.h>
#include <setsudan/cut/cut_parameters.h>
#include <setsudan/elasticity/refinement.h>

namespace Setsudan
{
/**
 * How the body is to be refined: everywhere by `global_levels`, and near its
 * cuts as the scene asks for. Both sides of every cut are refined alike, so
 * that their nodes match when they are separated.
 */
template <int dim>
Refinement
refine_near_cuts(const Body<dim> &body,
                 const CutParameters<dim> &cut,
                 const unsigned int global_levels,
                 const MPI_Comm communicator);
} // namespace Setsudan
