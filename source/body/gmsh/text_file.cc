// SPDX-License-Identifier: LGPL-2.1-or-later
#include <setsudan/body/gmsh/text_file.h>
#include <setsudan/parameters/exceptions.h>
#include <setsudan/parameters/text_lines.h>

#include <algorithm>
#include <filesystem>
#include <fstream>

namespace Setsudan
{
namespace
{
/** Whether a byte is not the first one of a character of UTF-8. */
bool
continues_character(const char character)
{
  return (static_cast<unsigned char>(character) & 0xC0) == 0x80;
}

bool
begins_with(const std::string_view &text, const std::string_view &begin)
{
  return text.substr(0, begin.size()) == begin;
}

/** Where what begins at `position` of a geometry ends, if it is a comment or a
 * string; elsewhere `position`. */
std::size_t
end_of_quotation(const std::string_view &text, const std::size_t position)
{
  const auto rest = text.substr(position);
  std::string_view end;
  if (begins_with(rest, "//"))
    end = "\n";
  else if (begins_with(rest, "/*"))
    end = "*/";
  else if (rest[0] == '"' || rest[0] == '\'')
    end = rest.substr(0, 1);
  else
    return position;
  const std::size_t found = text.find(end, position + end.size());
  return found == std::string_view::npos ? text.size() : found + end.size();
}
} // namespace


std::string
TextFile::place(const char *const at) const
{
  const std::string_view before(text.data(), at - text.data());
  const std::size_t line = std::count(before.begin(), before.end(), '\n');
  const std::size_t column =
    std::count_if(before.begin() + (before.rfind('\n') + 1),
                  before.end(),
                  [](const char c) { return !continues_character(c); });
  return name + ":" + std::to_string(line + 1) + ":" +
         std::to_string(column + 1);
}



TextFile
read_text_file(const std::string &file_name)
{
  namespace fs = std::filesystem;
  if (!fs::exists(file_name))
    throw BodyFileError("the file does not exist");
  std::ifstream file(file_name, std::ios::binary);
  if (!fs::is_regular_file(file_name) || !file)
    throw BodyFileError("the file cannot be read");
  std::string text(fs::file_size(file_name), '\0');
  file.read(text.data(), text.size());
  if (!file)
    throw BodyFileError("the file cannot be read");
  if (text.empty())
    throw BodyFileError("the file is empty");
  return {file_name, std::move(text)};
}



bool
is_foreign(const char character)
{
  return static_cast<unsigned char>(character) >= 0x80;
}



void
check_encoding(const TextFile &file)
{
  const std::string_view text = file.text;
  // Without its mark, UTF-16 has every other byte 0 where it is ASCII.
  if (begins_with(text, "\xFF\xFE") || begins_with(text, "\xFE\xFF") ||
      text.substr(0, 2).find('\0') != std::string_view::npos)
    throw BodyFileError("the file is text in UTF-16; save it as UTF-8, "
                        "without a byte order mark");
  if (text.find('\n') == std::string_view::npos &&
      text.find('\r') != std::string_view::npos)
    throw BodyFileError("the file's lines end with carriage returns only; "
                        "save it with the line ends of Unix or Windows");
}



void
check_characters_of_geometry(const TextFile &file)
{
  const std::string_view text = file.text;
  // gmsh reads over a byte order mark.
  std::size_t position = begins_with(text, "\xEF\xBB\xBF") ? 3 : 0;
  while (position < text.size())
    {
      const std::size_t end         = end_of_quotation(text, position);
      const std::size_t lone_return = text.substr(0, end).find('\r', position);
      if (lone_return < end && text.substr(lone_return, 2) != "\r\n")
        throw BodyFileError(
          "a comment or string goes on behind a carriage return, which ends no "
          "line for gmsh (" +
          file.place(&text[lone_return]) +
          "); save the file with the line ends of Unix or Windows");
      if (end == position && is_foreign(text[position]))
        throw BodyFileError(file.place(&text[position]) + ": there is " +
                            describe_character(file.text, position));
      position = std::max(end, position + 1);
    }
}
} // namespace Setsudan
