// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <setsudan/output/tables/statistics.h>
#include <setsudan/simulation/state.h>

#include <optional>
#include <string>
#include <vector>

// What a run says on the way, in words.

namespace Setsudan
{
/** The body's size, and the solver that is chosen for it. */
template <int dim>
std::string
describe_body(const CutBody<dim> &body);

/** Where the body touches itself without being joined, unless the scene allows
 * that. */
template <int dim>
std::vector<std::string>
describe_open_joints(const Scene<dim> &scene);

/** The newest cut. */
template <int dim>
std::string
describe_cut(const CutBody<dim> &body, const unsigned int cut);

/** What a blunt edge adds to the toughness; nothing where it is not given. */
template <int dim>
std::optional<std::string>
describe_edge(const Scene<dim> &scene);

/** Whether elements are too large to tell the force of a blade that travels at
 * every moment; nothing where they are not. */
template <int dim>
std::optional<std::string>
describe_resolution(const CutBody<dim> &body);

/** How badly the elements follow the surface of a cut, and what to change. */
template <int dim>
std::string
describe_roughness(const Cut<dim> &cut);

/** How the rows of the newest cut will be solved, and why. */
template <int dim>
std::string
describe_solve(const CutBody<dim> &body);

/** With which laws a body that is not linear deforms, and why; nothing where it
 * always is. */
template <int dim>
std::optional<std::string>
describe_strain(const MaterialParameters<dim> &materials);

/** What to be wary of where laws remember and time passes, or does not. */
template <int dim>
std::vector<std::string>
warn_of_memory(const Scene<dim> &scene);

/** Which state makes a body take finite strain. */
template <int dim>
std::string
describe_change_of_strain(const MaterialParameters<dim> &materials,
                          const Event &event);

/** Where a run ends since a body has no stable equilibrium.
 *
 * @param reason a sentence of the solver. */
template <int dim>
std::string
describe_instability(const CutBody<dim> &body,
                     const Event &event,
                     const std::string &reason);

/** Where the cut stands still, what was reached, and what would let it go on.
 */
template <int dim>
std::string
describe_arrest(const Scene<dim> &scene,
                const Event &event,
                const unsigned int n_rows);

/** What a blade that came through the cut has left out of its path. */
template <int dim>
std::optional<std::string>
describe_path_left_out(const Scene<dim> &scene, const State<dim> &state);

/** Of a blade that presses across the cut only, what the supports miss of its
 * force. */
std::optional<std::string>
describe_unfelt_work(const BladeMotion &motion);

/** The pieces that have lost their support, besides those `known` before. */
template <int dim>
std::vector<std::string>
describe_loose_pieces(const CutBody<dim> &body,
                      const std::vector<FloatingPiece> &known);
} // namespace Setsudan
