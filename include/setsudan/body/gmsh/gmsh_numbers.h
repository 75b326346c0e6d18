// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <deal.II/base/point.h>

#include <setsudan/body/gmsh/gmsh_sections.h>

#include <algorithm>
#include <charconv>
#include <cmath>
#include <cstdint>
#include <cstring>
#include <string>
#include <string_view>
#include <type_traits>
#include <vector>

namespace Setsudan
{
/**
 * Reads the numbers of a section of a mesh file, one behind the other, in text
 * or binary. All functions throw BodyFileError where the section ends too early
 * or has something else. They are here to be compiled into the loops that call
 * them for every number.
 */
class GmshNumbers
{
public:
  /** @param section must live on, with its file. */
  GmshNumbers(const GmshSection &section, const GmshFormat &format)
    : section(section)
    , format(format)
    // Bytes begin behind the line of the section's name.
    , position(format.is_binary ? section.content.find('\n') + 1 : 0)
  {
  }

  /** A count, or the number of a node or element. gmsh's limit is observed. */
  std::size_t
  read_number()
  {
    const std::uint64_t number = format.is_binary && !format.is_version_4
                                   ? read<std::uint32_t>()
                                   : read<std::uint64_t>();
    if (number > 2147483647)
      section.throw_damaged("has the number " + std::to_string(number) +
                            ", but gmsh's largest is 2147483647");
    return number;
  }

  /** How many nodes or elements version 2.2 announces, in text also in binary
   * files; it ends its line. */
  std::size_t
  read_count_2()
  {
    const auto number = parse<std::uint32_t>(take_word());
    take(format.is_binary ? 1 : 0);
    return number;
  }

  /** Numbers of 4 bytes that may be negative, as those of entities. */
  int
  read_integer()
  {
    return read<std::int32_t>();
  }

  std::vector<int>
  read_integers(const std::size_t n)
  {
    std::vector<int> integers;
    for (std::size_t i = 0; i < n; ++i)
      integers.push_back(read_integer());
    return integers;
  }

  /** Three coordinates, which must be finite in text. */
  dealii::Point<3>
  read_point()
  {
    dealii::Point<3> point;
    for (unsigned int d = 0; d < 3; ++d)
      point[d] = read<double>();
    return point;
  }

  /** Read over real numbers, whatever they are. */
  void
  skip_reals(const std::size_t n)
  {
    for (std::size_t i = 0; i < n; ++i)
      format.is_binary ? take(sizeof(double)) : take_word();
  }

  /** Check that nothing is left, which others would not read. */
  void
  expect_end()
  {
    skip_spaces();
    if (position < section.content.size())
      section.throw_damaged(
        "has more numbers than it announces" +
        (format.is_binary ? "" : " (" + section.place(position) + ")"));
  }

  const GmshSection &section;
  const GmshFormat format;

private:
  template <typename Number>
  Number
  read()
  {
    if (!format.is_binary)
      return parse<Number>(take_word());
    Number number;
    std::memcpy(&number, take(sizeof(Number)).data(), sizeof(Number));
    return number;
  }

  template <typename Number>
  Number
  parse(const std::string_view &word) const
  {
    constexpr bool is_real     = std::is_floating_point_v<Number>;
    const char *const word_end = word.data() + word.size();
    Number number              = 0;
    const auto [end, error]    = std::from_chars(
      word.data() + (is_real && word[0] == '+'), word_end, number);
    if (error != std::errc() || end != word_end ||
        !std::isfinite(double(number)))
      section.throw_no_number(word, is_real ? "finite" : "whole");
    return number;
  }

  void
  skip_spaces()
  {
    while (position < section.content.size() && is_space(position))
      ++position;
  }

  bool
  is_space(const std::size_t at) const
  {
    const char character = section.content[at];
    return character == ' ' || (character >= '\t' && character <= '\r');
  }

  std::string_view
  take_word()
  {
    skip_spaces();
    std::size_t end = position;
    while (end < section.content.size() && !is_space(end))
      ++end;
    return take(std::max<std::size_t>(end - position, 1));
  }

  std::string_view
  take(const std::size_t n_bytes)
  {
    if (n_bytes > section.content.size() - position)
      section.throw_damaged("has fewer numbers than it announces");
    position += n_bytes;
    return section.content.substr(position - n_bytes, n_bytes);
  }

  std::size_t position;
};
} // namespace Setsudan
