// SPDX-License-Identifier: LGPL-2.1-or-later
#include <deal.II/base/utilities.h>

#include <setsudan/parameters/scene_file.h>
#include <setsudan/parameters/text_lines.h>

#include <filesystem>

namespace Setsudan
{
using dealii::Utilities::trim;

namespace
{
/** The logical lines of a scene file, with the number each begins at. */
struct Line
{
  std::string text;
  unsigned int number = 0;
};

std::vector<Line>
read_lines(const std::string &file_name, const std::string &included_at)
{
  std::vector<Line> lines;
  unsigned int number = 0;
  bool continued      = false;
  for (const auto &physical : read_text_lines(file_name, included_at))
    {
      ++number;
      const std::string text = trim(without_comment(physical));
      check_characters(without_comment(physical),
                       file_name + ":" + std::to_string(number));
      if (continued)
        lines.back().text += " " + text;
      else
        lines.push_back({text, number});
      std::string &line = lines.back().text;
      continued         = !line.empty() && line.back() == '\\';
      if (continued)
        line = trim(line.substr(0, line.size() - 1));
    }
  return lines;
}

std::string
join(const std::vector<std::string> &names)
{
  std::string path;
  for (const std::string &name : names)
    path += (path.empty() ? "" : "/") + name;
  return path;
}

/** Split `name = value`; both parts trimmed. */
bool
split_assignment(const std::string &text, std::string &name, std::string &value)
{
  const auto equal = text.find('=');
  if (equal == std::string::npos)
    return false;
  name  = trim(text.substr(0, equal));
  value = trim(text.substr(equal + 1));
  return !name.empty();
}

/** @param included_at begins messages about the file itself. */
void
read_into(const std::string &file_name,
          const unsigned int depth,
          const std::string &included_at,
          const std::vector<std::string> &outer_subsections,
          std::vector<SceneEntry> &entries)
{
  if (depth > 20)
    throw SceneError(included_at + "The scene file '" + file_name +
                     "' includes itself, directly or by others.");
  std::vector<std::string> subsections = outer_subsections;
  unsigned int last_line               = 1;
  for (const Line &line : read_lines(file_name, included_at))
    {
      const std::string location =
        file_name + ":" + std::to_string(line.number);
      last_line          = line.number;
      const auto space   = line.text.find_first_of(" \t");
      const auto keyword = line.text.substr(0, space);
      const auto rest =
        space == std::string::npos ? "" : trim(line.text.substr(space));

      SceneEntry entry;
      if (keyword.empty())
        continue;
      else if (keyword == "subsection" && !rest.empty())
        subsections.push_back(rest);
      else if (keyword == "end" && rest.empty() &&
               subsections.size() > outer_subsections.size())
        subsections.pop_back();
      else if (keyword == "set" &&
               split_assignment(rest, entry.name, entry.value))
        {
          entry.subsection = join(subsections);
          entry.location   = location;
          entries.push_back(entry);
        }
      else if (keyword == "include" && !rest.empty())
        read_into(
          (std::filesystem::path(file_name).parent_path() / rest).string(),
          depth + 1,
          location + ": ",
          subsections,
          entries);
      else
        throw SceneError(location + ": '" + line.text +
                         "' is not understood; allowed are 'subsection NAME', "
                         "'set NAME = VALUE', 'end', 'include FILE' and "
                         "comments after '#'.");
    }
  if (subsections.size() > outer_subsections.size())
    throw SceneError(file_name + ":" + std::to_string(last_line) +
                     ": subsection '" + join(subsections) + "' has no 'end'.");
}
} // namespace


std::vector<SceneEntry>
read_scene_file(const std::string &file_name)
{
  std::vector<SceneEntry> entries;
  read_into(file_name, 0, "", {}, entries);
  return entries;
}



SceneEntry
parse_assignment(const std::string &assignment)
{
  check_characters(assignment, "--set");
  SceneEntry entry;
  std::string path;
  if (!split_assignment(assignment, path, entry.value))
    throw SceneError("--set '" + assignment +
                     "' is not of the form 'Subsection/Name=value'.");
  const auto slash = path.rfind('/');
  if (slash != std::string::npos)
    entry.subsection = trim(path.substr(0, slash));
  entry.name = trim(path.substr(slash == std::string::npos ? 0 : slash + 1));
  entry.location = "--set";
  return entry;
}
} // namespace Setsudan
