// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <setsudan/body/gmsh/text_file.h>

#include <string>
#include <string_view>

namespace Setsudan
{
/** A part of a mesh file, from `$Name` to `$EndName`. */
struct GmshSection
{
  std::string name;
  /** All between the two, a part of the file's text. */
  std::string_view content;
  const TextFile *file;

  /** Where it begins, for messages. */
  std::string
  place() const;
};

/**
 * Reads the numbers of a section of a mesh file, one behind the other, in text
 * or binary. All functions throw std::runtime_error where the section ends too
 * early or has something else.
 */
class GmshNumbers
{
public:
  /** @param section must live on, with its file.
   * @param n_bytes of a count or number in binary sections, 4 or 8. */
  GmshNumbers(const GmshSection &section,
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

  /** Read over numbers, which must be finite in text. */
  void
  skip_reals(const std::size_t n);

  /** Check that nothing is left: gmsh would not read it. */
  void
  expect_end();

  [[noreturn]] void
  throw_damaged(const std::string &how) const;

private:
  template <typename Number>
  Number
  read_bytes();

  template <typename Number>
  Number
  read_text();

  /** Move to the next word, if there is one. */
  void
  skip_spaces();

  /** Move behind the next word, and return it. */
  std::string_view
  read_word();

  [[noreturn]] void
  throw_no_number(const std::string_view &word, const std::string &what) const;

  void
  skip_bytes(const std::size_t n);

  const GmshSection &section;
  const std::string_view content;
  const bool is_binary;
  const unsigned int n_bytes;
  std::size_t position;
};
} // namespace Setsudan
