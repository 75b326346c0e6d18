// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <setsudan/body/gmsh/text_file.h>

#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

namespace Setsudan
{
/** A part of a mesh file, from `$Name` to `$EndName`. */
struct GmshSection
{
  std::string name;
  /** All between the two, a part of the file's text. */
  std::string_view content;
  const TextFile *file;

  /** Where something is in its content, for messages. */
  std::string
  place(const std::ptrdiff_t position) const;

  [[noreturn]] void
  throw_damaged(const std::string &how) const;

  /** @param kind of the number that must be where the word is. */
  [[noreturn]] void
  throw_no_number(const std::string_view &word, const std::string &kind) const;
};

/** How a mesh file writes its numbers. */
struct GmshFormat
{
  /** Version 4.1, and 2.2 otherwise. */
  bool is_version_4;
  bool is_binary;
};

/**
 * The sections of a mesh file, which must live on.
 *
 * @throw BodyFileError where one has no end, lacks though every mesh has it, or
 * stands there twice or in a place where gmsh would not read it.
 */
std::vector<GmshSection>
split_sections(const TextFile &file);

/** @throw BodyFileError where it is none that can be read. */
GmshFormat
parse_format(const GmshSection &section);
} // namespace Setsudan
