// SPDX-License-Identifier: LGPL-2.1-or-later
#include <deal.II/base/exceptions.h>
#include <deal.II/base/utilities.h>

#include <setsudan/body/gmsh/child_process.h>
#include <setsudan/body/gmsh/confinement.h>
#include <setsudan/body/gmsh/gmsh_groups.h>
#include <setsudan/body/gmsh/gmsh_mesh.h>
#include <setsudan/body/gmsh/gmsh_selection.h>
#include <setsudan/body/gmsh/gmsh_session.h>
#include <setsudan/mesh/node_order.h>
#include <setsudan/parameters/lists.h>

#include <gmsh.h>

#include <algorithm>
#include <csignal>
#include <limits>
#include <numeric>
#include <stdexcept>
#include <tuple>

namespace Setsudan
{
using namespace dealii;

namespace
{
template <int dim>
void
load_nodes(GmshMesh<dim> &mesh)
{
  std::vector<std::size_t> numbers;
  std::vector<double> coordinates, parameters;
  gmsh::model::mesh::getNodes(numbers, coordinates, parameters);
  std::vector<std::size_t> order(numbers.size());
  std::iota(order.begin(), order.end(), 0);
  std::sort(order.begin(), order.end(), [&](const auto a, const auto b) {
    return numbers[a] < numbers[b];
  });
  // The largest is deal.II's sign for no number.
  if (!order.empty() &&
      numbers[order.back()] >= std::numeric_limits<unsigned int>::max())
    throw std::runtime_error("the node number " +
                             std::to_string(numbers[order.back()]) +
                             " is too large");
  for (const std::size_t i : order)
    {
      mesh.node_numbers.push_back(numbers[i]);
      mesh.node_positions.emplace_back(
        coordinates[3 * i], coordinates[3 * i + 1], coordinates[3 * i + 2]);
    }
}

template <int dim>
struct ListedElement
{
  std::size_t number;
  int entity;
  typename GmshMesh<dim>::NodeNumbers nodes;
};

template <int dim>
std::vector<ListedElement<dim>>
list_elements(const int type, const int entity)
{
  std::vector<std::size_t> numbers, nodes;
  gmsh::model::mesh::getElementsByType(type, numbers, nodes, entity);
  const auto order = node_order<dim>(gmsh_edges<dim>());
  const std::size_t n_nodes =
    numbers.empty() ? 0 : nodes.size() / numbers.size();
  std::vector<ListedElement<dim>> elements(numbers.size());
  for (std::size_t e = 0; e < elements.size(); ++e)
    {
      elements[e].number = numbers[e];
      elements[e].entity = entity;
      elements[e].nodes.fill(numbers::invalid_unsigned_int);
      // Nodes in the middle of faces and elements come last.
      for (std::size_t i = 0; i < std::min(n_nodes, order.size()); ++i)
        elements[e].nodes[order[i]] = nodes[e * n_nodes + i];
    }
  return elements;
}

/** Of elements that are listed once for each of their groups keep the first. */
template <int dim>
void
remove_repetitions(std::vector<ListedElement<dim>> &elements, const int entity)
{
  const std::size_t n_listed = elements.size();
  std::sort(elements.begin(), elements.end(), [](const auto &a, const auto &b) {
    return std::tie(a.nodes, a.number) < std::tie(b.nodes, b.number);
  });
  elements.erase(std::unique(elements.begin(),
                             elements.end(),
                             [](const auto &a, const auto &b) {
                               return a.nodes == b.nodes;
                             }),
                 elements.end());
  check_repetitions(dim, entity, n_listed, elements.size());
}

template <int dim>
CellsOfEntities
load_elements(const GmshOutline &outline, GmshMesh<dim> &mesh)
{
  const auto selection = select_gmsh_elements(dim, outline);
  mesh.is_quadratic    = selection.has_middle_nodes;
  std::vector<ListedElement<dim>> elements;
  for (const int entity : selection.entities)
    {
      auto of_entity = list_elements<dim>(selection.type, entity);
      if (can_have_repetitions(outline, dim, entity))
        remove_repetitions(of_entity, entity);
      elements.insert(elements.end(), of_entity.begin(), of_entity.end());
    }
  // gmsh gives them by entities, and the file may list them in any order.
  std::sort(elements.begin(), elements.end(), [](const auto &a, const auto &b) {
    return a.number < b.number;
  });
  CellsOfEntities cells;
  for (const auto &element : elements)
    {
      cells[element.entity].push_back(mesh.elements.size());
      mesh.element_numbers.push_back(element.number);
      mesh.elements.push_back(element.nodes);
    }
  return cells;
}

template <int dim>
GmshMesh<dim>
load_by_gmsh(const std::string &file_name, const GmshOutline &outline)
{
  GmshMesh<dim> mesh;
  try
    {
      GmshSession session;
      if (outline.is_geometry)
        session.open_geometry(file_name, dim);
      else
        session.open_mesh(file_name);
      load_nodes(mesh);
      mesh.groups =
        load_gmsh_groups(dim, outline, load_elements(outline, mesh));
    }
  catch (const std::string &message)
    {
      throw std::runtime_error("gmsh reports: " + message);
    }
  return mesh;
}

/** Why gmsh has ended without a mesh and without a message. */
std::string
explain(const ChildFailure &failure,
        const std::string &file_name,
        const double time_limit)
{
  if (failure.reason == ChildFailure::Reason::exit)
    return "the geometry ends gmsh itself by 'Exit' before there is a mesh; "
           "take that command out";
  if (failure.reason == ChildFailure::Reason::time_limit)
    return "gmsh has not finished it within the " + short_text(time_limit) +
           " s of Body/Meshing time: a loop or macro may have no end, or the "
           "mesh needs more time";
  if (failure.signal_number == SIGSYS)
    return "a body's geometry may not run commands, make directories or call "
           "servers; take out its 'SystemCall', 'CreateDir' or 'OnelabRun'";
  return "gmsh crashes when asked to read the file " + file_name +
         ": a number or a list in it may be too large";
}
} // namespace


template <int dim>
const Point<3> &
GmshMesh<dim>::position(const unsigned int node_number) const
{
  const auto found =
    std::lower_bound(node_numbers.begin(), node_numbers.end(), node_number);
  Assert(found != node_numbers.end() && *found == node_number,
         ExcMessage("Files with unknown nodes have been refused."));
  return node_positions[found - node_numbers.begin()];
}



template <int dim>
GmshMesh<dim>
load_gmsh_mesh(const std::string &file_name,
               const GmshOutline &outline,
               const double time_limit)
{
  const auto load = [&]() {
    if (!confine_process() && outline.is_geometry)
      throw std::runtime_error(
        "this system has no filter (seccomp) to keep a geometry from running "
        "commands and writing files: mesh it yourself by 'gmsh -3', and give "
        "the .msh");
    const auto packed =
      Utilities::pack(load_by_gmsh<dim>(file_name, outline), false);
    return std::string(packed.begin(), packed.end());
  };
  try
    {
      const std::string packed = run_in_child(load, time_limit);
      return Utilities::unpack<GmshMesh<dim>>(
        std::vector<char>(packed.begin(), packed.end()), false);
    }
  catch (const ChildFailure &failure)
    {
      throw std::runtime_error(explain(failure, file_name, time_limit));
    }
  catch (const std::bad_alloc &)
    {
      throw std::runtime_error(
        "the memory does not suffice for gmsh to read or mesh it; take fewer "
        "elements");
    }
}



template struct GmshMesh<2>;
template struct GmshMesh<3>;
template GmshMesh<2>
load_gmsh_mesh(const std::string &, const GmshOutline &, const double);
template GmshMesh<3>
load_gmsh_mesh(const std::string &, const GmshOutline &, const double);
} // namespace Setsudan
