// SPDX-License-Identifier: LGPL-2.1-or-later
// Slits, which end inside the body, and cuts across them, in both orders: the
// tip stays joined, and both orders give the same pieces.

#include <setsudan/cut/surface/mesh_surgery.h>
#include <setsudan/cut/surface/surface_choice.h>
#include <setsudan/simulation/scene.h>

#include <string>

#include "../test_setup.h"
#include "topology.h"

using namespace Setsudan;
using namespace dealii;

/** Make the cuts of a body of 2 x 4 x 4 elements (in 2D 4 x 4), of edge 10. */
template <int dim>
void
cut(const std::string &surfaces,
    const std::string &extents,
    const std::string &directions)
{
  const Parameters parameters(
    "test",
    {{"Body", "Elements", dim == 3 ? "2,4,4" : "4,4", ""},
     {"Support", "Fixed faces", "bottom", ""},
     {"Blade", "Direction", directions, ""},
     {"Cut", "Surfaces", surfaces, ""},
     {"Cut", "Extent", extents, ""}},
    Scene<dim>::declare);
  const Scene<dim> scene(parameters);
  CoarseMesh<dim> mesh             = scene.body.mesh;
  std::vector<unsigned int> pieces = find_pieces(mesh);
  std::cout << dim << "D, " << surfaces << " within " << extents << std::endl;
  for (const auto &one : scene.cut.cuts)
    {
      mesh   = split_mesh(mesh, one.surface.faces);
      pieces = find_pieces(mesh, pieces);
      std::cout << "  " << one.text << ": " << one.surface.faces.size()
                << " faces, then " << mesh.vertices.size() << " vertices, "
                << n_boundary_faces(mesh) << " faces on the boundary"
                << std::endl;
    }
  for (const auto &piece : topology_of_pieces(mesh, pieces))
    std::cout << "  " << piece << std::endl;
}


/** The slit goes down to half of the height. */
void
test_crossings()
{
  const std::string down = "0, 0, -1", back = "0, -1, 0";
  const std::string slit = "depth : 5", all = "all";
  const std::string first = slit + "; " + all, second = all + "; " + slit;
  // Across the slit and beyond it.
  cut<3>("y:2; x:1", first, down);
  cut<3>("x:1; y:2", second, down);
  // Across the slit, where it divides the part above; then right at its tip.
  cut<3>("y:2; z:3", first, down + ";" + back);
  cut<3>("z:3; y:2", second, back + ";" + down);
  cut<3>("y:2; z:2", first, down + ";" + back);
  cut<3>("z:2; y:2", second, back + ";" + down);
  // Below its tip they do not meet.
  cut<3>("y:2; z:1", first, down + ";" + back);
  cut<3>("z:1; y:2", second, back + ";" + down);
  // Two slits through each other.
  cut<3>("y:2; x:1", slit, down);
  cut<3>("x:1; y:2", slit, down);
  cut<2>("x:2; y:3", first, "0, -1; -1, 0");
  cut<2>("y:3; x:2", second, "-1, 0; 0, -1");
  cut<2>("x:2; y:2", first, "0, -1; -1, 0");
  cut<2>("y:2; x:2", second, "-1, 0; 0, -1");
}


/** Faces inside a body of 4 x 4 x 4 elements in the plane y = 2, from x and z
 * to x and z. */
void
cut_inside(const std::string &name,
           const double x0,
           const double z0,
           const double x1,
           const double z1)
{
  const Body<3> body = make_box<3>(Point<3>(4, 4, 4), {{4, 4, 4}});
  CutSurface<3> surface;
  for (const auto &face : LayerBoundary<3>(1, 2).choose(body).faces)
    {
      const auto center = body.mesh.cell_center(face.plus.first);
      if (center[0] > x0 && center[0] < x1 && center[2] > z0 && center[2] < z1)
        surface.push_back(face);
    }
  const auto mesh   = split_mesh(body.mesh, surface);
  const auto pieces = find_pieces(mesh);
  std::cout << name << ": " << surface.size() << " faces, of which "
            << joined_faces(mesh, surface).size() << " stay joined"
            << std::endl;
  for (const auto &piece : topology_of_pieces(mesh, pieces))
    std::cout << "  " << piece << std::endl;
}


int
main(int argc, char **argv)
{
  return run_test(argc, argv, [] {
    test_crossings();
    // One node is divided, which makes a bubble; or a line of nodes through
    // the body, which makes a hole.
    cut_inside("inside", 1, 1, 3, 3);
    cut_inside("through the body", 1, 0, 3, 4);
    // All nodes stay joined around the end of the cut.
    cut_inside("one face", 1, 1, 2, 2);
    cut_inside("a strip", 1, 0, 2, 4);
  });
}
