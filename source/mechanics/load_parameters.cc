// SPDX-License-Identifier: LGPL-2.1-or-later
#include <setsudan/body/group_of_word.h>
#include <setsudan/body/node_of_word.h>
#include <setsudan/mechanics/loads.h>
#include <setsudan/mesh/face_index.h>
#include <setsudan/parameters/lists.h>

#include <algorithm>

namespace Setsudan
{
using namespace dealii;

template <int dim>
void
LoadParameters<dim>::declare(ParameterHandler &handler)
{
  const std::string components = dim == 3 ? "0, 0, -1" : "0, -1";
  Setsudan::declare(handler,
                    "Load",
                    "Body force",
                    "",
                    Patterns::List(Patterns::Double()),
                    "Force per volume, such as the weight " + components +
                      " [force/volume].");
  Setsudan::declare(handler,
                    "Load",
                    "Pressures",
                    "",
                    Patterns::Anything(),
                    "Pressures on the body's surface, positive into it, as "
                    "'group : pressure', separated by ';' [force/area].");
  Setsudan::declare(handler,
                    "Load",
                    "Tractions",
                    "",
                    Patterns::Anything(),
                    "Forces per area of the surface, as 'group : " +
                      components + "', separated by ';' [force/area].");
  Setsudan::declare(handler,
                    "Load",
                    "Nodal forces",
                    "",
                    Patterns::Anything(),
                    "Forces on nodes, as 'node number : " + components +
                      "', separated by ';' [force].");
}



namespace
{
/**
 * The items `key : n numbers` of a list in subsection Load.
 *
 * @throw SceneError where an item is not of that form, or a key stands twice.
 */
std::map<std::string, std::vector<double>>
read_items(const Parameters &parameters,
           const std::string &name,
           const unsigned int n,
           const std::string &allowed)
{
  std::map<std::string, std::vector<double>> items;
  for (const auto &[key, text] :
       split_items(parameters.text("Load", name), ';'))
    {
      std::vector<double> values;
      const bool valid = parse_numbers(text, values) && values.size() == n;
      parameters.require(valid && items.emplace(key, values).second,
                         "Load",
                         name,
                         allowed + ", each once, separated by ';'");
    }
  return items;
}



template <int dim>
Tensor<1, dim>
to_tensor(const std::vector<double> &values)
{
  Tensor<1, dim> tensor;
  for (unsigned int d = 0; d < dim; ++d)
    tensor[d] = values[d];
  return tensor;
}



/** The faces of the body's surface that a group holds. */
template <int dim>
std::vector<CellFace>
faces_of_word(const Parameters &parameters,
              const Body<dim> &body,
              const FaceIndex<dim> &index,
              const std::string &name,
              const std::string &word)
{
  std::vector<CellFace> faces;
  for (const auto &entity :
       find_group_or_reject(
         parameters, "Load", name, body, word, GroupKind::faces)
         .entities)
    {
      const auto cells = index.find(entity);
      parameters.require(cells.size() == 1,
                         "Load",
                         name,
                         "values for groups of the body's surface, and '" +
                           word + "' is no part of it");
      faces.push_back(cells[0]);
    }
  return faces;
}
} // namespace


template <int dim>
LoadParameters<dim>::LoadParameters(const Parameters &parameters,
                                    const Body<dim> &body)
{
  const std::string components = std::to_string(dim) + " components";
  if (!parameters.text("Load", "Body force").empty())
    body_force = to_tensor<dim>(parameters.numbers("Load", "Body force", dim));
  const auto pressures =
    read_items(parameters, "Pressures", 1, "'group : pressure'");
  const auto tractions =
    read_items(parameters, "Tractions", dim, "'group : " + components + "'");
  if (!pressures.empty() || !tractions.empty())
    {
      const FaceIndex<dim> index(body.mesh);
      const auto faces_of = [&](const std::string &name,
                                const std::string &word) {
        auto faces = faces_of_word(parameters, body, index, name, word);
        surface_items.emplace_back(name + " = " + word, faces.size());
        return faces;
      };
      for (const auto &[word, values] : pressures)
        for (const auto &face : faces_of("Pressures", word))
          surface_loads[face].pressure += values[0];
      for (const auto &[word, values] : tractions)
        for (const auto &face : faces_of("Tractions", word))
          surface_loads[face].traction += to_tensor<dim>(values);
    }
  for (const auto &[node, values] : read_items(
         parameters, "Nodal forces", dim, "'node number : " + components + "'"))
    {
      const auto inserted = nodal_forces.emplace(
        node_of_word(parameters, "Load", "Nodal forces", body, node),
        to_tensor<dim>(values));
      parameters.require(
        inserted.second, "Load", "Nodal forces", "forces on nodes, each once");
    }
}



template <int dim>
bool
LoadParameters<dim>::empty() const
{
  return body_force == Force() && surface_loads.empty() && nodal_forces.empty();
}



template <int dim>
bool
LoadParameters<dim>::has_pressure() const
{
  return std::any_of(
    surface_loads.begin(), surface_loads.end(), [](const auto &of_face) {
      return of_face.second.pressure != 0;
    });
}



template struct LoadParameters<2>;
template struct LoadParameters<3>;
} // namespace Setsudan
