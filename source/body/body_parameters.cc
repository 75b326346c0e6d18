// SPDX-License-Identifier: LGPL-2.1-or-later
#include <setsudan/body/body_parameters.h>
#include <setsudan/body/gmsh/gmsh_file.h>
#include <setsudan/body/joints.h>
#include <setsudan/parameters/exceptions.h>

#include <limits>

namespace Setsudan
{
using namespace dealii;

namespace
{
ElementType
element_type_of_word(const std::string &word)
{
  return word == "linear"      ? ElementType::linear
         : word == "quadratic" ? ElementType::quadratic
                               : ElementType::serendipity;
}

template <int dim>
typename BodyParameters<dim>::OpenJoints
open_joints_of_word(const std::string &word)
{
  using OpenJoints = typename BodyParameters<dim>::OpenJoints;
  return word == "refuse"  ? OpenJoints::refuse
         : word == "allow" ? OpenJoints::allow
                           : OpenJoints::warn;
}

/** @throw SceneError that says where the body touches itself without being
 * joined. */
template <int dim>
void
refuse_open_joints(const Parameters &parameters, const Body<dim> &body)
{
  std::string sentences;
  for (const auto &sentence : describe_joints(body, find_joints(body)))
    sentences += " " + sentence;
  // The message puts a full stop of its own.
  parameters.require(sentences.empty(),
                     "Body",
                     "Open joints",
                     "warn or allow with this body." +
                       sentences.substr(0, sentences.rfind('.')));
}
} // namespace


namespace
{
/** The parameters of a box. */
template <int dim>
void
declare_box(ParameterHandler &handler)
{
  Setsudan::declare(handler,
                    "Body",
                    "Shape",
                    "box",
                    Patterns::Selection("box|file"),
                    "box: from the origin to Size; file: a body of gmsh.");
  Setsudan::declare(
    handler,
    "Body",
    "Size",
    dim == 3 ? "10, 10, 10" : "10, 10",
    Patterns::List(Patterns::Double(), dim, dim),
    "Edge lengths of the box along the axes, greater than 0 [length].");
  Setsudan::declare(handler,
                    "Body",
                    "Elements",
                    dim == 3 ? "1, 2, 1" : "2, 1",
                    Patterns::List(Patterns::Integer(1), dim, dim),
                    "Number of elements along each axis of the box: the "
                    "paper's nx, ny and nz, each at least 1.");
}
} // namespace


template <int dim>
void
BodyParameters<dim>::declare(ParameterHandler &handler)
{
  declare_box<dim>(handler);
  Setsudan::declare(handler,
                    "Body",
                    "File",
                    "",
                    Patterns::Anything(),
                    "The gmsh file of the body, .msh or .geo (which is meshed "
                    "with the options that it sets), relative to the scene "
                    "file. Elements are hexahedra of 8, 20 or 27 nodes (2D: "
                    "quadrilaterals of 4, 8 or 9); its physical groups are "
                    "addressed by name or number.");
  Setsudan::declare(handler,
                    "Body",
                    "Meshing time",
                    "600",
                    Patterns::Double(0),
                    "How long gmsh may take to mesh a .geo, greater than 0: "
                    "then it is stopped [s].");
  Setsudan::declare(handler,
                    "Body",
                    "Open joints",
                    "warn",
                    Patterns::Selection("warn|refuse|allow"),
                    "What is done where parts of the file's body touch without "
                    "being joined face to face: nodes that lie in one place, "
                    "faces that lie on others with other nodes, parts that "
                    "share a line or a point only. allow: they are meant, like "
                    "the double nodes of a slit.");
  Setsudan::declare(handler,
                    "Body",
                    "Refinement",
                    "0",
                    Patterns::Integer(0, 10),
                    "How often all elements are halved along each axis [-].");
  Setsudan::declare(handler,
                    "Body",
                    "Element type",
                    "serendipity",
                    Patterns::Selection("linear|serendipity|quadratic"),
                    "linear: nodes at the corners only, stiff in bending and "
                    "cheap; serendipity: in the middle of lines too, the "
                    "paper's; quadratic: in the middle of faces and of the "
                    "element too, better in distorted elements and dearer.");
  Transformation<dim>::declare(handler);
}



template <int dim>
BodyParameters<dim>::BodyParameters(const Parameters &parameters)
  : shape(parameters.text("Body", "Shape") == "box" ? Shape::box : Shape::file)
  , file(parameters.text("Body", "File"))
  , meshing_time(parameters.number("Body", "Meshing time"))
  , open_joints(
      open_joints_of_word<dim>(parameters.text("Body", "Open joints")))
  , transformation(parameters)
  , refinement(parameters.natural("Body", "Refinement"))
  , element_type(element_type_of_word(parameters.text("Body", "Element type")))
{
  parameters.require((shape == Shape::file) == !file.empty(),
                     "Body",
                     "File",
                     "a gmsh file with Shape = file, and nothing with box");
  parameters.require(
    meshing_time > 0, "Body", "Meshing time", "a time greater than 0");
  const auto lengths = parameters.numbers("Body", "Size", dim);
  const auto counts  = parameters.numbers("Body", "Elements", dim);
  double n_cells     = 1;
  for (unsigned int d = 0; d < dim; ++d)
    {
      parameters.require(
        lengths[d] > 0, "Body", "Size", "lengths greater than 0");
      size[d]       = lengths[d];
      n_elements[d] = static_cast<unsigned int>(counts[d]);
      n_cells *= counts[d];
    }
  // Node numbers are 32 bits wide, and there are fewer than 5 nodes a cell.
  parameters.require(n_cells < std::numeric_limits<unsigned int>::max() / 8.,
                     "Body",
                     "Elements",
                     "fewer than 500 million elements in all");
  // Before it is made.
  if (shape == Shape::box)
    check_refined(parameters, size_of_box<dim>(n_elements));
}



template <int dim>
MeshSize<dim>
BodyParameters<dim>::refined(MeshSize<dim> mesh) const
{
  for (unsigned int level = 0; level < refinement; ++level)
    mesh = mesh.refined();
  return mesh;
}



template <int dim>
void
BodyParameters<dim>::check_refined(const Parameters &parameters,
                                   const MeshSize<dim> &mesh) const
{
  const MeshSize<dim> finest = refined(mesh);
  const double n_unknowns    = finest.n_unknowns(element_type);
  check_memory(parameters,
               "Body",
               refinement > 0 ? "Refinement" : "Elements",
               finest.n_cells(),
               n_unknowns,
               memory_of_model<dim>(n_unknowns, false));
}



template <int dim>
Body<dim>
make_body(const Parameters &parameters, const BodyParameters<dim> &choice)
{
  const auto make = [&]() {
    if (choice.shape == BodyParameters<dim>::Shape::box)
      return make_box(choice.size, choice.n_elements);
    try
      {
        return read_gmsh_file<dim>(parameters.path("Body", "File"),
                                   choice.meshing_time);
      }
    catch (const BodyFileError &error)
      {
        parameters.reject("Body",
                          "File",
                          std::string("a gmsh file that can be used: ") +
                            error.what());
      }
  };
  Body<dim> body = make();
  choice.transformation.apply(body);
  body.n_halvings = choice.refinement;
  body.has_middle_nodes =
    choice.element_type != ElementType::linear || choice.refinement > 0;
  if (choice.open_joints == BodyParameters<dim>::OpenJoints::refuse)
    refuse_open_joints(parameters, body);
  return body;
}



template struct BodyParameters<2>;
template struct BodyParameters<3>;
template Body<2>
make_body(const Parameters &, const BodyParameters<2> &);
template Body<3>
make_body(const Parameters &, const BodyParameters<3> &);
} // namespace Setsudan
