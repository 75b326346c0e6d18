// SPDX-License-Identifier: LGPL-2.1-or-later
#include <setsudan/body/gmsh/gmsh_numbers.h>
#include <setsudan/body/gmsh/gmsh_sections.h>

#include <algorithm>
#include <iterator>
#include <stdexcept>

namespace Setsudan
{
namespace
{
/** The number of nodes of gmsh's types of elements of first and second order.
 */
unsigned int
n_nodes_of_type(const int type)
{
  constexpr unsigned int n_nodes[] = {0, 2,  3,  4,  4,  8, 6, 5,  3,  6,
                                      9, 10, 27, 18, 14, 1, 8, 20, 15, 13};
  if (type < 1 || type >= int(std::size(n_nodes)))
    throw std::runtime_error("there are elements of gmsh's type " +
                             std::to_string(type) +
                             ", which are not of first or second order, or the "
                             "counts in the section $Elements are wrong");
  return n_nodes[type];
}

/** `numbers` must be sorted; mostly they have no gaps. */
bool
contains(const std::vector<unsigned int> &numbers, const std::size_t number)
{
  if (numbers.empty() || number < numbers.front())
    return false;
  const std::size_t guess = number - numbers.front();
  return (guess < numbers.size() && numbers[guess] == number) ||
         std::binary_search(numbers.begin(), numbers.end(), number);
}

void
check_count(const GmshNumbers &numbers,
            const std::string &what,
            const std::size_t announced,
            const std::size_t found)
{
  if (found != announced)
    numbers.throw_damaged("announces " + std::to_string(announced) + " " +
                          what + " and lists " + std::to_string(found));
}

/** Sort numbers, and refuse repeated ones, as gmsh leaves out what has them,
 * and 0, which gmsh does not count from. */
void
sort_unique(std::vector<unsigned int> &numbers, const std::string &what)
{
  std::sort(numbers.begin(), numbers.end());
  if (!numbers.empty() && numbers.front() == 0)
    throw std::runtime_error("the file has " + what +
                             " 0, and gmsh counts from 1; number the " + what +
                             "s anew");
  const auto twice = std::adjacent_find(numbers.begin(), numbers.end());
  if (twice != numbers.end())
    throw std::runtime_error("the file lists " + what + " " +
                             std::to_string(*twice) + " twice");
}

std::vector<unsigned int>
check_nodes_2(GmshNumbers numbers)
{
  std::vector<unsigned int> nodes;
  const std::size_t n_nodes = numbers.read_number_of_text();
  for (std::size_t i = 0; i < n_nodes; ++i)
    {
      nodes.push_back(numbers.read_number());
      numbers.skip_reals(3);
    }
  numbers.expect_end();
  return nodes;
}

std::vector<unsigned int>
check_nodes_4(GmshNumbers numbers)
{
  const std::size_t n_blocks = numbers.read_number();
  const std::size_t n_nodes  = numbers.read_number();
  const std::size_t smallest = numbers.read_number();
  const std::size_t largest  = numbers.read_number();
  std::vector<unsigned int> nodes;
  for (std::size_t block = 0; block < n_blocks; ++block)
    {
      const int dimension = numbers.read_integer();
      numbers.read_integer(); // the entity
      const bool is_parametric     = numbers.read_integer() != 0;
      const std::size_t n_in_block = numbers.read_number();
      if (dimension < 0 || dimension > 3)
        numbers.throw_damaged("names an entity of dimension " +
                              std::to_string(dimension));
      for (std::size_t i = 0; i < n_in_block; ++i)
        {
          nodes.push_back(numbers.read_number());
          if (nodes.back() < smallest || nodes.back() > largest)
            numbers.throw_damaged("has a node " + std::to_string(nodes.back()) +
                                  ", but announces nodes from " +
                                  std::to_string(smallest) + " to " +
                                  std::to_string(largest));
        }
      numbers.skip_reals(n_in_block * (is_parametric ? 3 + dimension : 3));
    }
  check_count(numbers, "nodes", n_nodes, nodes.size());
  numbers.expect_end();
  return nodes;
}

/** Walks through elements. */
class Elements
{
public:
  Elements(const GmshNumbers &numbers, const std::vector<unsigned int> &nodes)
    : numbers(numbers)
    , nodes(nodes)
  {
  }

  /** One by one: number, type, number of tags, tags, nodes. */
  void
  check_2_text()
  {
    const std::size_t n_elements = numbers.read_number_of_text();
    for (std::size_t i = 0; i < n_elements; ++i)
      {
        const std::size_t element = numbers.read_number();
        const int type            = numbers.read_integer();
        skip_tags(numbers.read_number());
        check_nodes(element, type);
      }
  }

  /** Blocks: type, number of elements, number of tags, and for each element
   * number, tags, nodes. */
  void
  check_2_binary()
  {
    const std::size_t n_elements = numbers.read_number_of_text();
    while (element_numbers.size() < n_elements)
      {
        const int type               = numbers.read_integer();
        const std::size_t n_in_block = numbers.read_number();
        const std::size_t n_tags     = numbers.read_number();
        if (n_in_block == 0)
          numbers.throw_damaged("has a block of no elements");
        for (std::size_t i = 0; i < n_in_block; ++i)
          {
            const std::size_t element = numbers.read_number();
            skip_tags(n_tags);
            check_nodes(element, type);
          }
      }
    check_count(numbers, "elements", n_elements, element_numbers.size());
  }

  /** Blocks: dimension and number of the entity, type, number of elements, and
   * for each element number, nodes. */
  void
  check_4()
  {
    const std::size_t n_blocks   = numbers.read_number();
    const std::size_t n_elements = numbers.read_number();
    numbers.read_number(); // the smallest number
    numbers.read_number(); // the largest number
    for (std::size_t block = 0; block < n_blocks; ++block)
      {
        skip_tags(2);
        const int type               = numbers.read_integer();
        const std::size_t n_in_block = numbers.read_number();
        for (std::size_t i = 0; i < n_in_block; ++i)
          check_nodes(numbers.read_number(), type);
      }
    check_count(numbers, "elements", n_elements, element_numbers.size());
  }

  /** gmsh's types of what has been checked. */
  std::set<int>
  finish()
  {
    numbers.expect_end();
    sort_unique(element_numbers, "element");
    return types;
  }

private:
  void
  skip_tags(const std::size_t n_tags)
  {
    for (std::size_t tag = 0; tag < n_tags; ++tag)
      numbers.read_integer();
  }

  void
  check_nodes(const std::size_t element, const int type)
  {
    element_numbers.push_back(element);
    types.insert(type);
    for (unsigned int i = n_nodes_of_type(type); i > 0; --i)
      {
        const std::size_t node = numbers.read_number();
        if (!contains(nodes, node))
          throw std::runtime_error("element " + std::to_string(element) +
                                   " has the node " + std::to_string(node) +
                                   ", which does not exist");
      }
  }

  GmshNumbers numbers;
  const std::vector<unsigned int> &nodes;
  std::vector<unsigned int> element_numbers;
  std::set<int> types;
};
} // namespace


std::vector<unsigned int>
check_nodes_section(const std::string &version,
                    const GmshSection &section,
                    const bool is_binary)
{
  auto nodes = version == "4.1" ? check_nodes_4({section, is_binary, 8})
                                : check_nodes_2({section, is_binary, 4});
  sort_unique(nodes, "node");
  return nodes;
}



std::set<int>
check_elements_section(const std::string &version,
                       const GmshSection &section,
                       const bool is_binary,
                       const std::vector<unsigned int> &nodes)
{
  const unsigned int n_bytes = version == "4.1" ? 8 : 4;
  Elements elements({section, is_binary, n_bytes}, nodes);
  if (version == "4.1")
    elements.check_4();
  else if (is_binary)
    elements.check_2_binary();
  else
    elements.check_2_text();
  return elements.finish();
}
} // namespace Setsudan
