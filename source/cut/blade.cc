#include <setsudan/cut/blade.h>
#include <setsudan/parameters/lists.h>

#include <algorithm>
#include <cmath>

namespace Setsudan
{
using namespace dealii;

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
  Setsudan::declare(handler,
                    "Blade",
                    "Thickness",
                    "0.2",
                    Patterns::Double(),
                    "How far the blade moves the two sides of the cut apart, "
                    "at least 0 [length].");
  Setsudan::declare(handler,
                    "Blade",
                    "Direction",
                    dim == 3 ? "0, 0, -1" : "0, -1",
                    Patterns::List(Patterns::Double(), dim, dim),
                    "The way of the blade, in the plane of the cut [-].");
  Setsudan::declare(handler,
                    "Blade",
                    "Edge loads",
                    "",
                    Patterns::Anything(),
                    dim == 3
                      ? "The blade's forces along Direction, as 'position : "
                        "force', separated by commas; the position is the "
                        "coordinate along the edge [length : force]."
                      : "The blade's force along Direction, as '0 : force': in "
                        "2D the edge is a point [- : force/thickness].");
}



template <int dim>
BladeParameters<dim>::BladeParameters(const Parameters &parameters)
  : sharpness(parameters.number("Blade", "Sharpness"))
  , thickness(parameters.number("Blade", "Thickness"))
{
  parameters.require(sharpness >= 0 && sharpness <= 1,
                     "Blade",
                     "Sharpness",
                     "a number from 0 to 1");
  parameters.require(
    thickness >= 0, "Blade", "Thickness", "a number that is not negative");
  const auto components = parameters.numbers("Blade", "Direction", dim);
  for (unsigned int d = 0; d < dim; ++d)
    direction[d] = components[d];
  double largest = 0;
  for (unsigned int d = 0; d < dim; ++d)
    largest = std::max(largest, std::abs(direction[d]));
  parameters.require(
    largest > 0, "Blade", "Direction", "a vector that is not zero");
  // First by the largest component, whose square may be too large or small.
  direction /= largest;
  direction /= direction.norm();

  for (const auto &[position, force] :
       split_items(parameters.text("Blade", "Edge loads"), ','))
    {
      std::vector<double> s, f;
      parameters.require(parse_numbers(position, s) && s.size() == 1 &&
                           parse_numbers(force, f) && f.size() == 1 &&
                           std::isfinite(s[0]) && std::isfinite(f[0]),
                         "Blade",
                         "Edge loads",
                         "a list of 'position : force'");
      edge_loads.push_back({s[0], f[0]});
    }
}



template struct BladeParameters<2>;
template struct BladeParameters<3>;
} // namespace Setsudan
