#include <setsudan/body/gmsh_numbers.h>

#include <charconv>
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
} // namespace


GmshNumbers::GmshNumbers(const std::string &section,
                         const std::string_view &content,
                         const bool is_binary,
                         const unsigned int n_bytes)
  : section(section)
  , content(content)
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
      read_word();
}



void
GmshNumbers::throw_damaged(const std::string &how) const
{
  throw std::runtime_error("the file is damaged: its section " + section + " " +
                           how);
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
  const char *const word_end  = word.data() + word.size();
  const auto [end, error]     = std::from_chars(word.data(), word_end, number);
  if (error != std::errc() || end != word_end)
    throw_damaged("has '" + std::string(word) + "' where a number must be");
  return number;
}



std::string_view
GmshNumbers::read_word()
{
  while (position < content.size() && is_space(content[position]))
    ++position;
  const std::size_t begin = position;
  while (position < content.size() && !is_space(content[position]))
    ++position;
  if (begin == position)
    throw_damaged("has fewer numbers than it announces");
  return content.substr(begin, position - begin);
}



void
GmshNumbers::skip_bytes(const std::size_t n)
{
  if (n > content.size() - position)
    throw_damaged("has fewer numbers than it announces");
  position += n;
}
} // namespace Setsudan
