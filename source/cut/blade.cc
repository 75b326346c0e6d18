#include <setsudan/body/nodes.h>
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
  parameters.require(
    direction.norm() > 0, "Blade", "Direction", "a vector that is not zero");
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



template <int dim>
double
BladeParameters<dim>::total_force() const
{
  double sum = 0;
  for (const auto &load : edge_loads)
    sum += load.force;
  return sum;
}



template <int dim>
BladeEdge<dim>::BladeEdge(const Tensor<1, dim> &normal,
                          const Tensor<1, dim> &direction)
{
  if constexpr (dim == 3)
    {
      tangent = cross_product_3d(normal, direction);
      tangent /= tangent.norm();
      for (unsigned int d = 1; d < dim; ++d)
        // The first of equally near axes, whatever the round-off.
        if (std::abs(tangent[d]) > std::abs(tangent[axis]) + 1e-12)
          axis = d;
      if (tangent[axis] < 0)
        tangent = -tangent;
    }
}



template <int dim>
double
BladeEdge<dim>::position(const Point<dim> &point) const
{
  return dim == 2 ? 0. : point[axis];
}



template <int dim>
Point<dim>
BladeEdge<dim>::point(const Point<dim> &origin, const double position) const
{
  if (dim == 2)
    return origin;
  return origin + (position - origin[axis]) / tangent[axis] * tangent;
}



std::vector<NodeShare>
share_edge_loads(const std::vector<EdgeLoad> &loads,
                 const std::vector<double> &nodes)
{
  Assert(std::is_sorted(nodes.begin(), nodes.end()), ExcInternalError());
  std::vector<NodeShare> shares;
  for (const auto &load : loads)
    {
      const unsigned int after =
        std::lower_bound(nodes.begin(), nodes.end(), load.position) -
        nodes.begin();
      if (after == 0)
        shares.push_back({0, load.force});
      else if (after == nodes.size())
        shares.push_back({after - 1, load.force});
      else
        {
          const double lever = (load.position - nodes[after - 1]) /
                               (nodes[after] - nodes[after - 1]);
          shares.push_back({after - 1, (1 - lever) * load.force});
          shares.push_back({after, lever * load.force});
        }
    }
  return shares;
}



template <int dim>
void
check_blade(const Parameters &parameters,
            const BladeParameters<dim> &blade,
            const Body<dim> &body,
            const Supports<dim> &supports,
            const CutSurface<dim> &surface)
{
  const Tensor<1, dim> &normal = surface.front().normal;
  // An angle of a millionth is a direction that was written with six digits.
  parameters.require(std::abs(blade.direction * normal) < 1e-6,
                     "Blade",
                     "Direction",
                     "a direction in the plane of every cut");

  // The nodes of the cut, by how far the blade has to go to them.
  const BladeEdge<dim> edge(normal, blade.direction);
  struct Node
  {
    double depth;
    double position;
    bool fixed;
  };
  std::vector<Node> nodes;
  for (const auto &face : surface)
    for (unsigned int node = 0; node < n_element_nodes<dim>; ++node)
      if (node_is_on_face<dim>(node, face.plus.second))
        {
          const auto point = body.mesh.node_position(face.plus.first, node);
          nodes.push_back({blade.direction * Tensor<1, dim>(point),
                           edge.position(point),
                           supports.is_fixed(face.plus.first, node)});
        }
  const double tolerance = 1e-8 * body.mesh.extent();
  const auto by          = [](const auto member) {
    return
      [member](const Node &a, const Node &b) { return a.*member < b.*member; };
  };
  const double entry =
    std::min_element(nodes.begin(), nodes.end(), by(&Node::depth))->depth;
  nodes.erase(std::remove_if(nodes.begin(),
                             nodes.end(),
                             [&](const Node &node) {
                               return node.depth > entry + tolerance;
                             }),
              nodes.end());
  parameters.require(std::any_of(nodes.begin(),
                                 nodes.end(),
                                 [](const Node &node) { return !node.fixed; }),
                     "Blade",
                     "Direction",
                     "a direction into the body from a side that is not fixed");

  const auto ends =
    std::minmax_element(nodes.begin(), nodes.end(), by(&Node::position));
  for (const auto &load : blade.edge_loads)
    parameters.require(load.position >= ends.first->position - tolerance &&
                         load.position <= ends.second->position + tolerance,
                       "Blade",
                       "Edge loads",
                       dim == 2 ? "a force at position 0"
                                : "forces at positions from " +
                                    short_text(ends.first->position) + " to " +
                                    short_text(ends.second->position) +
                                    ", where the edge meets the body");
}



template struct BladeParameters<2>;
template struct BladeParameters<3>;
template struct BladeEdge<2>;
template struct BladeEdge<3>;
template void
check_blade(const Parameters &,
            const BladeParameters<2> &,
            const Body<2> &,
            const Supports<2> &,
            const CutSurface<2> &);
template void
check_blade(const Parameters &,
            const BladeParameters<3> &,
            const Body<3> &,
            const Supports<3> &,
            const CutSurface<3> &);
} // namespace Setsudan
