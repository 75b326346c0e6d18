// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <setsudan/output/output_directory.h>
#include <setsudan/output/pieces/nodal_problem.h>

#include <string>

namespace Setsudan
{
/**
 * Write a solved problem as `name`.inp, a complete input deck for CalculiX
 * (ccx 2.20) with elements C3D20, in 2D CPE8, and what Setsudan has found as
 * `name`.csv, a line for each node of the deck. Supports become *BOUNDARY;
 * ties, openings and hanging nodes *EQUATION. With finite strain the step is
 * one of NLGEOM, from the body at rest. Every material must have a
 * calculix_material().
 */
template <int dim>
void
write_calculix_deck(const NodalProblem<dim> &problem,
                    const OutputDirectory &directory,
                    const std::string &name);
} // namespace Setsudan
