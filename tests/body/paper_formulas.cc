// SPDX-License-Identifier: LGPL-2.1-or-later
// Equations (19) to (27) of Kakefuda et al. (1996): the elements behind a cut
// across an axis and the nodes of the cut. The paper's i and j count nodes; an
// even layer or row (between elements) and the odd one before it (through their
// middle) have the same i or j.
//
// As printed, (21) has i - 1 in its second term; there i counts an even layer
// as in (22), which needs i. All upper bounds of the nodes' i and j are one
// short.

#include <setsudan/body/box_numbering.h>

#include <array>
#include <set>

#include "../parameters/check.h"
#include "../test_setup.h"

using namespace Setsudan;

using Numbers = std::set<unsigned int>;

struct Box
{
  unsigned int nx, ny, nz;

  /** Nodes of an even and of an odd layer. */
  unsigned int
  P() const
  {
    return (2 * nx + 1) * (ny + 1) + (nx + 1) * ny;
  }
  unsigned int
  Q() const
  {
    return (nx + 1) * (ny + 1);
  }
};

struct Cut
{
  Numbers elements;
  Numbers nodes;
};


Cut
cut_across_x(const Box &b, const unsigned int dn)
{
  Cut cut;
  for (unsigned int i = 0; i < b.nz; ++i)
    for (unsigned int j = 0; j < b.ny; ++j)
      cut.elements.insert(b.nx * b.ny * i + b.nx * j + dn); // (19)
  for (unsigned int i = 1; i <= b.nz; ++i)
    for (unsigned int j = 0; j <= b.ny; ++j) // (20)
      cut.nodes.insert(b.P() * i + b.Q() * (i - 1) + (b.nx + 1) * j + dn);
  for (unsigned int i = 0; i <= b.nz; ++i)
    for (unsigned int j = 1; j <= b.ny; ++j) // (21)
      cut.nodes.insert(b.P() * i + b.Q() * i + (2 * b.nx + 1) * j +
                       (b.nx + 1) * (j - 1) + dn);
  for (unsigned int i = 0; i <= b.nz; ++i)
    for (unsigned int j = 0; j <= b.ny; ++j) // (22)
      cut.nodes.insert(b.P() * i + b.Q() * i + (2 * b.nx + 1) * j +
                       (b.nx + 1) * j + 2 * dn);
  return cut;
}


Cut
cut_across_y(const Box &b, const unsigned int dn)
{
  Cut cut;
  for (unsigned int i = 0; i < b.nz; ++i)
    for (unsigned int j = 0; j < b.nx; ++j)
      cut.elements.insert(b.nx * b.ny * i + b.nx * dn + j); // (23)
  for (unsigned int i = 1; i <= b.nz; ++i)
    for (unsigned int j = 0; j <= b.nx; ++j) // (24)
      cut.nodes.insert(b.P() * i + b.Q() * (i - 1) + (b.nx + 1) * dn + j);
  for (unsigned int i = 0; i <= b.nz; ++i)
    for (unsigned int j = 0; j <= 2 * b.nx; ++j) // (25)
      cut.nodes.insert(b.P() * i + b.Q() * i + (2 * b.nx + 1) * dn +
                       (b.nx + 1) * dn + j);
  return cut;
}


Cut
cut_across_z(const Box &b, const unsigned int dn)
{
  Cut cut;
  for (unsigned int i = 0; i < b.nx * b.ny; ++i)
    cut.elements.insert(b.nx * b.ny * dn + i); // (26)
  for (unsigned int i = 0; i < b.P(); ++i)
    cut.nodes.insert(b.P() * dn + b.Q() * dn + i); // (27)
  return cut;
}


/** The same by the program's numbering: all nodes at half-index 2 dn. */
Cut
cut_by_numbering(const Box &b, const unsigned int axis, const unsigned int dn)
{
  const std::array<unsigned int, 3> n{{b.nx, b.ny, b.nz}};
  const BoxNumbering<3> numbering(n);
  Cut cut;
  std::array<unsigned int, 3> at;
  for (at[0] = 0; at[0] <= 2 * n[0]; ++at[0])
    for (at[1] = 0; at[1] <= 2 * n[1]; ++at[1])
      for (at[2] = 0; at[2] <= 2 * n[2]; ++at[2])
        if (at[axis] == 2 * dn && at[0] % 2 + at[1] % 2 + at[2] % 2 <= 1)
          cut.nodes.insert(numbering.node_number(at));
  for (unsigned int element = 0; element < n[0] * n[1] * n[2]; ++element)
    if (numbering.element_indices(element)[axis] == dn)
      cut.elements.insert(element);
  return cut;
}


void
test(const Box &b)
{
  using Formula                         = Cut (*)(const Box &, unsigned int);
  const std::array<Formula, 3> formulas = {
    {&cut_across_x, &cut_across_y, &cut_across_z}};
  const std::array<unsigned int, 3> n = {{b.nx, b.ny, b.nz}};
  for (unsigned int axis = 0; axis < 3; ++axis)
    for (unsigned int dn = 0; dn < n[axis]; ++dn)
      {
        const Cut paper = formulas[axis](b, dn);
        const Cut own   = cut_by_numbering(b, axis, dn);
        const std::string name =
          std::string(1, "xyz"[axis]) + ":" + std::to_string(dn) + ", " +
          std::to_string(paper.elements.size()) + " elements, " +
          std::to_string(paper.nodes.size()) + " nodes";
        check(name, paper.elements == own.elements && paper.nodes == own.nodes);
      }
}


int
main(int argc, char **argv)
{
  return run_test(argc, argv, [] {
    for (const Box &box : {Box{1, 2, 1}, Box{2, 4, 4}, Box{3, 2, 4}})
      {
        std::cout << box.nx << " x " << box.ny << " x " << box.nz << std::endl;
        test(box);
      }
  });
}
