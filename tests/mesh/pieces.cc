// SPDX-License-Identifier: LGPL-2.1-or-later
// The numbers of pieces are stable: what has been cut off gets a new one, what
// is left keeps its own.

#include <setsudan/mesh/pieces.h>

#include "../body/detach.h"
#include "../body/small_body.h"
#include "../test_setup.h"

using namespace Setsudan;

/** A row of elements along x. */
template <int dim>
CoarseMesh<dim>
row_of_elements(const unsigned int n)
{
  return SmallBody<dim>(
           {"Body/Elements=" + std::to_string(n) + (dim == 3 ? ",1,1" : ",1")})
    .body.mesh;
}


/** Detach the elements from `first` on, and print the pieces. */
template <int dim>
void
cut(CoarseMesh<dim> &mesh,
    const unsigned int first,
    std::vector<unsigned int> &pieces)
{
  std::set<unsigned int> behind;
  for (unsigned int cell = first; cell < mesh.cells.size(); ++cell)
    behind.insert(cell);
  mesh   = detach(mesh, behind);
  pieces = find_pieces(mesh, pieces);
  std::cout << "cut before " << first << ":";
  for (const unsigned int piece : pieces)
    std::cout << " " << piece;
  std::cout << std::endl;
}


template <int dim>
void
test()
{
  std::cout << dim << "D" << std::endl;
  CoarseMesh<dim> mesh             = row_of_elements<dim>(8);
  std::vector<unsigned int> pieces = find_pieces(mesh);
  for (const unsigned int first : {4, 1, 6, 2, 6, 7})
    cut(mesh, first, pieces);
  std::cout << "counted anew:";
  for (const unsigned int piece : find_pieces(mesh))
    std::cout << " " << piece;
  std::cout << std::endl;

  // Several parts at once: of the pieces 0 and 1 each.
  mesh   = row_of_elements<dim>(8);
  pieces = find_pieces(mesh);
  cut(mesh, 4, pieces);
  mesh   = detach<dim>(mesh, {1, 2, 5});
  pieces = find_pieces(mesh, pieces);
  std::cout << "several at once:";
  for (const unsigned int piece : pieces)
    std::cout << " " << piece;
  std::cout << std::endl;
}


int
main(int argc, char **argv)
{
  return run_test(argc, argv, [] {
    test<2>();
    test<3>();
  });
}
