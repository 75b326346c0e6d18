// SPDX-License-Identifier: LGPL-2.1-or-later
#include <setsudan/body/gmsh/gmsh_outline.h>
#include <setsudan/body/gmsh/gmsh_sections.h>

#include <algorithm>
#include <array>
#include <filesystem>
#include <fstream>
#include <sstream>
#include <stdexcept>
#include <string_view>

namespace Setsudan
{
namespace
{
TextFile
read_all(const std::string &file_name)
{
  namespace fs = std::filesystem;
  if (!fs::exists(file_name))
    throw std::runtime_error("the file does not exist");
  std::ifstream file(file_name, std::ios::binary);
  if (!fs::is_regular_file(file_name) || !file)
    throw std::runtime_error("the file cannot be read");
  std::string text(fs::file_size(file_name), '\0');
  file.read(text.data(), text.size());
  if (!file)
    throw std::runtime_error("the file cannot be read");
  if (text.empty())
    throw std::runtime_error("the file is empty");
  return {file_name, text};
}

/** The next '$' that begins a line, or npos. */
std::size_t
find_marker(const std::string &text, std::size_t position)
{
  while (true)
    {
      position = text.find('$', position);
      if (position == std::string::npos || position == 0 ||
          text[position - 1] == '\n')
        return position;
      ++position;
    }
}

std::string
word_at(const std::string &text, const std::size_t position)
{
  const std::size_t end = text.find_first_of(" \t\r\n", position);
  return text.substr(position, end - position);
}

/** The sections of a file, which must live on. Binary sections can hold any
 * bytes: so each is left by its end marker. */
std::vector<GmshSection>
split_sections(const TextFile &file)
{
  const std::string &text = file.text;
  std::vector<GmshSection> sections;
  std::size_t position = find_marker(text, 0);
  while (position != std::string::npos)
    {
      const std::string name = word_at(text, position + 1);
      if (name.substr(0, 3) == "End")
        throw std::runtime_error("the file is damaged: its $" + name +
                                 " has no $" + name.substr(3));
      const std::size_t begin = position + 1 + name.size();
      const std::size_t end   = text.find("$End" + name, begin);
      if (end == std::string::npos)
        throw std::runtime_error("the file is truncated: its section $" + name +
                                 " has no $End" + name);
      sections.push_back(
        {name, std::string_view(text).substr(begin, end - begin), &file});
      position = find_marker(text, end + name.size());
    }
  return sections;
}

/** Refuse a second section of what a mesh has once: gmsh takes one of them. */
void
check_single(const std::vector<GmshSection> &sections)
{
  for (const std::string name : {"MeshFormat",
                                 "PhysicalNames",
                                 "Entities",
                                 "PartitionedEntities",
                                 "Nodes",
                                 "Elements"})
    {
      std::vector<std::string> places;
      for (const auto &section : sections)
        if (section.name == name)
          places.push_back(section.place());
      if (places.size() > 1)
        throw std::runtime_error(
          "the file has more than one section $" + name + " (" + places[0] +
          ", " + places[1] +
          "), of which gmsh takes one; make one mesh of it by gmsh, which can "
          "merge files");
    }
}

/** A section that every mesh must have. */
const GmshSection &
find_section(const std::vector<GmshSection> &sections, const std::string &name)
{
  for (const auto &section : sections)
    if (section.name == name)
      return section;
  throw std::runtime_error("the file is not complete: it has no section $" +
                           name);
}

/** Entries of dimension, number, and name in quotes, behind their count. gmsh
 * crashes on other dimensions than 0 to 3. */
std::vector<GmshOutline::GroupName>
parse_group_names(const GmshSection &section)
{
  std::istringstream text{std::string(section.content)};
  std::size_t n_names = 0;
  text >> n_names;
  std::vector<GmshOutline::GroupName> names;
  while (text && names.size() < n_names)
    {
      GmshOutline::GroupName entry;
      char quote = ' ';
      if (text >> entry.dimension >> entry.number >> quote &&
          entry.dimension <= 3 && quote == '"' &&
          std::getline(text, entry.name, '"'))
        {
          for (const auto &other : names)
            if (other.dimension == entry.dimension && other.name == entry.name)
              throw std::runtime_error(
                "two physical groups of dimension " +
                std::to_string(entry.dimension) + " have the name '" +
                entry.name + "', numbers " + std::to_string(other.number) +
                " and " + std::to_string(entry.number) +
                ", of which gmsh keeps one; give each a name of its own");
          names.push_back(entry);
        }
      else
        text.setstate(std::ios::failbit);
    }
  const bool is_list = bool(text);
  text >> std::ws;
  if (!is_list || !text.eof())
    throw std::runtime_error("the file is damaged: its section $" +
                             section.name + " is no list of groups");
  return names;
}

/** The version, and whether the sections are binary. */
std::pair<std::string, bool>
parse_format(const GmshSection &section)
{
  std::istringstream text{std::string(section.content)};
  std::string version;
  int file_type = -1, size = 0, one = 1;
  text >> version >> file_type >> size;
  if (version != "2.2" && version != "4.1")
    throw std::runtime_error("the file is a mesh of version " + version +
                             " of gmsh's format, and can be of 2.2 and 4.1");
  if (file_type == 1)
    text.ignore(text.str().size(), '\n')
      .read(reinterpret_cast<char *>(&one), sizeof(one));
  if (!text || (file_type != 0 && file_type != 1) || size != 8 || one != 1)
    throw std::runtime_error(
      "the file is damaged or from another kind of computer: its section "
      "$MeshFormat must name numbers of 8 bytes, in this computer's order");
  return {version, file_type == 1};
}

GmshOutline
outline_mesh(const TextFile &file)
{
  const std::string first = "$MeshFormat";
  const std::string word  = word_at(file.text, 0);
  if (word != first)
    throw std::runtime_error(
      "the file is no mesh of gmsh: it does not begin with " + first +
      (word == "\xEF\xBB\xBF" + first
         ? " but with a byte order mark; save it as UTF-8 without that"
         : ""));
  const auto sections = split_sections(file);
  check_single(sections);
  const auto [version, is_binary] = parse_format(sections.front());
  const GmshSection &nodes        = find_section(sections, "Nodes");
  const GmshSection &elements     = find_section(sections, "Elements");
  if (&elements < &nodes)
    throw std::runtime_error("the file's section $Elements stands before "
                             "$Nodes, and gmsh reads them in their order; put "
                             "$Nodes first");
  GmshOutline outline = {
    false, version, check_nodes_section(version, nodes, is_binary), {}, {}};
  outline.element_types =
    check_elements_section(version, elements, is_binary, outline.node_numbers);
  for (const auto &section : sections)
    if (section.name == "PhysicalNames")
      outline.group_names = parse_group_names(section);
  return outline;
}
} // namespace


GmshOutline
outline_gmsh_file(const std::string &file_name)
{
  const std::string extension =
    std::filesystem::path(file_name).extension().string();
  const TextFile file = read_all(file_name);
  check_encoding(file);
  if (extension == ".geo")
    {
      check_characters_of_geometry(file);
      return {true, "", {}, {}, {}};
    }
  if (extension != ".msh")
    throw std::runtime_error(
      "the file is none of gmsh: its name ends neither in .msh nor in .geo");
  return outline_mesh(file);
}
} // namespace Setsudan
