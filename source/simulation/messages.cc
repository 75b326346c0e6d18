// SPDX-License-Identifier: LGPL-2.1-or-later
#include <deal.II/base/mpi.h>

#include <setsudan/body/joints.h>
#include <setsudan/cut/yield/cutting_stress.h>
#include <setsudan/simulation/messages.h>

#include <algorithm>
#include <map>
#include <sstream>

namespace Setsudan
{
using namespace dealii;

template <int dim>
std::string
describe_body(const CutBody<dim> &body)
{
  const auto &scene          = body.scene();
  const auto &discretization = body.model().discretization;
  const auto n_unknowns      = discretization.dof_handler.n_dofs();
  const auto n_elements      = scene.body.mesh.cells.size();
  const auto n_cells = discretization.triangulation.n_global_active_cells();
  std::ostringstream line;
  const std::string type =
    scene.body_parameters.element_type == ElementType::linear ? " linear"
    : scene.body_parameters.element_type == ElementType::quadratic
      ? " quadratic"
      : "";
  line << "Body: " << dim << "D, " << n_elements << type
       << (n_elements == 1 ? " element" : " elements")
       << (scene.body.mesh.is_curved() ? " with curved sides, " : ", ");
  if (n_cells > n_elements)
    line << "refined to " << n_cells << " cells, ";
  const auto n_processes = Utilities::MPI::n_mpi_processes(body.communicator());
  line << n_unknowns / dim << " nodes, " << n_unknowns << " unknowns on "
       << n_processes << (n_processes == 1 ? " process" : " processes")
       << ".\nSolver: ";
  const auto solver = body.solver_choice();
  line << description(solver.kind) << ", " << solver.reason
       << (scene.cut.cuts.empty()
             ? "."
             : "; the states of a cut may be solved in another way, named "
               "there.");
  if (scene.material.any_is_mixed())
    line << "\nFormulation: mixed, "
         << (scene.material.formulation_is_named
               ? "as Material/Formulation says."
               : "because Poisson's ratio is near 1/2 (Material/Formulation).");
  return line.str();
}



template <int dim>
std::vector<std::string>
describe_open_joints(const Scene<dim> &scene)
{
  if (scene.body_parameters.open_joints ==
      BodyParameters<dim>::OpenJoints::allow)
    return {};
  return describe_joints(scene.body, find_joints(scene.body));
}



template <int dim>
std::string
describe_cut(const CutBody<dim> &body, const unsigned int cut)
{
  std::ostringstream line;
  line.precision(3);
  line << "Cut " << cut << " (" << body.cut().text
       << "): " << body.seam().rows().size()
       << (body.seam().rows().size() == 1 ? " row, " : " rows, ")
       << body.seam().pairs().size() << " nodes.";
  if (body.cut().edge.projection_angle > 1e-6)
    line << " The blade's direction is turned by "
         << body.cut().edge.projection_angle << " degrees into the cut.";
  return line.str();
}



template <int dim>
std::optional<std::string>
describe_edge(const Scene<dim> &scene)
{
  if (scene.blade.edge_radius == 0)
    return {};
  const double work = 4 * scene.blade.edge_radius *
                      (1 + scene.blade.sliding.friction) *
                      scene.material.smallest_shear_limit();
  std::ostringstream line;
  line.precision(3);
  line << "  the material yields over the width of the edge (Blade/Edge "
          "radius), which adds "
       << work << " " << scene.force_unit << "/" << scene.length_unit
       << " to a toughness of " << scene.material.smallest_toughness() - work
       << ".";
  return line.str();
}



template <int dim>
std::optional<std::string>
describe_resolution(const CutBody<dim> &body)
{
  const Scene<dim> &scene = body.scene();
  const auto &rows        = body.seam().rows();
  if (!scene.blade.travels || !scene.yield.compares_energies() ||
      rows.size() < 2)
    return {};
  const double length =
    requirement(scene.material.smallest_toughness(), scene.blade.sharpness) /
    scene.material.smallest_youngs_modulus();
  const double row = rows[1].depth - rows[0].depth;
  if (row <= length)
    return {};
  std::ostringstream line;
  line.precision(3);
  line << "  rows of " << row << " " << scene.length_unit
       << " are longer than toughness/Young's modulus = " << length
       << ": between two events the force rises and falls with the elements, "
          "and mean_force is what to compare.";
  return line.str();
}



template <int dim>
std::string
describe_roughness(const Cut<dim> &cut)
{
  std::ostringstream line;
  line.precision(2);
  // What differs by less is no step, but the digits of a file.
  const bool is_even = cut.surface.unevenness < 1e-3;
  line << "the elements do not follow this surface: ";
  if (is_even)
    line << "the cut is as flat as it, but lies beside it, by "
         << cut.surface.roughness
         << " element sizes, where the nearest boundary between elements is. ";
  else
    line << "the cut is stepped, and leaves it by up to "
         << cut.surface.roughness << " element sizes. ";
  line << "Mesh the body along it, or take smaller elements (Body/Elements, or "
          "the options of the file; Body/Refinement does not help).";
  return line.str();
}



template <int dim>
std::string
describe_solve(const CutBody<dim> &body)
{
  const auto strategy = body.cut_strategy();
  if (!body.model().is_linear() && body.scene().has_contact())
    return "  every step of Newton's method factors the tangent (CHOLMOD), "
           "condensed onto what may touch the blade, " +
           strategy.reason + ".";
  const std::string each =
    body.scene().has_contact() ? "with each force of contact, " : "";
  std::string way;
  switch (strategy.kind)
    {
      case CutStrategy::condensed:
        way = "all rows are solved from one factorization (CHOLMOD), condensed "
              "onto the cut";
        break;
      case CutStrategy::preconditioned:
        way =
          "all rows are solved by conjugate gradients in Newton's method, "
          "preconditioned by a factorization (CHOLMOD) of the body at rest, "
          "or of a later state where that fits no more";
        break;
      case CutStrategy::row_by_row:
        way = "every row is solved anew, " + each +
              description(body.solver_choice().kind);
    }
  return "  " + way + ", " + strategy.reason + ".";
}



template <int dim>
std::string
describe_arrest(const Scene<dim> &scene,
                const Event &event,
                const unsigned int n_rows)
{
  std::ostringstream line;
  line.precision(6);
  if (!scene.blade.path.stops.empty())
    {
      const double travel = event.motion->travel;
      line << "The blade's path ends in row " << event.row + 1 << " of "
           << n_rows << ": it is ";
      if (travel > 0)
        line << "at rest at a travel of " << travel << " " << scene.length_unit;
      else
        line << "withdrawn";
      if (event.cut + 1 < scene.cut.cuts.size())
        line << ", and the cuts behind this one are not made";
      return line.str() + ".";
    }
  line << "Arrested at row " << event.row + 1 << " of " << n_rows << ": ";
  if (event.motion &&
      event.motion->travel >=
        (1 - 1e-9) * last_travel_on_board(
                       scene.board, scene.body.mesh, scene.cut.cuts[event.cut]))
    return line.str() +
           "the blade's edge is on the board, and the rest of the cut is "
           "pressed together under it and does not yield.";
  if (event.motion)
    return line.str() + "however far the blade travels, " +
           (scene.yield.compares_energies()
              ? "no split of the next rows sets free what their area takes. "
                "Let more rows split at once (Division/Look-ahead)."
              : "the stress at the front does not reach what is required.");
  line << "the " << scene.yield.quantity() << " reached "
       << event.cutting_stress << " and " << event.required_stress
       << " is required, at load factor " << event.load_factor;
  if (scene.division.load_control == DivisionParameters::LoadControl::ramp)
    line << ", the largest that Division/Maximum load factor allows";
  return line.str() + ".";
}



template <int dim>
std::optional<std::string>
describe_path_left_out(const Scene<dim> &scene, const State<dim> &state)
{
  const auto &stops = scene.blade.path.stops;
  if (stops.empty() || state.motion->n_stops == stops.size())
    return {};
  std::ostringstream line;
  line.precision(6);
  line << "The cut is through at a travel of " << state.motion->travel << " "
       << scene.length_unit << ": of the blade's path is left out";
  for (unsigned int stop = state.motion->n_stops; stop < stops.size(); ++stop)
    line << (stop == state.motion->n_stops ? " " : ", ")
         << stops[stop].position;
  return line.str() + ".";
}



std::optional<std::string>
describe_unfelt_work(const BladeMotion &motion)
{
  if (motion.unfelt_work == 0)
    return {};
  std::ostringstream line;
  line.precision(3);
  line << "The blade presses on the walls across the cut only: of its force "
          "along its way the supports feel "
       << 100 * (1 - motion.unfelt_work / motion.work)
       << " %, in the mean over its work.";
  return line.str();
}



template <int dim>
std::vector<std::string>
describe_loose_pieces(const CutBody<dim> &body,
                      const std::vector<FloatingPiece> &known)
{
  const bool drops = body.scene().supports.drop_loose_pieces();
  std::map<std::size_t, std::string> pieces_by_hold;
  for (const auto &loose : body.floating_pieces())
    if (std::none_of(
          known.begin(), known.end(), [&](const FloatingPiece &other) {
            return other.piece == loose.piece;
          }))
      pieces_by_hold[loose.hold.size()] += " " + std::to_string(loose.piece);
  std::vector<std::string> lines;
  for (const auto &[n, pieces] : pieces_by_hold)
    lines.push_back("  floating pieces, which no support holds:" + pieces +
                    " (" +
                    (drops ? "left out from now on"
                           : "held at " + std::to_string(n) +
                               (n == 1 ? " component" : " components") +
                               " each, which the loads do not strain") +
                    ")");
  return lines;
}



template std::string
describe_body(const CutBody<2> &);
template std::string
describe_body(const CutBody<3> &);
template std::vector<std::string>
describe_open_joints(const Scene<2> &);
template std::vector<std::string>
describe_open_joints(const Scene<3> &);
template std::string
describe_cut(const CutBody<2> &, const unsigned int);
template std::optional<std::string>
describe_resolution(const CutBody<2> &);
template std::optional<std::string>
describe_edge(const Scene<2> &);
template std::optional<std::string>
describe_edge(const Scene<3> &);
template std::optional<std::string>
describe_resolution(const CutBody<3> &);
template std::string
describe_cut(const CutBody<3> &, const unsigned int);
template std::string
describe_roughness(const Cut<2> &);
template std::string
describe_arrest(const Scene<2> &, const Event &, const unsigned int);
template std::optional<std::string>
describe_path_left_out(const Scene<2> &, const State<2> &);
template std::optional<std::string>
describe_path_left_out(const Scene<3> &, const State<3> &);
template std::string
describe_solve(const CutBody<2> &);
template std::string
describe_roughness(const Cut<3> &);
template std::string
describe_arrest(const Scene<3> &, const Event &, const unsigned int);
template std::string
describe_solve(const CutBody<3> &);
template std::vector<std::string>
describe_loose_pieces(const CutBody<2> &, const std::vector<FloatingPiece> &);
template std::vector<std::string>
describe_loose_pieces(const CutBody<3> &, const std::vector<FloatingPiece> &);
} // namespace Setsudan
