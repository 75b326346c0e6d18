// SPDX-License-Identifier: LGPL-2.1-or-later
#include <setsudan/mechanics/pieces/hinges.h>
#include <setsudan/mesh/geometry.h>
#include <setsudan/output/pieces/calculix_material.h>
#include <setsudan/parameters/lists.h>
#include <setsudan/simulation/scene_checks.h>
#include <setsudan/simulation/travel_checks.h>
#include <setsudan/space/rigid_modes.h>

#include <numeric>

namespace Setsudan
{
using namespace dealii;

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



/** Refuse what is there for linear bodies only. */
template <int dim>
void
check_newton(const Parameters &parameters,
             const Scene<dim> &scene,
             const std::string &where)
{
  parameters.require(scene.blade.travels || !scene.has_contact(),
                     "Division",
                     "Split rows",
                     "opened or free" + where);
  parameters.require(
    scene.accuracy.target == 0, "Accuracy", "Target", "0" + where);
  parameters.require(
    !scene.accuracy.estimate, "Accuracy", "Estimate", "false" + where);
  parameters.require(scene.solver.cut_solve !=
                       SolverParameters::CutSolve::condensed,
                     "Division",
                     "Solve",
                     "auto or every row anew" + where);
}



/** Refuse what is there for small strain only. */
template <int dim>
void
check_finite_strain(const Parameters &parameters, const Scene<dim> &scene)
{
  const std::string where =
    " where Deformation/Strain is " + parameters.text("Deformation", "Strain");
  check_newton(parameters, scene, where);
  parameters.require(!scene.yield.compares_energies() ||
                       !scene.loads.has_pressure(),
                     "Load",
                     "Pressures",
                     "nothing with Yield/Criterion = energy release" + where +
                       ", since a pressure that follows a surface with a free "
                       "rim has no energy; Load/Tractions has");
}


/** Refuse what does not go with laws that remember. */
template <int dim>
void
check_memory(const Parameters &parameters, const Scene<dim> &scene)
{
  const std::string where = scene.material.is_plastic()
                              ? " where Material/Yield stress is given"
                              : " where Material/Viscous is given";
  check_newton(parameters, scene, where);
  parameters.require(!scene.output.calculix_decks,
                     "Output",
                     "CalculiX decks",
                     "false" + where +
                       ", since a deck knows nothing of the states before");
}



/** Refuse speeds and rates that nothing depends on, and times that are not
 * known. */
template <int dim>
void
check_times(const Parameters &parameters, const Scene<dim> &scene)
{
  parameters.require(scene.blade.travels || scene.blade.path.speed == 0 ||
                       scene.material.is_viscous(),
                     "Blade",
                     "Speed",
                     "0 where Blade/Drive is force and no Material/Viscous is "
                     "given");
  parameters.require(
    !scene.rate.is_active() ||
      (scene.blade.travels && scene.blade.path.has_times()),
    "Material",
    "Rate exponent",
    "0 where no Blade/Speed is given, nor times in Blade/Travel");
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


/** Refuse output that the scene cannot have. */
template <int dim>
void
check_output(const Parameters &parameters, const Scene<dim> &scene)
{
  const auto &output = scene.output;
  parameters.require(output.time != OutputParameters::Time::depth ||
                       scene.cut.cuts.size() <= 1,
                     "Output",
                     "Time",
                     "frame or travel where there are several cuts, in each of "
                     "which depth begins anew");
  parameters.require(!output.calculix_decks ||
                       scene.body_parameters.element_type ==
                         ElementType::serendipity,
                     "Output",
                     "CalculiX decks",
                     "false with another Body/Element type than serendipity");
  parameters.require(
    !(output.calculix_decks && scene.material.any_is_mixed()),
    "Output",
    "CalculiX decks",
    "false with the mixed formulation, whose elements CalculiX "
    "does not have (Material/Formulation = displacement has "
    "its C3D20)");
  if (output.calculix_decks)
    check_laws_of_decks(parameters, scene.material);
}
} // namespace


template <int dim>
void
check_scene(const Parameters &parameters, const Scene<dim> &scene)
{
  if (scene.board.is_given)
    check_board(parameters, scene);
  else
    check_supports(parameters, scene.body, scene.supports);
  if (scene.blade.travels)
    check_travel(parameters, scene);
  parameters.require(scene.blade.edge_points.empty() ||
                       scene.division.release ==
                         DivisionParameters::Release::face_band,
                     "Division",
                     "Release",
                     "face band where Blade/Edge points are given, since "
                     "elements lie in no rows along such an edge");
  if (scene.has_contact())
    check_contact(parameters, scene);
  if (scene.material.strain != LawParameters::Strain::small)
    check_finite_strain(parameters, scene);
  if (scene.material.has_internal_variables())
    check_memory(parameters, scene);
  check_times(parameters, scene);
  check_output(parameters, scene);
}



template void
check_scene(const Parameters &, const Scene<2> &);
template void
check_scene(const Parameters &, const Scene<3> &);
} // namespace Setsudan
