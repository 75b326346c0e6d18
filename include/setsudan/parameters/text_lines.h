// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <string>
#include <vector>

namespace Setsudan
{
/**
 * The lines of a text file in UTF-8. They end as on Unix, on Windows, or with
 * carriage returns only; a byte order mark before the first is no part of it.
 *
 * @param sentence_begins stands in front of messages about the file itself.
 * @throw SceneError where the file cannot be read or is in UTF-16.
 */
std::vector<std::string>
read_text_lines(const std::string &file_name,
                const std::string &sentence_begins);

/** The part of a line before its comment, which begins with a '#' at the
 * beginning of the line or behind a blank: so names of files can have one. */
std::string
without_comment(const std::string &line);

/** A character that is not of ASCII, by its code: what it looks like, if that
 * is something else, or that its bytes are no UTF-8. */
std::string
describe_character(const std::string &text, const std::size_t position);

/** A text with '?' for control characters and separators of lines other than a
 * newline: what a message quotes may be anything. */
std::string
without_control_characters(const std::string &text);

/**
 * Refuse characters that look like what a scene means and are something else,
 * as word processors and web pages put them: typographic minus signs, quotes
 * and blanks, and bytes that are no UTF-8.
 *
 * @param place of the text, in front of the column: "scene.prm:12".
 * @throw SceneError that names the first such character.
 */
void
check_characters(const std::string &text, const std::string &place);
} // namespace Setsudan
