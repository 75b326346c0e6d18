// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <string>
#include <string_view>

namespace Setsudan
{
/** A file's text, and its name for messages. */
struct TextFile
{
  std::string name;
  std::string text;

  /** A place in the text as `name:line:column`; columns count characters. */
  std::string
  place(const char *const at) const;
};

/** @throw BodyFileError where the file does not exist, cannot be read or is
 * empty. */
TextFile
read_text_file(const std::string &file_name);

/** Whether a byte belongs to a character that is not of ASCII. */
bool
is_foreign(const char character);

/**
 * Check that a text is in ASCII or UTF-8 and has lines.
 *
 * @throw BodyFileError where it is in UTF-16, or its lines end with carriage
 * returns only.
 */
void
check_encoding(const TextFile &file);

/**
 * Check that outside of its comments and strings a geometry has only characters
 * of ASCII, and that no comment goes on behind a carriage return.
 *
 * @throw BodyFileError that names the first one and its place.
 */
void
check_characters_of_geometry(const TextFile &file);
} // namespace Setsudan
