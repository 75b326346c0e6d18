// SPDX-License-Identifier: LGPL-2.1-or-later
#include <setsudan/contact/entry_hats.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

namespace Setsudan
{
using namespace dealii;

namespace
{
/** What lies nearer to the cut's plane than this part of the body's extent is
 * on it. */
constexpr double on_plane = 1e-6;

/** Whether a blade has flanks from the edge on that press normally. */
bool
is_wedge(const BladeProfile &profile)
{
  return !profile.presses_across && !profile.facets.empty() &&
         profile.facets[0].half_thickness == 0 && profile.facets[0].slope > 0;
}



/** Outer faces that look against the blade, on the minus and on the plus side
 * of the plane through a point; faces that cross it are of neither. */
template <int dim>
std::array<std::vector<CellFace>, 2>
faces_against(const CoarseMesh<dim> &mesh,
              const BladeEdge<dim> &edge,
              const Point<dim> &on_cut,
              const std::function<bool(unsigned int)> &is_there)
{
  std::array<std::vector<CellFace>, 2> sides;
  const double tolerance = on_plane * mesh.extent();
  for (const auto &face : outer_faces_against(mesh, edge.direction))
    {
      if (!is_there(face.first))
        continue;
      double lowest  = std::numeric_limits<double>::max();
      double highest = std::numeric_limits<double>::lowest();
      for (const unsigned int vertex : mesh.face_vertices(face))
        {
          const double offset = (mesh.vertices[vertex] - on_cut) * edge.normal;
          lowest              = std::min(lowest, offset);
          highest             = std::max(highest, offset);
        }
      if (lowest >= -tolerance)
        sides[1].push_back(face);
      else if (highest <= tolerance)
        sides[0].push_back(face);
    }
  return sides;
}
} // namespace


template <int dim>
std::vector<EntryHat<dim>>
entry_hats(const ElasticModel<dim> &model,
           const CoarseMesh<dim> &uncut,
           const Seam<dim> &seam,
           const BladeEdge<dim> &edge,
           const BladeProfile &profile,
           const std::function<bool(unsigned int)> &is_there)
{
  const auto &pairs = seam.pairs();
  if (!is_wedge(profile) || !edge.is_planar || pairs.empty())
    return {};
  const Point<dim> on_cut = pairs[0].position;
  const double tolerance  = on_plane * uncut.extent();
  for (const auto &pair : pairs)
    if (std::abs((pair.position - on_cut) * edge.normal) > tolerance)
      return {};
  const double entry = travels_of_pairs(pairs, edge)[0];
  const double reach = profile.thickness() / 2;
  const double slope = profile.facets[0].slope;
  const auto sides   = faces_against(uncut, edge, on_cut, is_there);
  std::vector<EntryHat<dim>> hats;
  for (const bool is_plus : {false, true})
    for (const auto &hat : face_hats(model, sides[is_plus]))
      {
        const double offset = std::abs((hat.center - on_cut) * edge.normal);
        const double depth  = edge.travel(hat.center) - entry;
        if (offset < reach && offset + slope * depth >= -tolerance)
          hats.push_back({hat, is_plus, offset, depth});
      }
  return hats;
}



#define INSTANTIATE(dim)                          \
  template std::vector<EntryHat<dim>> entry_hats( \
    const ElasticModel<dim> &,                    \
    const CoarseMesh<dim> &,                      \
    const Seam<dim> &,                            \
    const BladeEdge<dim> &,                       \
    const BladeProfile &,                         \
    const std::function<bool(unsigned int)> &);

INSTANTIATE(2)
INSTANTIATE(3)

#undef INSTANTIATE
} // namespace Setsudan
