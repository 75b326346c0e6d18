#include <setsudan/body/nodes.h>
#include <setsudan/cut/blade_edge.h>
#include <setsudan/parameters/lists.h>

#include <algorithm>
#include <cmath>

namespace Setsudan
{
using namespace dealii;

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



namespace
{
/** Share a force equally among the nodes of one position on the edge: where an
 * earlier cut crosses, there is one on each side of it. */
void
share_equally(const double force,
              const unsigned int node,
              const std::vector<double> &nodes,
              std::vector<NodeShare> &shares)
{
  const double tolerance = 1e-10 * (nodes.back() - nodes.front());
  const auto begin =
    std::lower_bound(nodes.begin(), nodes.end(), nodes[node] - tolerance);
  const auto end =
    std::upper_bound(begin, nodes.end(), nodes[node] + tolerance);
  for (auto it = begin; it != end; ++it)
    shares.push_back({static_cast<unsigned int>(it - nodes.begin()),
                      force / static_cast<double>(end - begin)});
}
} // namespace



std::vector<NodeShare>
share_edge_loads(const std::vector<EdgeLoad> &loads,
                 const std::vector<double> &nodes)
{
  Assert(std::is_sorted(nodes.begin(), nodes.end()), ExcInternalError());
  std::vector<NodeShare> shares;
  for (const auto &[position, force] : loads)
    {
      const unsigned int after =
        std::lower_bound(nodes.begin(), nodes.end(), position) - nodes.begin();
      if (after == 0 || after == nodes.size())
        {
          share_equally(force, after == 0 ? 0 : after - 1, nodes, shares);
          continue;
        }
      const double lever =
        (position - nodes[after - 1]) / (nodes[after] - nodes[after - 1]);
      if (lever < 1)
        share_equally((1 - lever) * force, after - 1, nodes, shares);
      share_equally(lever * force, after, nodes, shares);
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
