#pragma once

#include <string>
#include <string_view>

namespace Setsudan
{
/**
 * Reads the numbers of a section of a mesh file, one behind the other, in text
 * or binary. All functions throw std::runtime_error where the section ends too
 * early or has something else.
 */
class GmshNumbers
{
public:
  /** @param content all between the section's markers; it must live on.
   * @param n_bytes of a count or number in binary sections, 4 or 8. */
  GmshNumbers(const std::string &section,
              const std::string_view &content,
              const bool is_binary,
              const unsigned int n_bytes);

  /** A count, or the number of a node or element. gmsh's limit, 2147483647, is
   * observed: it takes larger ones for others, or crashes. */
  std::size_t
  read_number();

  /** A number that is text also in binary files; it ends its line. */
  std::size_t
  read_number_of_text();

  /** A number of 4 bytes that may be negative, as those of entities. */
  int
  read_integer();

  void
  skip_reals(const std::size_t n);

  [[noreturn]] void
  throw_damaged(const std::string &how) const;

private:
  template <typename Number>
  Number
  read_bytes();

  template <typename Number>
  Number
  read_text();

  /** Move behind the next word, and return it. */
  std::string_view
  read_word();

  void
  skip_bytes(const std::size_t n);

  const std::string section;
  const std::string_view content;
  const bool is_binary;
  const unsigned int n_bytes;
  std::size_t position;
};
} // namespace Setsudan
