// SPDX-License-Identifier: LGPL-2.1-or-later
#include <setsudan/simulation/model_size.h>
#include <setsudan/simulation/scene.h>
#include <setsudan/simulation/scene_checks.h>

#include <filesystem>
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
  TimeParameters::declare(handler);
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
  , time(parameters)
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
  check_scene(parameters, *this);
  // The path of the body's file changes with the directory: it may be none that
  // parameters.prm can hold.
  text_in(output.directory, parameters);
}



template struct Scene<2>;
template struct Scene<3>;
} // namespace Setsudan
