// SPDX-License-Identifier: LGPL-2.1-or-later
#include <deal.II/base/utilities.h>

#include <setsudan/body/gmsh/child_process.h>
#include <setsudan/body/gmsh/confinement.h>
#include <setsudan/body/gmsh/gmsh_geometry.h>
#include <setsudan/body/gmsh/gmsh_session.h>
#include <setsudan/parameters/exceptions.h>
#include <setsudan/parameters/lists.h>

#include <gmsh.h>

#include <algorithm>
#include <csignal>
#include <cstdlib>
#include <limits>
#include <new>
#include <vector>

namespace Setsudan
{
using namespace dealii;

namespace
{
/** The first errors that gmsh has logged, which tell what is wrong; others
 * follow from them. */
std::string
first_errors()
{
  constexpr unsigned int n_reported = 3;
  const std::string prefix          = "Error: ";
  std::vector<std::string> entries;
  gmsh::logger::get(entries);
  std::string errors;
  unsigned int n_errors = 0;
  for (const auto &entry : entries)
    if (entry.compare(0, prefix.size(), prefix) == 0 &&
        ++n_errors <= n_reported)
      errors += (n_errors > 1 ? "; " : "") + entry.substr(prefix.size());
  return errors;
}

/** What is behind an error that does not tell it. */
std::string
explanation(const std::string &errors)
{
  if (errors.find("Unable to open file") == std::string::npos &&
      errors.find("output file") == std::string::npos)
    return "";
  return " (a file that the geometry reads must exist, and it may not write "
         "any: take out 'Save', 'Print' and 'Printf' to files)";
}

/** Run `action`; @throw BodyFileError that gmsh cannot do `what`, where gmsh
 * throws or logs errors. */
template <typename Action>
void
guard(const std::string &what, const Action &action)
{
  // The message that names the line is often not the first; and gmsh meshes in
  // threads, out of which nothing can be thrown. The file may have changed the
  // option.
  gmsh::option::setNumber("General.AbortOnError", 0);
  std::string errors;
  try
    {
      action();
      errors = first_errors();
    }
  catch (const std::string &message)
    {
      errors = message;
    }
  if (!errors.empty())
    throw BodyFileError("gmsh cannot " + what + ": " + errors +
                        explanation(errors));
}

double
number_of_option(const std::string &name)
{
  double number;
  gmsh::option::getNumber(name, number);
  return number;
}

/** Open the file, and mesh what is not meshed. */
void
run_geometry(const std::string &file_name, const unsigned int dim)
{
  gmsh::logger::start();
  guard("read the file", [&]() { gmsh::open(file_name); });
  // Then it does not log errors.
  if (number_of_option("General.Verbosity") < 1)
    throw BodyFileError(
      "the geometry hides gmsh's errors by 'General.Verbosity'; take that out");
  std::vector<int> types;
  gmsh::model::mesh::getElementTypes(types, dim);
  if (types.empty())
    guard("mesh the geometry", [&]() { gmsh::model::mesh::generate(dim); });
}

/** Numbers as this program has them, of which the largest means none. */
std::vector<unsigned int>
checked_numbers(const std::vector<std::size_t> &numbers)
{
  for (const std::size_t number : numbers)
    if (number >= std::numeric_limits<unsigned int>::max())
      throw BodyFileError("the node or element number " +
                          std::to_string(number) + " is too large");
  return {numbers.begin(), numbers.end()};
}

void
take_nodes(GmshMesh &mesh)
{
  std::vector<std::size_t> numbers;
  std::vector<double> coordinates, parameters;
  gmsh::model::mesh::getNodes(numbers, coordinates, parameters);
  const double *at = coordinates.data();
  for (const unsigned int number : checked_numbers(numbers))
    {
      mesh.nodes.push_back({number, {at[0], at[1], at[2]}});
      at += 3;
    }
  mesh.sort_nodes();
}

/** The groups of an entity that is no border between the parts of a
 * partitioned mesh, which gmsh makes out of entities of a larger dimension. */
std::vector<int>
groups_of_entity(const int dimension, const int entity)
{
  int parent_dimension, parent;
  gmsh::model::getParent(dimension, entity, parent_dimension, parent);
  std::vector<int> groups;
  if (parent_dimension <= dimension)
    gmsh::model::getPhysicalGroupsForEntity(dimension, entity, groups);
  return groups;
}

void
take_entity(const int dimension,
            const int entity,
            const std::vector<int> &groups,
            GmshMesh &mesh)
{
  std::vector<int> types;
  std::vector<std::vector<std::size_t>> numbers, nodes;
  gmsh::model::mesh::getElements(types, numbers, nodes, dimension, entity);
  for (unsigned int i = 0; i < types.size(); ++i)
    if (gmsh_type(types[i]); !numbers[i].empty())
      mesh.blocks.push_back({types[i],
                             entity,
                             groups,
                             checked_numbers(numbers[i]),
                             checked_numbers(nodes[i])});
}

GmshMesh
take_mesh(const unsigned int dim)
{
  GmshMesh mesh;
  mesh.is_of_geometry = true;
  take_nodes(mesh);
  gmsh::vectorpair entities, groups_of_body;
  gmsh::model::getEntities(entities);
  gmsh::model::getPhysicalGroups(groups_of_body, dim);
  const bool takes_all =
    groups_of_body.empty() || number_of_option("Mesh.SaveAll") != 0;
  for (const auto &[dimension, entity] : entities)
    {
      const auto groups = groups_of_entity(dimension, entity);
      if (takes_all || dimension != int(dim) || !groups.empty())
        take_entity(dimension, entity, groups, mesh);
      for (const int group : groups)
        gmsh::model::getPhysicalName(
          dimension,
          std::abs(group),
          mesh.group_names[{dimension, std::abs(group)}]);
    }
  return mesh;
}

/** Why the child has ended without a mesh. */
std::string
explain(const ChildFailure &failure,
        const std::string &file_name,
        const double time_limit)
{
  switch (failure.reason)
    {
      case ChildFailure::Reason::exception:
        return failure.what();
      case ChildFailure::Reason::exit:
        return "the geometry ends gmsh itself by 'Exit' before there is a "
               "mesh; take that command out";
      case ChildFailure::Reason::time_limit:
        return "gmsh has not finished it within the " + short_text(time_limit) +
               " s of Body/Meshing time: a loop or macro may have no end, or "
               "the mesh needs more time";
      case ChildFailure::Reason::signal:
        break;
    }
  if (failure.signal_number == SIGSYS)
    return "a body's geometry may not run commands, make directories or call "
           "servers; take out its 'SystemCall', 'CreateDir' or 'OnelabRun'";
  return "gmsh crashes when asked to read the file " + file_name +
         ": a number or a list in it may be too large";
}
} // namespace


GmshMesh
mesh_geometry(const std::string &file_name,
              const unsigned int dim,
              const double time_limit)
{
  const auto work = [&]() {
    if (!confine_process())
      throw BodyFileError(
        "this system has no filter (seccomp) to keep a geometry from running "
        "commands and writing files: mesh it yourself by 'gmsh -3', and give "
        "the .msh");
    const GmshSession session;
    run_geometry(file_name, dim);
    GmshMesh mesh;
    guard("hand out the mesh", [&]() { mesh = take_mesh(dim); });
    const auto packed = Utilities::pack(mesh, false);
    return std::string(packed.begin(), packed.end());
  };
  try
    {
      const std::string packed = run_in_child(work, time_limit);
      return Utilities::unpack<GmshMesh>(
        std::vector<char>(packed.begin(), packed.end()), false);
    }
  catch (const ChildFailure &failure)
    {
      throw BodyFileError(explain(failure, file_name, time_limit));
    }
  catch (const std::bad_alloc &)
    {
      throw BodyFileError("the memory does not suffice for gmsh to read or "
                          "mesh it; take fewer elements");
    }
}
} // namespace Setsudan
