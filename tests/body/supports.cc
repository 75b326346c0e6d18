// SPDX-License-Identifier: LGPL-2.1-or-later
// What is held and moved: the nodes of groups, of boxes in space, and single
// ones, found from every element that has them.

#include <setsudan/body/supports.h>
#include <setsudan/mesh/nodes.h>

#include <cmath>
#include <map>
#include <set>
#include <string>

#include "../parameters/check.h"
#include "../test_setup.h"
#include "small_body.h"

using namespace Setsudan;
using namespace dealii;

/** What some element says is held of the nodes, by their numbers. */
template <int dim>
std::map<unsigned int, NodeSupport<dim>>
held_nodes(const SmallBody<dim> &small)
{
  std::map<unsigned int, NodeSupport<dim>> nodes;
  for (unsigned int element = 0; element < small.body.mesh.cells.size();
       ++element)
    for (unsigned int node = 0; node < n_element_nodes<dim>; ++node)
      {
        const auto support =
          small.supports.at(element, unit_point_of_node<dim>(node));
        if (support.components.any())
          nodes[small.body.node_numbers[element][node]] = support;
      }
  return nodes;
}


/** Each face is the one of its name, with all of its nodes. */
template <int dim>
void
test_face(const std::string &name,
          const unsigned int axis,
          const bool at_maximum,
          const std::string &n_elements)
{
  const SmallBody<dim> small({"Body/Elements=" + n_elements,
                              dim == 3 ? "Body/Size=2,2,2" : "Body/Size=2,2",
                              "Support/Fixed faces=" + name});
  unsigned int n_wrong = 0;
  const auto fixed     = held_nodes(small);
  for (unsigned int element = 0; element < small.body.mesh.cells.size();
       ++element)
    for (unsigned int node = 0; node < n_element_nodes<dim>; ++node)
      {
        const auto position = small.body.mesh.node_position(element, node);
        const bool is_there =
          std::abs(position[axis] - (at_maximum ? 2. : 0.)) < 1e-12;
        const auto held = fixed.find(small.body.node_numbers[element][node]);
        n_wrong += is_there != (held != fixed.end());
        n_wrong += is_there && !held->second.components.all();
        n_wrong +=
          is_there && !small.supports.at(element, unit_point_of_node<dim>(node))
                         .components.all();
      }
  std::cout << dim << "D, " << name << ": " << fixed.size()
            << " nodes are fixed, " << n_wrong << " wrong" << std::endl;
}


void
test_faces()
{
  test_face<3>("left", 0, false, "2, 3, 4");
  test_face<3>("right", 0, true, "2, 3, 4");
  test_face<3>("front", 1, false, "2, 3, 4");
  test_face<3>("back", 1, true, "2, 3, 4");
  test_face<3>("bottom", 2, false, "2, 3, 4");
  test_face<3>("top", 2, true, "2, 3, 4");
  test_face<2>("left", 0, false, "2, 3");
  test_face<2>("right", 0, true, "2, 3");
  test_face<2>("bottom", 1, false, "2, 3");
  test_face<2>("top", 1, true, "2, 3");
  const auto &groups2 = SmallBody<2>(Assignments()).body.groups;
  const auto &groups3 = SmallBody<3>(Assignments()).body.groups;
  check("2D has no front", find_groups(groups2, "front").empty());
  check("names are whole",
        find_groups(groups3, "").empty() && find_groups(groups3, "to").empty());
  for (const std::string word : {"left", "3", "6"})
    std::cout << word << ": " << list_groups(find_groups(groups2, word), 2)
              << "; " << list_groups(find_groups(groups3, word), 3)
              << std::endl;
}


template <int dim>
void
print(const SmallBody<dim> &small)
{
  std::cout << "held:";
  for (const auto &[number, support] : held_nodes(small))
    {
      std::cout << " " << number;
      if (!support.components.all())
        for (unsigned int c = 0; c < dim; ++c)
          std::cout << (support.components[c] ? std::string(1, "xyz"[c]) : "");
      if (support.displacement.norm() > 0)
        std::cout << " (to " << support.displacement << ")";
    }
  std::cout << "; points of element 1:";
  for (const auto &point : small.supports.held_points({1}))
    std::cout << " (" << point.position << ")";
  std::cout << std::endl;
}


void
test_nodes()
{
  const std::string two = "Body/Elements=1, 2, 1";
  print(SmallBody<3>({two}));
  print(SmallBody<3>({two, "Support/Fixed nodes=0, 31,6 , 0"}));
  print(SmallBody<3>(
    {two, "Support/Fixed nodes=29", "Support/Fixed faces= back,back"}));
  // Points of refined elements are no nodes of the body.
  const SmallBody<3> small({two, "Support/Fixed nodes=0, 1, 2"});
  check("nodes are points",
        small.supports.at(0, Point<3>(0, 0, 0)).components.all() &&
          small.supports.at(0, Point<3>(0.25, 0, 0)).components.none());
}


/** Some components only: what several supports hold adds up. */
void
test_components()
{
  print(SmallBody<2>({"Support/Fixed components=left : x; right:y"}));
  print(SmallBody<2>({"Support/Fixed components=left : x; bottom : xy"}));
  print(SmallBody<3>({"Support/Fixed components=left:y;top:zx;2:z"}));
  print(SmallBody<2>(
    {"Support/Fixed faces=right", "Support/Fixed components=top:y"}));
}


/** All nodes in a box, with its boundary, and also those of refined cells. */
void
test_boxes()
{
  print(SmallBody<2>({"Support/Fixed boxes=0, 0, 5, 5 : xy"}));
  print(SmallBody<2>({"Support/Fixed boxes=10,10,10,10:x; 4,4,6,6:y"}));
  print(SmallBody<3>({"Support/Fixed boxes=5, 5, 0, 20, 20, 0.1 : z"}));
  const SmallBody<2> small(
    {"Support/Fixed boxes=1, 0, 2, 10 : y", "Body/Refinement=2"});
  check("refined",
        small.supports.at(0, Point<2>(0.25, 0.75)).components ==
            std::bitset<2>(2) &&
          small.supports.at(0, Point<2>(0.5, 0.75)).components.none());
}


/** A clamp moves what it holds, and lets go where it is free. */
void
test_displacements()
{
  const SmallBody<2> clamp(
    {"Support/Fixed faces=left", "Support/Displacements=right : 0.5, free"});
  print(clamp);
  check("it moves", clamp.supports.move());
  check("no contradiction", !clamp.supports.find_contradiction());
  check("nothing moves",
        !SmallBody<2>({"Support/Fixed faces=left",
                       "Support/Displacements=right : 0, free"})
           .supports.move());

  // The clamps share nodes with what is fixed, or with each other.
  for (const std::string other : {"Support/Fixed faces=top",
                                  "Support/Fixed components=top : y",
                                  "Support/Fixed nodes=12",
                                  "Support/Fixed boxes=8,8,10,10 : x"})
    {
      const SmallBody<2> both(
        {"Support/Displacements=right : 0.5, free", other});
      const auto point = both.supports.find_contradiction();
      std::cout << other << ": ";
      if (point)
        std::cout << "contradiction at (" << *point << ")" << std::endl;
      else
        std::cout << "agrees" << std::endl;
    }
  for (const std::string other : {"0.5, 1", "0.5, free", "free, 2", "1, 2"})
    std::cout << "top : " << other << ": "
              << (SmallBody<2>({"Support/Displacements=right : 0.5, free; "
                                "top : " +
                                other})
                      .supports.find_contradiction()
                    ? "contradiction"
                    : "agrees")
              << std::endl;
}


void
test_refusals()
{
  for (const std::string wrong :
       {"Support/Fixed faces=bottom, floor", "Support/Fixed nodes=0, 32"})
    print_refusal([&] { SmallBody<3>({"Body/Elements=1, 2, 1", wrong}); });
  print_refusal([] { SmallBody<2>({"Support/Fixed faces=front"}); });
  print_refusal([] { SmallBody<3>({"Body/Size=1, -2, 1"}); });
  print_refusal([] { SmallBody<3>({"Body/Elements=90000, 90000, 9"}); });
  for (const std::string wrong : {"Support/Fixed components=left",
                                  "Support/Fixed components=left : xz",
                                  "Support/Fixed components=floor : x",
                                  "Support/Fixed boxes=0, 0, 1 : x",
                                  "Support/Fixed boxes=0, 0, 1, -1 : x",
                                  "Support/Fixed boxes=0, 0, 1, 1",
                                  "Support/Displacements=left : 1",
                                  "Support/Displacements=left : free, free",
                                  "Support/Displacements=left : 1, up",
                                  "Support/Displacements=floor : 1, 1"})
    print_refusal([&] { SmallBody<2>({wrong}); });
}


int
main(int argc, char **argv)
{
  return run_test(argc, argv, [] {
    test_faces();
    test_nodes();
    test_components();
    test_boxes();
    test_displacements();
    test_refusals();
  });
}
