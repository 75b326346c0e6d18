// SPDX-License-Identifier: LGPL-2.1-or-later
#include <deal.II/base/quadrature_lib.h>

#include <setsudan/body/group_of_word.h>
#include <setsudan/body/node_of_word.h>
#include <setsudan/body/support_parameters.h>
#include <setsudan/parameters/lists.h>

#include <algorithm>

namespace Setsudan
{
using namespace dealii;

template <int dim>
void
SupportParameters<dim>::declare(ParameterHandler &handler)
{
  const auto declare_text = [&](const std::string &name,
                                const std::string &documentation) {
    Setsudan::declare(
      handler, "Support", name, "", Patterns::Anything(), documentation);
  };
  declare_text("Fixed faces",
               "Faces or other groups whose nodes are held in all directions, "
               "separated by commas. A box has left, right (x min, max), "
               "front, back (y), bottom, top (z; in 2D y); a file has its "
               "physical groups, by name or number.");
  declare_text("Fixed components",
               "Groups that are held in some directions, as 'group : "
               "components', separated by ';', such as 'back : y; outer : "
               "xy'.");
  declare_text("Fixed boxes",
               std::string("All nodes within a box in space, up to a millionth "
                           "of their element, as '") +
                 (dim == 3 ? "x0, y0, z0, x1, y1, z1 : components'"
                           : "x0, y0, x1, y1 : components'") +
                 ", separated by ';' [length].");
  Setsudan::declare(handler,
                    "Support",
                    "Fixed nodes",
                    "",
                    Patterns::List(Patterns::Integer(0)),
                    "Numbers of nodes that are held in all directions: of a "
                    "box as in the paper (x fastest, then y, then z, from 0), "
                    "of a file its own.");
  declare_text("Displacements",
               std::string("Groups that a clamp moves, as 'group : ") +
                 (dim == 3 ? "ux, uy, uz" : "ux, uy") +
                 "', separated by ';'; 'free' stands for a direction in which "
                 "the clamp does not hold [length].");
  Setsudan::declare(handler,
                    "Support",
                    "Loose pieces",
                    "hold",
                    Patterns::Selection("hold|drop"),
                    "What becomes of a piece that has lost its support. hold: "
                    "it is held by the fewest constraints, if its loads are "
                    "in equilibrium; drop: it is left out from then on.");
}



namespace
{
/** The components that a word like "xz" names; none where it is wrong. */
template <int dim>
std::bitset<dim>
parse_components(const std::string &word)
{
  std::bitset<dim> components;
  for (const char axis : word)
    {
      const auto c = std::string("xyz").substr(0, dim).find(axis);
      if (c == std::string::npos || components[c])
        return {};
      components[c] = true;
    }
  return components;
}

template <int dim>
const std::string axes = dim == 3 ? "x, y and z" : "x and y";

template <int dim>
Region<dim>
region_of_word(const Parameters &parameters,
               const std::string &name,
               const Body<dim> &body,
               const std::string &word)
{
  return Region<dim>(
    body,
    {&find_group_or_reject(
      parameters, "Support", name, body, word, GroupKind::faces_or_nodes)});
}

/** Whether a region holds any node of the body, whose elements are halved so
 * often. */
template <int dim>
bool
holds_nodes(const Region<dim> &region,
            const Body<dim> &body,
            const unsigned int n_halvings)
{
  // Of the finest elements the middles of faces are no nodes, which is no
  // matter here; finer ones than these are not looked at.
  constexpr unsigned int most = 3;
  const QIterated<dim> grid(QTrapezoid<1>(),
                            (body.has_middle_nodes ? 2 : 1)
                              << std::min(n_halvings, most));
  for (unsigned int cell = 0; cell < body.mesh.cells.size(); ++cell)
    for (const auto &point : grid.get_points())
      if (region.contains(body, cell, point))
        return true;
  return n_halvings > most;
}
} // namespace
template <int dim>
SupportParameters<dim>::SupportParameters(const Parameters &parameters,
                                          const Body<dim> &body)
  : floating_pieces(parameters.text("Support", "Loose pieces") == "hold"
                      ? LoosePieces::hold
                      : LoosePieces::drop)
{
  // What moves comes first: see Supports::find_contradiction().
  read_displacements(parameters, body);
  read_groups(parameters, body);
  read_boxes(parameters, body);
  std::set<unsigned int> nodes;
  for (const auto &word : split(parameters.text("Support", "Fixed nodes"), ','))
    nodes.insert(
      node_of_word(parameters, "Support", "Fixed nodes", body, word));
  if (!nodes.empty())
    supports.push_back(
      {Region<dim>(nodes),
       std::bitset<dim>().set(),
       {},
       "Fixed nodes = " + parameters.text("Support", "Fixed nodes")});
}



template <int dim>
void
SupportParameters<dim>::read_groups(const Parameters &parameters,
                                    const Body<dim> &body)
{
  for (const auto &word : split(parameters.text("Support", "Fixed faces"), ','))
    supports.push_back({region_of_word(parameters, "Fixed faces", body, word),
                        std::bitset<dim>().set(),
                        {},
                        "Fixed faces = " + word});
  for (const auto &[word, text] :
       split_items(parameters.text("Support", "Fixed components"), ';'))
    {
      const auto components = parse_components<dim>(text);
      parameters.require(components.any(),
                         "Support",
                         "Fixed components",
                         "'group : components' with components of " +
                           axes<dim> + ", separated by ';'");
      supports.push_back(
        {region_of_word(parameters, "Fixed components", body, word),
         components,
         {},
         "Fixed components = " + word});
    }
}



template <int dim>
void
SupportParameters<dim>::read_boxes(const Parameters &parameters,
                                   const Body<dim> &body)
{
  for (const auto &[corners, text] :
       split_items(parameters.text("Support", "Fixed boxes"), ';'))
    {
      const auto components = parse_components<dim>(text);
      std::vector<double> values;
      bool valid = components.any() && parse_numbers(corners, values) &&
                   values.size() == 2 * dim;
      Point<dim> lower, upper;
      for (unsigned int d = 0; valid && d < dim; ++d)
        {
          lower[d] = values[d];
          upper[d] = values[dim + d];
          valid    = lower[d] <= upper[d];
        }
      parameters.require(valid,
                         "Support",
                         "Fixed boxes",
                         "the smallest, then the largest coordinates, ':' and "
                         "components of " +
                           axes<dim> + ", separated by ';'");
      const Region<dim> box(lower, upper);
      // Other rooms may refine parts of the body further.
      const bool is_refined =
        parameters.is_given("Cut", "Refinement near cut") ||
        parameters.is_given("Accuracy", "Target");
      parameters.require(
        holds_nodes(box, body, body.n_halvings + (is_refined ? 3 : 0)),
        "Support",
        "Fixed boxes",
        "boxes that hold nodes of the body, and '" + corners + "' holds none");
      supports.push_back({box, components, {}, "Fixed boxes = " + corners});
    }
}



template <int dim>
void
SupportParameters<dim>::read_displacements(const Parameters &parameters,
                                           const Body<dim> &body)
{
  for (const auto &[word, text] :
       split_items(parameters.text("Support", "Displacements"), ';'))
    {
      const auto values = split(text, ',');
      bool valid        = values.size() == dim;
      std::bitset<dim> components;
      Tensor<1, dim> displacement;
      for (unsigned int d = 0; valid && d < dim; ++d)
        if (values[d] != "free")
          {
            std::vector<double> value;
            valid = parse_numbers(values[d], value) && value.size() == 1;
            components[d] = true;
            if (valid)
              displacement[d] = value[0];
          }
      parameters.require(
        valid && components.any(),
        "Support",
        "Displacements",
        "'group : " + std::string(dim == 3 ? "ux, uy, uz" : "ux, uy") +
          "' with numbers or 'free', separated by ';'");
      supports.push_back(
        {region_of_word(parameters, "Displacements", body, word),
         components,
         displacement,
         "Displacements = " + word});
    }
}



template struct SupportParameters<2>;
template struct SupportParameters<3>;
} // namespace Setsudan
