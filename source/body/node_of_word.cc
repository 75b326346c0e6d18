// SPDX-License-Identifier: LGPL-2.1-or-later
#include <setsudan/body/node_of_word.h>
#include <setsudan/parameters/lists.h>

#include <algorithm>
#include <limits>

namespace Setsudan
{
using namespace dealii;

namespace
{
/** Whether a node is a corner of elements. */
template <int dim>
bool
is_corner(const Body<dim> &body, const unsigned int number)
{
  return std::any_of(body.node_numbers.begin(),
                     body.node_numbers.end(),
                     [&](const auto &of_element) {
                       const auto end = of_element.begin() +
                                        GeometryInfo<dim>::vertices_per_cell;
                       return std::find(of_element.begin(), end, number) != end;
                     });
}
} // namespace



template <int dim>
unsigned int
node_of_word(const Parameters &parameters,
             const std::string &subsection,
             const std::string &name,
             const Body<dim> &body,
             const std::string &word)
{
  const auto require = [&](const bool condition, const std::string &allowed) {
    parameters.require(condition, subsection, name, allowed);
  };
  const std::string others =
    (body.box ? "node numbers from 0 to " + std::to_string(body.n_nodes() - 1)
              : "node numbers of the file") +
    ", and '" + word + "' is none";
  std::vector<double> value;
  require(parse_numbers(word, value) && value.size() == 1 && value[0] >= 0 &&
            value[0] < std::numeric_limits<unsigned int>::max() &&
            value[0] == static_cast<unsigned int>(value[0]),
          others);
  const auto number = static_cast<unsigned int>(value[0]);
  require(!std::binary_search(
            body.unused_nodes.begin(), body.unused_nodes.end(), number),
          "nodes of the body's elements, and node " + word +
            " of the file belongs to none of them");
  require(body.has_node(number), others);
  require(body.has_middle_nodes || is_corner(body, number),
          "corners of elements, since Body/Element type = linear has no other "
          "nodes, and node " +
            word + " lies in the middle of a line");
  return number;
}



template unsigned int
node_of_word(const Parameters &,
             const std::string &,
             const std::string &,
             const Body<2> &,
             const std::string &);
template unsigned int
node_of_word(const Parameters &,
             const std::string &,
             const std::string &,
             const Body<3> &,
             const std::string &);
} // namespace Setsudan
