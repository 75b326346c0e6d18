// SPDX-License-Identifier: LGPL-2.1-or-later
#include <setsudan/body/gmsh/gmsh_numbers.h>
#include <setsudan/parameters/text_lines.h>

#include <charconv>
#include <cmath>
#include <cstdint>
#include <cstring>
#include <limits>
#include <stdexcept>

namespace Setsudan
{
namespace
{
bool
is_space(const char character)
{
  return character == ' ' || (character >= '\t' && character <= '\r');
}

/** Read a whole word as a number; false where it is none. */
template <typename Number>
bool
parse(const std::string_view &word, Number &number)
{
  const char *const word_end = word.data() + word.size();
  const auto [end, error]    = std::from_chars(word.data(), word_end, number);
  return error == std::errc() && end == word_end;
}

/** What may be wrong with a word that is no number, at its first character that
 * is in none. */
std::string
describe_slip(const std::string_view &word)
{
  const std::size_t slip = word.find_first_not_of("+-.0123456789eE");
  if (slip == std::string_view::npos)
    return "";
  if (word[slip] == ',')
    return "; decimals stand behind a point";
  if (slip > 0 && (word[slip] == 'D' || word[slip] == 'd'))
    return "; exponents stand behind an E";
  if (is_foreign(word[slip]))
    return "; there is " + describe_character(std::string(word), slip);
  return "";
}
} // namespace


std::string
GmshSection::place() const
{
  return file->place(content.data() - name.size() - 1);
}



GmshNumbers::GmshNumbers(const GmshSection &section,
                         const bool is_binary,
                         const unsigned int n_bytes)
  : section(section)
  , content(section.content)
  , is_binary(is_binary)
  , n_bytes(n_bytes)
  // Bytes begin behind the line of the section's name.
  , position(is_binary ? content.find('\n') + 1 : 0)
{
}



std::size_t
GmshNumbers::read_number()
{
  const std::uint64_t number = !is_binary     ? read_text<std::uint64_t>()
                               : n_bytes == 4 ? read_bytes<std::uint32_t>()
                                              : read_bytes<std::uint64_t>();
  if (number > std::uint64_t(std::numeric_limits<std::int32_t>::max()))
    throw_damaged("has the number " + std::to_string(number) +
                  ", but gmsh's largest is 2147483647");
  return number;
}



std::size_t
GmshNumbers::read_number_of_text()
{
  const auto number = read_text<std::uint32_t>();
  if (is_binary)
    skip_bytes(1);
  return number;
}



int
GmshNumbers::read_integer()
{
  return is_binary ? read_bytes<std::int32_t>() : read_text<std::int32_t>();
}



void
GmshNumbers::skip_reals(const std::size_t n)
{
  if (is_binary)
    skip_bytes(n * sizeof(double));
  else
    for (std::size_t i = 0; i < n; ++i)
      {
        const std::string_view word = read_word();
        double number;
        if (!parse(word.substr(word[0] == '+'), number) ||
            !std::isfinite(number))
          throw_no_number(word, "a finite number");
      }
}



void
GmshNumbers::expect_end()
{
  skip_spaces();
  if (position < content.size())
    throw_damaged(
      "has more numbers than it announces" +
      (is_binary ? "" : " (" + section.file->place(&content[position]) + ")"));
}



void
GmshNumbers::throw_damaged(const std::string &how) const
{
  throw std::runtime_error("the file is damaged: its section $" + section.name +
                           " " + how);
}



template <typename Number>
Number
GmshNumbers::read_bytes()
{
  Number number;
  skip_bytes(sizeof(Number));
  std::memcpy(
    &number, content.data() + position - sizeof(Number), sizeof(Number));
  return number;
}



template <typename Number>
Number
GmshNumbers::read_text()
{
  Number number               = 0;
  const std::string_view word = read_word();
  if (!parse(word, number))
    throw_no_number(word, "a whole number");
  return number;
}



void
GmshNumbers::skip_spaces()
{
  while (position < content.size() && is_space(content[position]))
    ++position;
}



std::string_view
GmshNumbers::read_word()
{
  skip_spaces();
  const std::size_t begin = position;
  while (position < content.size() && !is_space(content[position]))
    ++position;
  if (begin == position)
    throw_damaged("has fewer numbers than it announces");
  return content.substr(begin, position - begin);
}



void
GmshNumbers::throw_no_number(const std::string_view &word,
                             const std::string &what) const
{
  throw_damaged("has '" + std::string(word) + "' where " + what + " must be (" +
                section.file->place(word.data()) + ")" + describe_slip(word));
}



void
GmshNumbers::skip_bytes(const std::size_t n)
{
  if (n > content.size() - position)
    throw_damaged("has fewer numbers than it announces");
  position += n;
}
} // namespace Setsudan
