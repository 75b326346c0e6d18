// SPDX-License-Identifier: LGPL-2.1-or-later
// Parts of a body that share lines or points only: held by their supports, by
// each other, or free to move.

#include <setsudan/body/gmsh/gmsh_file.h>
#include <setsudan/mechanics/pieces/hinges.h>

#include "../body/gmsh_text.h"
#include "../body/small_body.h"
#include "../test_setup.h"

using namespace Setsudan;

void
test(const std::string &name,
     const TextMesh &mesh,
     const std::string &fixed_nodes)
{
  const SmallBody<3> small(
    {"Body/Shape=file",
     "Body/File=" + write_text("hinges.msh", mesh.text()),
     "Support/Fixed nodes=" + fixed_nodes});
  std::cout
    << name << ": "
    << describe_loose_part(small.body, small.supports).value_or("all is held")
    << std::endl;
}


/** The upper cube keeps `shared` of its lower nodes, and gets others for the
 * rest. */
TextMesh
cubes_that_share(const std::vector<unsigned int> &shared)
{
  auto mesh = two_cubes();
  for (unsigned int node = 5; node <= 8; ++node)
    if (std::find(shared.begin(), shared.end(), node) == shared.end())
      {
        mesh.nodes[node + 20]            = mesh.nodes[node];
        mesh.elements[1].nodes[node - 5] = node + 20;
      }
  return mesh;
}


int
main(int argc, char **argv)
{
  return run_test(argc, argv, [] {
    const std::string below = "1, 2, 3, 4";
    test("joined by a face", cubes_that_share({5, 6, 7, 8}), below);
    test("joined by three corners", cubes_that_share({5, 6, 7}), below);
    test("joined by a line", cubes_that_share({5, 6}), below);
    test(
      "joined by a line, held above", cubes_that_share({5, 6}), "1,2,3,4,11");
    test("joined by a point", cubes_that_share({7}), below);
    test("joined by a point, held above",
         cubes_that_share({7}),
         "1,2,3,4,9,10,11");
    test("not joined", cubes_that_share({}), below);
    test("not joined, both held", cubes_that_share({}), "1,2,3,9,10,11");
  });
}
