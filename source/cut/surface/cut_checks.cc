// SPDX-License-Identifier: LGPL-2.1-or-later
#include <setsudan/body/joints.h>
#include <setsudan/cut/surface/cut_checks.h>
#include <setsudan/cut/surface/mesh_surgery.h>
#include <setsudan/mesh/geometry.h>
#include <setsudan/parameters/lists.h>

#include <algorithm>
#include <cmath>

namespace Setsudan
{
using namespace dealii;

template <int dim>
void
check_surface(const Parameters &parameters,
              const Body<dim> &body,
              const std::string &text,
              const CutSurface<dim> &surface)
{
  const auto require = [&](const bool condition, const std::string &what) {
    parameters.require(condition, "Cut", "Surfaces", what);
  };
  if (surface.empty())
    {
      std::string why;
      for (const auto &joint : describe_joints(body, find_joints(body)))
        why += " " + joint;
      require(false,
              "surfaces that pass between elements of the body, and '" + text +
                "' touches no face of an element inside the body." + why);
    }
  const auto branchings = find_branchings(body, surface);
  require(branchings.empty(),
          "surfaces with two sides, and '" + text +
            "' meets itself wrongly: more than two of its element faces share "
            "a line at " +
            (branchings.empty() ? "" : text_of(branchings.front())) +
            "; a smoother surface, or a mesh that follows it, does not");
  require(split_mesh(body.mesh, surface).vertices.size() >
            body.mesh.vertices.size(),
          "surfaces that divide something, and along '" + text +
            "' every node stays joined around the end of the cut; a slit must "
            "be two elements long or reach the boundary");
}



namespace
{
/** A node of a cut, as the blade meets it. */
struct CutNode
{
  double travel;
  double position;
  bool held;
};

template <int dim>
std::vector<CutNode>
nodes_of_cut(const Body<dim> &body,
             const Supports<dim> &supports,
             const Cut<dim> &cut)
{
  std::vector<CutNode> nodes;
  for (const auto &face : cut.surface.faces)
    for (unsigned int node = 0; node < n_element_nodes<dim>; ++node)
      if (node_is_on_face<dim>(node, face.plus.second))
        {
          const auto point = body.mesh.node_position(face.plus.first, node);
          nodes.push_back(
            {cut.edge.travel(point),
             cut.edge.position(point),
             supports.at(face.plus.first, unit_point_of_node<dim>(node))
               .components.all()});
        }
  return nodes;
}
} // namespace


template <int dim>
void
check_blade(const Parameters &parameters,
            const Body<dim> &body,
            const Supports<dim> &supports,
            const Cut<dim> &cut)
{
  if (const auto &points = cut.edge.points; !points.empty())
    for (const auto &node : nodes_of_cut(body, supports, cut))
      parameters.require(node.position >= points.front().position - 1e-9 &&
                           node.position <= points.back().position + 1e-9,
                         "Blade",
                         "Edge points",
                         "points that reach over the whole cut, and '" +
                           cut.text + "' has a node at " +
                           short_text(node.position));
  // 45 degrees themselves are allowed, whatever round-off makes of them.
  const double off =
    std::max(cut.edge.projection_angle, cut.edge.angle_to_faces);
  parameters.require(
    off <= 45 + 1e-6,
    "Blade",
    "Direction",
    "a direction along the cut, or up to 45 degrees off it; that of '" +
      cut.text + "' is " + short_text(std::ceil(100 * off - 1e-4) / 100) +
      " degrees off");

  const auto nodes       = nodes_of_cut(body, supports, cut);
  const double tolerance = 1e-8 * body.mesh.extent();
  const auto by          = [](const auto member) {
    return [member](const CutNode &a, const CutNode &b) {
      return a.*member < b.*member;
    };
  };
  const double entry =
    std::min_element(nodes.begin(), nodes.end(), by(&CutNode::travel))->travel;
  parameters.require(std::any_of(nodes.begin(),
                                 nodes.end(),
                                 [&](const CutNode &node) {
                                   return node.travel <= entry + tolerance &&
                                          !node.held;
                                 }),
                     "Blade",
                     "Direction",
                     "a direction into the body from a side that is not fixed");

  // Along a closed surface positions are lengths, which nothing limits yet.
  if (!cut.edge.is_planar)
    return;
  const auto ends =
    std::minmax_element(nodes.begin(), nodes.end(), by(&CutNode::position));
  for (const auto &load : cut.edge_loads.points)
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



template void
check_surface(const Parameters &,
              const Body<2> &,
              const std::string &,
              const CutSurface<2> &);
template void
check_surface(const Parameters &,
              const Body<3> &,
              const std::string &,
              const CutSurface<3> &);
template void
check_blade(const Parameters &,
            const Body<2> &,
            const Supports<2> &,
            const Cut<2> &);
template void
check_blade(const Parameters &,
            const Body<3> &,
            const Supports<3> &,
            const Cut<3> &);
} // namespace Setsudan
