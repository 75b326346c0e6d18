// What is fixed: the nodes of faces and single nodes, found from every element
// that has them.

#include <setsudan/body/nodes.h>
#include <setsudan/body/supports.h>

#include <cmath>
#include <set>
#include <string>

#include "../parameters/check.h"
#include "../test_setup.h"
#include "small_body.h"

using namespace Setsudan;
using namespace dealii;

/** The numbers of the nodes that some element says are fixed. */
template <int dim>
std::set<unsigned int>
fixed_nodes(const SmallBody<dim> &small)
{
  std::set<unsigned int> numbers;
  for (unsigned int element = 0; element < small.body.mesh.cells.size();
       ++element)
    for (unsigned int node = 0; node < n_element_nodes<dim>; ++node)
      if (small.supports.is_fixed(element, node))
        numbers.insert(small.body.numbering.node_number(element, node));
  return numbers;
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
  const auto fixed     = fixed_nodes(small);
  for (unsigned int element = 0; element < small.body.mesh.cells.size();
       ++element)
    for (unsigned int node = 0; node < n_element_nodes<dim>; ++node)
      {
        const auto position = small.body.mesh.node_position(element, node);
        const bool is_there =
          std::abs(position[axis] - (at_maximum ? 2. : 0.)) < 1e-12;
        const unsigned int number =
          small.body.numbering.node_number(element, node);
        n_wrong += is_there != (fixed.count(number) > 0);
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
  types::boundary_id id;
  check("2D has no front", !find_face<2>("front", id));
  check("names are whole", !find_face<3>("", id) && !find_face<3>("to", id));
  std::cout << face_names<2>() << "; " << face_names<3>() << std::endl;
}


void
print(const SmallBody<3> &small)
{
  std::cout << "fixed:";
  for (const unsigned int number : fixed_nodes(small))
    std::cout << " " << number;
  std::cout << "; points of element 1:";
  for (const auto &point : small.supports.fixed_points({1}))
    std::cout << " (" << point << ")";
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
}


void
test_refusals()
{
  for (const std::string &wrong :
       {"Support/Fixed faces=bottom, floor", "Support/Fixed nodes=0, 32"})
    print_refusal([&] { SmallBody<3>({"Body/Elements=1, 2, 1", wrong}); });
  print_refusal([] { SmallBody<2>({"Support/Fixed faces=front"}); });
  print_refusal([] { SmallBody<3>({"Body/Size=1, -2, 1"}); });
  print_refusal([] { SmallBody<3>({"Body/Elements=90000, 90000, 9"}); });
}


int
main(int argc, char **argv)
{
  return run_test(argc, argv, [] {
    test_faces();
    test_nodes();
    test_refusals();
  });
}
