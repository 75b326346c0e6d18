// SPDX-License-Identifier: LGPL-2.1-or-later
#include <setsudan/parameters/scene_file.h>
#include <setsudan/parameters/text_lines.h>

#include <algorithm>
#include <cstdio>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <optional>

namespace Setsudan
{
namespace
{
bool
begins_with(const std::string &text, const std::string &beginning)
{
  return text.compare(0, beginning.size(), beginning) == 0;
}

std::string
read_bytes(const std::string &file_name, const std::string &sentence_begins)
{
  // A directory opens as a stream but cannot be read.
  std::ifstream stream(file_name, std::ios::binary);
  if (!stream || std::filesystem::is_directory(file_name))
    throw SceneError(sentence_begins + "The scene file '" + file_name +
                     "' cannot be read.");
  return {std::istreambuf_iterator<char>(stream), {}};
}
} // namespace


std::vector<std::string>
read_text_lines(const std::string &file_name,
                const std::string &sentence_begins)
{
  std::string bytes = read_bytes(file_name, sentence_begins);
  // Without a mark, its characters have a byte that is 0.
  const std::string beginning = bytes.substr(0, 2);
  if (begins_with(bytes, "\xff\xfe") || begins_with(bytes, "\xfe\xff") ||
      beginning.find('\0') != std::string::npos)
    throw SceneError(file_name + ": the file is in UTF-16, and must be text in "
                                 "UTF-8; save it anew as that.");
  if (begins_with(bytes, "\xef\xbb\xbf"))
    bytes.erase(0, 3);
  std::vector<std::string> lines(1);
  for (std::size_t i = 0; i < bytes.size(); ++i)
    if (bytes[i] != '\n' && bytes[i] != '\r')
      lines.back() += bytes[i];
    else
      {
        lines.emplace_back();
        if (bytes[i] == '\r' && i + 1 < bytes.size() && bytes[i + 1] == '\n')
          ++i;
      }
  // The end of the last line does not begin another.
  if (lines.back().empty())
    lines.pop_back();
  return lines;
}



std::string
without_comment(const std::string &line)
{
  std::size_t position = line.find('#');
  while (position != std::string::npos && position > 0 &&
         line[position - 1] != ' ' && line[position - 1] != '\t')
    position = line.find('#', position + 1);
  return line.substr(0, position);
}



namespace
{
/** A character of more than one byte, and how many it has; 0 where they are no
 * UTF-8. */
struct Character
{
  char32_t code     = 0;
  unsigned int size = 0;
};

Character
decode(const std::string &text, const std::size_t position)
{
  const auto byte = [&](const std::size_t i) -> unsigned char {
    return position + i < text.size() ? text[position + i] : 0;
  };
  const unsigned int size = byte(0) >= 0xf0   ? 4
                            : byte(0) >= 0xe0 ? 3
                            : byte(0) >= 0xc2 ? 2
                                              : 0;
  Character character{char32_t(byte(0) & (0xff >> (size + 1))), size};
  for (unsigned int i = 1; i < size; ++i)
    {
      if ((byte(i) & 0xc0) != 0x80)
        return {};
      character.code = character.code << 6 | (byte(i) & 0x3f);
    }
  return character;
}

struct Range
{
  char32_t first, last;
  const char *description;
};

/** What characters look like that are none of a scene's; nothing for all
 * others. */
std::optional<std::string>
describe_alike(const char32_t code)
{
  constexpr Range ranges[] = {
    {0x80, 0x9f, "a control character; take it out"},
    {0xa0, 0xa0, "a no-break space; write a blank"},
    {0xb4, 0xb4, "an accent; write '"},
    {0x2bc, 0x2bc, "a typographic apostrophe; write '"},
    {0x2000, 0x200a, "a typographic space; write a blank"},
    {0x200b, 0x200f, "invisible; take it out"},
    {0x2010, 0x2015, "a typographic hyphen or dash; write -"},
    {0x2018, 0x201b, "a typographic apostrophe or quotation mark; write '"},
    {0x201c, 0x201f, "a typographic quotation mark; take it out"},
    {0x2028, 0x2029, "a separator of lines; end the line instead"},
    {0x202a, 0x202e, "invisible; take it out"},
    {0x202f, 0x202f, "a no-break space; write a blank"},
    {0x2032, 0x2035, "a prime; write '"},
    {0x205f, 0x205f, "a typographic space; write a blank"},
    {0x2060, 0x2064, "invisible; take it out"},
    {0x2212, 0x2212, "a typographic minus sign; write -"},
    {0x3000, 0x3000, "an ideographic space; write a blank"},
    {0x3001, 0x3001, "an ideographic comma; write ,"},
    {0x3002, 0x3002, "an ideographic full stop; write ."},
    {0xfe63, 0xfe63, "a small hyphen; write -"},
    {0xfeff, 0xfeff, "a byte order mark within the file; take it out"}};
  if (code >= 0xff01 && code <= 0xff5e)
    return std::string("a fullwidth form; write ") +
           static_cast<char>(code - 0xff01 + '!');
  for (const auto &range : ranges)
    if (code >= range.first && code <= range.last)
      return range.description;
  return {};
}

std::string
hexadecimal(const char *const format, const unsigned int number)
{
  char text[16];
  std::snprintf(text, sizeof(text), format, number);
  return text;
}
} // namespace



std::string
describe_character(const std::string &text, const std::size_t position)
{
  const Character character = decode(text, position);
  if (character.size == 0)
    return hexadecimal("the byte 0x%02X",
                       static_cast<unsigned char>(text[position])) +
           ", which is no text in UTF-8; save the file anew as that";
  const auto alike = describe_alike(character.code);
  return "the character " + hexadecimal("U+%04X", character.code) +
         (alike ? ", " + *alike : "");
}



std::string
without_control_characters(const std::string &text)
{
  std::string result;
  for (std::size_t i = 0; i < text.size();)
    {
      const unsigned char byte  = text[i];
      const Character character = decode(text, i);
      // What is no UTF-8 is passed on byte by byte.
      const std::size_t size = std::max(character.size, 1u);
      const char32_t code    = character.size > 0 ? character.code : byte;
      const bool is_control =
        (character.size > 0 || byte < 0x80) &&
        ((code < 0x20 && code != '\n') || (code >= 0x7f && code <= 0x9f) ||
         code == 0x2028 || code == 0x2029);
      result += is_control ? "?" : text.substr(i, size);
      i += size;
    }
  return result;
}



void
check_characters(const std::string &text, const std::string &place)
{
  std::size_t position = 0;
  for (unsigned int column = 1; position < text.size(); ++column)
    {
      const auto refuse = [&](const std::string &what) {
        throw SceneError(place + ":" + std::to_string(column) + ": there is " +
                         what + ".");
      };
      const unsigned char byte = text[position];
      if (byte == 0)
        refuse("a character of code 0, which no text has");
      if (byte < 0x80)
        {
          ++position;
          continue;
        }
      const Character character = decode(text, position);
      if (character.size == 0 || describe_alike(character.code))
        refuse(describe_character(text, position));
      position += character.size;
    }
}
} // namespace Setsudan
