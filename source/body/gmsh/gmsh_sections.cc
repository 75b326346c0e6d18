// SPDX-License-Identifier: LGPL-2.1-or-later
#include <setsudan/body/gmsh/gmsh_sections.h>
#include <setsudan/parameters/exceptions.h>
#include <setsudan/parameters/text_lines.h>

#include <sstream>

namespace Setsudan
{
namespace
{
/** The next '$' that begins a line, or npos. */
std::size_t
find_marker(const std::string &text, std::size_t position)
{
  position = text.find('$', position);
  while (position != std::string::npos && position > 0 &&
         text[position - 1] != '\n')
    position = text.find('$', position + 1);
  return position;
}

std::string
word_at(const std::string &text, const std::size_t position)
{
  const std::size_t end = text.find_first_of(" \t\r\n", position);
  return text.substr(position, end - position);
}

/** Refuse a file that does not begin as a mesh. */
void
check_beginning(const TextFile &file)
{
  const std::string first = "$MeshFormat";
  const std::string word  = word_at(file.text, 0);
  if (word != first)
    throw BodyFileError(
      "the file is no mesh of gmsh: it does not begin with " + first +
      (word == "\xEF\xBB\xBF" + first
         ? " but with a byte order mark; save it as UTF-8 without that"
         : ""));
}

/** Refuse sections that are not there as a mesh needs them. */
void
check_sections(const std::vector<GmshSection> &sections)
{
  const auto find_all = [&](const std::string &name) {
    std::vector<const GmshSection *> found;
    for (const auto &section : sections)
      if (section.name == name)
        found.push_back(&section);
    return found;
  };
  const auto place = [](const GmshSection &section) {
    return section.place(-1 - std::ptrdiff_t(section.name.size()));
  };
  for (const std::string name : {"MeshFormat",
                                 "PhysicalNames",
                                 "Entities",
                                 "PartitionedEntities",
                                 "Nodes",
                                 "Elements"})
    if (const auto found = find_all(name); found.size() > 1)
      throw BodyFileError(
        "the file has more than one section $" + name + " (" +
        place(*found[0]) + ", " + place(*found[1]) +
        "), of which gmsh takes one; make one mesh of it by gmsh, which can "
        "merge files");
  for (const std::string name : {"Nodes", "Elements"})
    if (find_all(name).empty())
      throw BodyFileError("the file is not complete: it has no section $" +
                          name);
  if (find_all("Elements").front() < find_all("Nodes").front())
    throw BodyFileError("the file's section $Elements stands before $Nodes, "
                        "and gmsh reads them in their order; put $Nodes first");
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
GmshSection::place(const std::ptrdiff_t position) const
{
  return file->place(content.data() + position);
}



void
GmshSection::throw_damaged(const std::string &how) const
{
  throw BodyFileError("the file is damaged: its section $" + name + " " + how);
}



void
GmshSection::throw_no_number(const std::string_view &word,
                             const std::string &kind) const
{
  throw_damaged("has '" + std::string(word) + "' where a " + kind +
                " number must be (" + file->place(word.data()) + ")" +
                describe_slip(word));
}



std::vector<GmshSection>
split_sections(const TextFile &file)
{
  check_beginning(file);
  const std::string &text = file.text;
  std::vector<GmshSection> sections;
  std::size_t position = 0;
  while (position != std::string::npos)
    {
      const std::string name = word_at(text, position + 1);
      if (name.substr(0, 3) == "End")
        throw BodyFileError("the file is damaged: its $" + name + " has no $" +
                            name.substr(3));
      const std::size_t begin = position + 1 + name.size();
      // Binary sections can hold any bytes.
      const std::size_t end = text.find("$End" + name, begin);
      if (end == std::string::npos)
        throw BodyFileError("the file is truncated: its section $" + name +
                            " has no $End" + name);
      sections.push_back(
        {name, std::string_view(text).substr(begin, end - begin), &file});
      position = find_marker(text, end + name.size());
    }
  check_sections(sections);
  return sections;
}



GmshFormat
parse_format(const GmshSection &section)
{
  std::istringstream text{std::string(section.content)};
  std::string version;
  int file_type = -1, size = 0, one = 1;
  text >> version >> file_type >> size;
  if (version != "2.2" && version != "4.1")
    throw BodyFileError("the file is a mesh of version " + version +
                        " of gmsh's format, and can be of 2.2 and 4.1");
  if (file_type == 1)
    text.ignore(text.str().size(), '\n')
      .read(reinterpret_cast<char *>(&one), sizeof(one));
  if (!text || (file_type != 0 && file_type != 1) || size != 8 || one != 1)
    throw BodyFileError(
      "the file is damaged or from another kind of computer: its section "
      "$MeshFormat must name numbers of 8 bytes, in this computer's order");
  return {version == "4.1", file_type == 1};
}
} // namespace Setsudan
