// SPDX-License-Identifier: LGPL-2.1-or-later
#include <algorithm>
#include <filesystem>
#include <limits>
#include <numeric>
#include <setsudan/mechanics/pieces/hinges.h>
#include <setsudan/mesh/geometry.h>
#include <setsudan/output/pieces/calculix_material.h>
#include <setsudan/parameters/lists.h>
#include <setsudan/simulation/model_size.h>
#include <setsudan/simulation/scene.h>
#include <setsudan/simulation/travel_checks.h>
#include <setsudan/space/rigid_modes.h>
#include <sstream>

namespace Setsudan
{
using namespace dealii;

unsigned int
scene_dimension(const std::vector<SceneEntry> &entries)
{
  unsigned int dimension = 3;
  for (const auto &entry : entries)
    if (entry.subsection.empty() && entry.name == "Dimension")
      {
        if (entry.value != "2" && entry.value != "3")
          throw SceneError(entry.location + ": 'Dimension' is '" + entry.value +
                           "'; allowed is: 2 (plane strain) or 3.");
        dimension = entry.value == "2" ? 2 : 3;
      }
  return dimension;
}



std::string
text_in(const std::string &directory, const Parameters &parameters)
{
  std::ostringstream text;
  text << OutputDirectory::signature << " " SETSUDAN_VERSION
       << ": the parameters of the run in this directory.\n";
  if (parameters.text("Body", "File").empty())
    parameters.print(text);
  else
    {
      const auto file =
        std::filesystem::proximate(parameters.path("Body", "File"), directory);
      parameters.with({{"Body", "File", file.string(), "parameters.prm"}})
        .print(text);
    }
  return text.str();
}



template <int dim>
void
Scene<dim>::declare(ParameterHandler &handler)
{
  Setsudan::declare(handler,
                    "",
                    "Dimension",
                    std::to_string(dim),
                    Patterns::Selection("2|3"),
                    "2 is plane strain, for forces per unit of thickness.");
  Setsudan::declare(handler,
                    "",
                    "Length unit",
                    "cm",
                    Patterns::Anything(),
                    "A label for tables and pictures: any consistent set of "
                    "units works. With Material/Preset m, cm, mm or um.");
  Setsudan::declare(handler,
                    "",
                    "Force unit",
                    "gf",
                    Patterns::Anything(),
                    "A label, as the unit of length. With Material/Preset N, "
                    "kN, mN, uN, gf or kgf.");
  BodyParameters<dim>::declare(handler);
  MaterialParameters<dim>::declare(handler);
  RateLaw::declare(handler);
  SupportParameters<dim>::declare(handler);
  LoadParameters<dim>::declare(handler);
  BladeParameters<dim>::declare(handler);
  CutParameters<dim>::declare(handler);
  BoardParameters<dim>::declare(handler);
  YieldParameters::declare(handler);
  DivisionParameters::declare(handler);
  AccuracyParameters::declare(handler);
  SolverParameters::declare(handler);
  OutputParameters::declare(handler);
}



namespace
{
/** The first parameter that a scene gives supports with. */
std::string
given_support(const Parameters &parameters)
{
  for (const std::string name : {"Fixed faces",
                                 "Fixed components",
                                 "Fixed boxes",
                                 "Fixed nodes",
                                 "Displacements"})
    if (!parameters.text("Support", name).empty())
      return name;
  return "Fixed faces";
}



/** How many rigid motions the supports leave a body. */
template <int dim>
unsigned int
n_free_motions(const Body<dim> &body, const Supports<dim> &supports)
{
  std::vector<unsigned int> elements(body.mesh.cells.size());
  std::iota(elements.begin(), elements.end(), 0);
  return find_minimal_hold(supports.held_points(elements), body.mesh.vertices)
    .size();
}



/** Refuse a body that its supports do not hold. */
template <int dim>
void
check_supports(const Parameters &parameters,
               const Body<dim> &body,
               const Supports<dim> &supports)
{
  const unsigned int n_ways = n_free_motions(body, supports);
  parameters.require(
    n_ways == 0,
    "Support",
    given_support(parameters),
    "groups, boxes and nodes that hold the body; with these it is free to move "
    "rigidly in " +
      std::to_string(n_ways) + (n_ways == 1 ? " way" : " ways"));
  if (const auto loose = describe_loose_part(body, supports))
    parameters.reject("Support",
                      given_support(parameters),
                      "groups, boxes and nodes that hold every part of the "
                      "body; " +
                        *loose);
  if (const auto node = supports.find_contradiction())
    parameters.reject("Support",
                      "Displacements",
                      "displacements that agree with the other supports; at "
                      "the node at " +
                        text_of(*node) + " they do not");
}

/** Refuse what a body on a board cannot do. */
template <int dim>
void
check_board(const Parameters &parameters, const Scene<dim> &scene)
{
  parameters.require(scene.cut.cuts.empty() || scene.blade.travels,
                     "Board",
                     "Plane",
                     "nothing where a body is cut with Blade/Drive = force, "
                     "which has no contact");
  parameters.require(scene.board.friction > 0 ||
                       n_free_motions(scene.body, scene.supports) == 0,
                     "Board",
                     "Friction",
                     "more than 0 where no support holds the body");
  parameters.require(
    scene.accuracy.target == 0, "Accuracy", "Target", "0 on a board");
  // Of the springs that carry the body meanwhile other solvers know nothing.
  parameters.require(scene.solver.cut_solve !=
                         SolverParameters::CutSolve::row_by_row ||
                       scene.material.finite_strain,
                     "Division",
                     "Solve",
                     "auto or condensed on a board, whose contact is found "
                     "from one factorization");
}



/** Refuse what does not go with contact between a blade and the walls. */
template <int dim>
void
check_contact(const Parameters &parameters, const Scene<dim> &scene)
{
  const std::string where = scene.blade.travels
                              ? " where Blade/Drive is travel"
                              : " where Division/Split rows is wedged";
  parameters.require(
    scene.accuracy.target == 0, "Accuracy", "Target", "0" + where);
  parameters.require(
    !scene.blade.travels ||
      scene.division.split_rows == DivisionParameters::SplitRows::opened,
    "Division",
    "Split rows",
    "opened" + where + ", which keeps walls apart by its flanks alone");
}



/** Refuse what is there for small strain only. */
template <int dim>
void
check_finite_strain(const Parameters &parameters, const Scene<dim> &scene)
{
  const std::string where =
    " where Deformation/Strain is " + parameters.text("Deformation", "Strain");
  parameters.require(scene.blade.travels || !scene.has_contact(),
                     "Division",
                     "Split rows",
                     "opened or free" + where);
  parameters.require(
    scene.accuracy.target == 0, "Accuracy", "Target", "0" + where);
  parameters.require(
    !scene.accuracy.estimate, "Accuracy", "Estimate", "false" + where);
  parameters.require(!scene.yield.compares_energies() ||
                       !scene.loads.has_pressure(),
                     "Load",
                     "Pressures",
                     "nothing with Yield/Criterion = energy release" + where +
                       ", since a pressure that follows a surface with a free "
                       "rim has no energy; Load/Tractions has");
  parameters.require(scene.solver.cut_solve !=
                       SolverParameters::CutSolve::condensed,
                     "Division",
                     "Solve",
                     "auto or every row anew" + where);
}


/** Refuse what does not go with plastic flow. */
template <int dim>
void
check_plasticity(const Parameters &parameters, const Scene<dim> &scene)
{
  const std::string where = " where Material/Yield stress is given";
  parameters.require(!scene.blade.travels,
                     "Blade",
                     "Drive",
                     "force" + where +
                       ", since contact is found for elastic bodies only");
  parameters.require(
    !scene.board.is_given, "Board", "Plane", "nothing" + where);
  parameters.require(
    !scene.has_contact(), "Division", "Split rows", "opened or free" + where);
  parameters.require(!scene.yield.compares_energies(),
                     "Yield",
                     "Criterion",
                     "maximum shear or another stress" + where +
                       ": plastic flow at the front takes what a split sets "
                       "free, the more of it the smaller the elements are");
  parameters.require(
    scene.accuracy.target == 0, "Accuracy", "Target", "0" + where);
  parameters.require(
    !scene.accuracy.estimate, "Accuracy", "Estimate", "false" + where);
  parameters.require(scene.solver.cut_solve !=
                       SolverParameters::CutSolve::condensed,
                     "Division",
                     "Solve",
                     "auto or every row anew" + where);
  parameters.require(!scene.output.calculix_decks,
                     "Output",
                     "CalculiX decks",
                     "false" + where +
                       ", since a deck knows nothing of the states before");
}



/** Refuse decks for CalculiX with laws that it does not have. */
template <int dim>
void
check_laws_of_decks(const Parameters &parameters, MaterialParameters<dim> laws)
{
  if (laws.strain == LawParameters::Strain::automatic)
    laws.take_finite_strain();
  for (const auto &material : laws.all())
    parameters.require(
      calculix_material(material).has_value(),
      "Output",
      "CalculiX decks",
      "false with the law " + material.law->name() +
        " and Material/Volumetric energy = " +
        parameters.text("Material", "Volumetric energy") +
        ": of finite strain CalculiX has isochoric neo-Hooke, Mooney-Rivlin "
        "and Ogden of up to four terms, with Volumetric energy = quadratic");
}



/** The materials, and what a blunt edge takes besides their toughness. */
template <int dim>
MaterialParameters<dim>
material_for(const Parameters &parameters,
             const Body<dim> &body,
             const BladeParameters<dim> &blade)
{
  MaterialParameters<dim> material(parameters, body);
  if (blade.edge_radius > 0)
    {
      parameters.require(parameters.text("Yield", "Criterion") ==
                           "energy release",
                         "Yield",
                         "Criterion",
                         "energy release where Blade/Edge radius is given");
      parameters.require(
        parameters.is_given("Material", "Shear limit") ||
          parameters.is_given("Material", "Shear limit by axis"),
        "Material",
        "Shear limit",
        "given where Blade/Edge radius is");
      material.add_work_of_edge(2 * blade.edge_radius *
                                (1 + blade.sliding.friction));
    }
  return material;
}
} // namespace


template <int dim>
Scene<dim>::Scene(const Parameters &parameters)
  : length_unit(parameters.text("", "Length unit"))
  , force_unit(parameters.text("", "Force unit"))
  , body_parameters(parameters)
  , body(make_body(parameters, body_parameters))
  , supports(SupportParameters<dim>(parameters, body), body)
  , loads(parameters, body)
  , rate(parameters)
  , blade(parameters)
  , material(material_for(parameters, body, blade))
  , cut(parameters, body, supports, blade)
  , board(parameters, body)
  , yield(parameters)
  , criterion(YieldCriterion<dim>::make(yield, material, blade.sharpness))
  , division(parameters)
  , accuracy(parameters)
  , solver(parameters)
  , output(parameters)
{
  check_size(parameters,
             body_parameters,
             cut,
             estimate_size(body_parameters, body, cut, solver));
  if (board.is_given)
    check_board(parameters, *this);
  else
    check_supports(parameters, body, supports);
  if (blade.travels)
    check_travel(parameters, *this);
  parameters.require(blade.edge_points.empty() ||
                       division.release ==
                         DivisionParameters::Release::face_band,
                     "Division",
                     "Release",
                     "face band where Blade/Edge points are given, since "
                     "elements lie in no rows along such an edge");
  if (has_contact())
    check_contact(parameters, *this);
  if (material.strain != LawParameters::Strain::small)
    check_finite_strain(parameters, *this);
  if (material.is_plastic())
    check_plasticity(parameters, *this);
  parameters.require(
    !rate.is_active() || blade.path.has_times(),
    "Material",
    "Rate exponent",
    "0 where no Blade/Speed is given, nor times in Blade/Travel");
  // The path of the body's file changes with the directory: it may be none that
  // parameters.prm can hold.
  text_in(output.directory, parameters);
  parameters.require(output.time != OutputParameters::Time::depth ||
                       cut.cuts.size() <= 1,
                     "Output",
                     "Time",
                     "frame or travel where there are several cuts, in each of "
                     "which depth begins anew");
  parameters.require(!output.calculix_decks ||
                       body_parameters.element_type == ElementType::serendipity,
                     "Output",
                     "CalculiX decks",
                     "false with another Body/Element type than serendipity");
  parameters.require(
    !(output.calculix_decks && material.any_is_mixed()),
    "Output",
    "CalculiX decks",
    "false with the mixed formulation, whose elements CalculiX "
    "does not have (Material/Formulation = displacement has "
    "its C3D20)");
  if (output.calculix_decks)
    check_laws_of_decks(parameters, material);
}



template struct Scene<2>;
template struct Scene<3>;
} // namespace Setsudan
