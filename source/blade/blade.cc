// SPDX-License-Identifier: LGPL-2.1-or-later
#include <setsudan/blade/blade.h>
#include <setsudan/parameters/lists.h>

#include <algorithm>
#include <cmath>

#include <limits>

namespace Setsudan
{
using namespace dealii;

namespace
{
void
declare_body(ParameterHandler &handler)
{
  Setsudan::declare(handler,
                    "Blade",
                    "Shape",
                    "line",
                    Patterns::Selection("line|wedge|wire|profile"),
                    "line: the blade has no body; wedge: two flanks and a "
                    "shank of Thickness; wire: a circle, Thickness its "
                    "diameter; profile: as Profile has it. All but line with "
                    "Drive = travel.");
  Setsudan::declare(handler,
                    "Blade",
                    "Wedge angle",
                    "20",
                    Patterns::Double(),
                    "Between the flanks, more than 0 and less than 180 "
                    "[degrees].");
  Setsudan::declare(handler,
                    "Blade",
                    "Shoulder radius",
                    "0",
                    Patterns::Double(),
                    "With which the flanks turn into the shank; at 0 a wall "
                    "springs back there, and its energy is lost [length].");
  Setsudan::declare(
    handler,
    "Blade",
    "Height",
    "0",
    Patterns::Double(),
    "Of a wedge or a profile, from the edge to its back, behind "
    "which the walls may close again; 0: without an end "
    "[length].");
  Setsudan::declare(handler,
                    "Blade",
                    "Profile",
                    "",
                    Patterns::Anything(),
                    "Of Shape = profile, as 'distance behind the edge : half "
                    "thickness', separated by commas and beginning with 0 : 0; "
                    "behind the last one is a shank, and Thickness is not read "
                    "[length : length].");
  Setsudan::declare(handler,
                    "Blade",
                    "Guide",
                    "fixed",
                    Patterns::Selection("fixed|free"),
                    "fixed: the blade keeps to the middle of the cut; free: it "
                    "shifts sideways until the walls press on both flanks "
                    "alike.");
}



void
declare_sliding(ParameterHandler &handler)
{
  Setsudan::declare(handler,
                    "Blade",
                    "Friction",
                    "0",
                    Patterns::Double(),
                    "Coulomb's coefficient between the flanks and the walls of "
                    "the cut, at least 0 [-].");
  Setsudan::declare(handler,
                    "Blade",
                    "Adhesion",
                    "0",
                    Patterns::Double(),
                    "Shear strength of the contact between the flanks and the "
                    "walls, beside Friction and whatever the pressure, at "
                    "least 0 [force/length^2].");
  Setsudan::declare(
    handler,
    "Blade",
    "Slice-push ratio",
    "0",
    Patterns::Double(),
    "How far the blade moves along its edge for each length that "
    "it is pushed, at least 0 [-].");
  Setsudan::declare(
    handler,
    "Blade",
    "Edge grip",
    "",
    Patterns::Anything(),
    "The friction with which the edge drags the front along as it "
    "slices; empty: it drags it all the way [-].");
}



void
declare_advance(ParameterHandler &handler)
{
  Setsudan::declare(handler,
                    "Blade",
                    "Advance",
                    "0",
                    Patterns::Double(),
                    "The longest step of Drive = travel in a body that is not "
                    "linear, which needs steps; 0: half of the shallowest row "
                    "[length].");
  Setsudan::declare(handler,
                    "Blade",
                    "Advance tolerance",
                    "1e-4",
                    Patterns::Double(),
                    "By how much of what is required a split may exceed that "
                    "then, from 1e-10 to 0.1 [-].");
}
} // namespace


template <int dim>
void
BladeParameters<dim>::declare(ParameterHandler &handler)
{
  Setsudan::declare(handler,
                    "Blade",
                    "Sharpness",
                    "0.5",
                    Patterns::Double(),
                    "From 0 (the whole shear limit is required) to 1 (the "
                    "blade needs no force) [-].");
  Setsudan::declare(
    handler,
    "Blade",
    "Edge points",
    "",
    Patterns::Anything(),
    "An edge that is inclined or curved, in 3D: 'position : how "
    "far behind the foremost point', ascending, as '0 : 0, 10 : "
    "2'; positions are coordinates along the axis nearest to "
    "the edge. Empty: straight across the way [length].");
  Setsudan::declare(handler,
                    "Blade",
                    "Edge radius",
                    "0",
                    Patterns::Double(),
                    "Of a measured edge, in place of Sharpness, which is 0 "
                    "then: the material yields over the edge's width, which "
                    "adds 2 r (1 + friction) times twice Material/Shear limit "
                    "to the toughness [length].");
  Setsudan::declare(handler,
                    "Blade",
                    "Thickness",
                    "0.2",
                    Patterns::Double(),
                    "How far the blade moves the two sides of the cut apart, "
                    "at least 0 [length].");
  Setsudan::declare(
    handler,
    "Blade",
    "Drive",
    "force",
    Patterns::Selection("force|travel"),
    "force: Edge loads act on the front; travel: the edge moves "
    "along Direction, and the force is the reaction.");
  declare_body(handler);
  declare_sliding(handler);
  declare_advance(handler);
  BladePath::declare(handler);
  Setsudan::declare(handler,
                    "Blade",
                    "Direction",
                    dim == 3 ? "0, 0, -1" : "0, -1",
                    Patterns::Anything(),
                    "The way of the blade; it is projected into the cut. One "
                    "for all cuts, or one for each, separated by ';' [-].");
  Setsudan::declare(handler,
                    "Blade",
                    "Edge loads",
                    "",
                    Patterns::Anything(),
                    dim == 3
                      ? "The blade's forces along Direction, as 'position : "
                        "force', separated by commas; the position is the "
                        "coordinate of the axis nearest to the edge, or the "
                        "length along the edge of a cut that no axis follows. "
                        "'uniform : force' spreads a force evenly over the "
                        "front, by itself or beside others. "
                        "One list for all cuts, or one for each, separated by "
                        "';' [length : force]."
                      : "The blade's force along Direction, as '0 : force' or "
                        "'uniform : force': in 2D the edge is a point "
                        "[- : force/thickness].");
}



namespace
{
template <int dim>
Tensor<1, dim>
read_direction(const Parameters &parameters, const std::string &text)
{
  std::vector<double> components;
  parameters.require(parse_numbers(text, components) &&
                       components.size() == dim,
                     "Blade",
                     "Direction",
                     std::to_string(dim) +
                       " numbers separated by commas, for each cut or for all "
                       "(separated by ';')");
  Tensor<1, dim> direction;
  double largest = 0;
  for (unsigned int d = 0; d < dim; ++d)
    {
      direction[d] = components[d];
      largest      = std::max(largest, std::abs(direction[d]));
    }
  parameters.require(
    largest > 0, "Blade", "Direction", "a vector that is not zero");
  // First by the largest component, whose square may be too large or small.
  direction /= largest;
  return direction / direction.norm();
}

EdgeLoads
read_edge_loads(const Parameters &parameters, const std::string &text)
{
  EdgeLoads loads;
  for (const auto &[position, force] : split_items(text, ','))
    {
      const bool is_uniform = position == "uniform";
      std::vector<double> s, f;
      parameters.require(
        (is_uniform || (parse_numbers(position, s) && s.size() == 1)) &&
          parse_numbers(force, f) && f.size() == 1,
        "Blade",
        "Edge loads",
        "a list of 'position : force' and 'uniform : force'");
      if (is_uniform)
        loads.uniform += f[0];
      else
        loads.points.push_back({s[0], f[0]});
    }
  return loads;
}
} // namespace


template <int dim>
BladeParameters<dim>::BladeParameters(const Parameters &parameters)
  : sharpness(parameters.number("Blade", "Sharpness"))
  , edge_radius(parameters.number("Blade", "Edge radius"))
  , thickness(parameters.number("Blade", "Thickness"))
  , travels(parameters.text("Blade", "Drive") == "travel")
  , path(parameters, travels)
  , advance(parameters.number("Blade", "Advance"))
  , advance_tolerance(parameters.number("Blade", "Advance tolerance"))
{
  read_sliding(parameters);
  read_shape(parameters);
  read_edge_points(parameters);
  parameters.require(
    advance >= 0, "Blade", "Advance", "a number that is not negative");
  parameters.require(advance_tolerance >= 1e-10 && advance_tolerance <= 0.1,
                     "Blade",
                     "Advance tolerance",
                     "a number from 1e-10 to 0.1");
  parameters.require(sharpness >= 0 && sharpness <= 1,
                     "Blade",
                     "Sharpness",
                     "a number from 0 to 1");
  parameters.require(
    edge_radius >= 0, "Blade", "Edge radius", "a number that is not negative");
  parameters.require(edge_radius == 0 || sharpness == 0,
                     "Blade",
                     "Sharpness",
                     "0 where Blade/Edge radius says how sharp the blade is");
  parameters.require(
    thickness >= 0, "Blade", "Thickness", "a number that is not negative");
  for (const auto &text : split(parameters.text("Blade", "Direction"), ';'))
    directions.push_back(read_direction<dim>(parameters, text));
  parameters.require(!directions.empty(),
                     "Blade",
                     "Direction",
                     std::to_string(dim) + " numbers separated by commas");
  for (const auto &text : split(parameters.text("Blade", "Edge loads"), ';'))
    edge_loads.push_back(read_edge_loads(parameters, text));
  if (edge_loads.empty())
    edge_loads.emplace_back();
}



template <int dim>
void
BladeParameters<dim>::read_sliding(const Parameters &parameters)
{
  const auto read = [&](const std::string &name) {
    const double value = parameters.number("Blade", name);
    parameters.require(
      value >= 0, "Blade", name, "a number that is not negative");
    parameters.require(
      travels || value == 0, "Blade", name, "0 where Blade/Drive is force");
    return value;
  };
  sliding.friction = read("Friction");
  sliding.adhesion = read("Adhesion");
  sliding.slice    = read("Slice-push ratio");
  parameters.require(dim == 3 || sliding.slice == 0,
                     "Blade",
                     "Slice-push ratio",
                     "0 in 2D, where the edge is a point");
  parameters.require(sliding.slice == 0 || !path.turns(),
                     "Blade",
                     "Travel",
                     "positions that ascend where Blade/Slice-push ratio is "
                     "more than 0: a blade that slices is not withdrawn");
  parameters.require(sliding.slice == 0 || sliding.adhesion == 0,
                     "Blade",
                     "Adhesion",
                     "0 where Blade/Slice-push ratio is more than 0");
  sliding.grip = parameters.text("Blade", "Edge grip").empty()
                   ? sliding.slice
                   : parameters.numbers("Blade", "Edge grip", 1)[0];
  parameters.require(sliding.grip >= 0,
                     "Blade",
                     "Edge grip",
                     "a number that is not negative, or nothing");
}



template struct BladeParameters<2>;
template struct BladeParameters<3>;
} // namespace Setsudan
