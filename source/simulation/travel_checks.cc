// SPDX-License-Identifier: LGPL-2.1-or-later
#include <setsudan/contact/face_hats.h>
#include <setsudan/parameters/lists.h>
#include <setsudan/simulation/travel_checks.h>

#include <algorithm>
#include <limits>
#include <set>

namespace Setsudan
{
using namespace dealii;

namespace
{
/** Refuse a blade that is to go through the board. */
template <int dim>
void
check_travel_on_board(const Parameters &parameters,
                      const Scene<dim> &scene,
                      const Cut<dim> &cut)
{
  const double deepest = travel_to_board(scene.board, scene.body.mesh, cut);
  for (const auto &stop : scene.blade.path.stops)
    parameters.require(stop.position <= (1 + 1e-9) * deepest,
                       "Blade",
                       "Travel",
                       "positions of at most " + short_text(deepest) +
                         ", at which the edge meets the board in '" + cut.text +
                         "'");
}



/** Refuse a blade whose edge would be inside the body at its entry. */
template <int dim>
void
check_entry(const Parameters &parameters,
            const Scene<dim> &scene,
            const unsigned int number)
{
  const auto &mesh = scene.body.mesh;
  const auto &cuts = scene.cut.cuts;
  const auto &edge = cuts[number].edge;
  // Faces that are turned to the blade at all.
  constexpr double least_cosine = 1e-6;
  // Vertices of the body where it is open to the blade, or cut already.
  std::set<unsigned int> open;
  const auto add = [&](const CellFace &face) {
    const auto vertices = mesh.face_vertices(face);
    open.insert(vertices.begin(), vertices.end());
  };
  for (const auto &face :
       outer_faces_against(mesh, edge.direction, least_cosine))
    add(face);
  for (unsigned int earlier = 0; earlier < number; ++earlier)
    for (const auto &face : cuts[earlier].surface.faces)
      add(face.minus);
  double entry = std::numeric_limits<double>::max(), entry_when_open = entry;
  for (const auto &[vertex, travel] : travels_to_vertices(mesh, cuts[number]))
    {
      entry = std::min(entry, travel);
      if (open.count(vertex) > 0)
        entry_when_open = std::min(entry_when_open, travel);
    }
  parameters.require(
    entry_when_open <= entry + 1e-6 * mesh.extent(),
    "Cut",
    parameters.text("Cut", "Extent").empty() ? "Surfaces" : "Extent",
    "cuts that begin where the body is open to the blade where Blade/Drive is "
    "travel; '" +
      cuts[number].text + "' begins inside it");
}



/** Refuse a notch that leaves nothing to cut. */
template <int dim>
void
check_notch(const Parameters &parameters,
            const Scene<dim> &scene,
            const Cut<dim> &cut)
{
  double entry = std::numeric_limits<double>::max(), end = -entry;
  for (const auto &[vertex, travel] : travels_to_vertices(scene.body.mesh, cut))
    {
      entry = std::min(entry, travel);
      end   = std::max(end, travel);
    }
  parameters.require(scene.cut.notch < end - entry,
                     "Cut",
                     "Notch",
                     "less than " + short_text(end - entry) +
                       ", the depth of '" + cut.text + "'");
}



/** Refuse a blade that is wider than the body across a cut. */
template <int dim>
void
check_blade_fits(const Parameters &parameters,
                 const Scene<dim> &scene,
                 const Cut<dim> &cut)
{
  parameters.require(cut.edge.is_planar || scene.blade.sliding.is_guided,
                     "Blade",
                     "Guide",
                     "fixed for a cut without a plane, as '" + cut.text + "'");
  if (!cut.edge.is_planar)
    return;
  double first = std::numeric_limits<double>::max(), last = -first;
  for (const auto &vertex : scene.body.mesh.vertices)
    {
      const double across = vertex * cut.edge.normal;
      first               = std::min(first, across);
      last                = std::max(last, across);
    }
  const bool is_profile = parameters.text("Blade", "Shape") == "profile";
  parameters.require(
    scene.blade.profile.thickness() < last - first,
    "Blade",
    is_profile ? "Profile" : "Thickness",
    (is_profile
       ? "half thicknesses of less than " + short_text((last - first) / 2)
       : "less than " + short_text(last - first)) +
      ", or the blade is wider than the body is across '" + cut.text + "'");
}
} // namespace


template <int dim>
void
check_travel(const Parameters &parameters, const Scene<dim> &scene)
{
  const auto require = [&](const bool holds,
                           const std::string &subsection,
                           const std::string &name,
                           const std::string &allowed) {
    parameters.require(
      holds, subsection, name, allowed + " where Blade/Drive is travel");
  };
  require(!scene.cut.cuts.empty(), "Cut", "Surfaces", "a cut");
  for (const auto &loads : scene.blade.edge_loads)
    require(loads.empty(),
            "Blade",
            "Edge loads",
            "nothing, since the force is the reaction,");
  for (unsigned int c = 0; c < scene.cut.cuts.size(); ++c)
    {
      check_blade_fits(parameters, scene, scene.cut.cuts[c]);
      check_entry(parameters, scene, c);
      check_notch(parameters, scene, scene.cut.cuts[c]);
      check_travel_on_board(parameters, scene, scene.cut.cuts[c]);
    }
  require(scene.yield.check == YieldParameters::Check::every_row,
          "Yield",
          "Check",
          "every row");
  require(scene.division.load_control ==
            DivisionParameters::LoadControl::constant,
          "Division",
          "Load control",
          "constant");
}



template void
check_travel(const Parameters &, const Scene<2> &);
template void
check_travel(const Parameters &, const Scene<3> &);
} // namespace Setsudan
