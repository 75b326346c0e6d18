// SPDX-License-Identifier: LGPL-2.1-or-later
#include <deal.II/base/patterns.h>
#include <deal.II/base/utilities.h>

#include <setsudan/parameters/lists.h>
#include <setsudan/parameters/parameters.h>
#include <setsudan/parameters/text_lines.h>

#include <cmath>
#include <cstdlib>
#include <filesystem>
#include <set>
#include <sstream>
namespace Setsudan
{
using namespace dealii;

namespace
{
std::vector<std::string>
path_of(const std::string &subsection)
{
  return split(subsection, '/');
}

/** "Young's modulus" in subsection "Material", as messages name it. */
std::string
full_name(const std::string &subsection, const std::string &name)
{
  return (subsection.empty() ? "" : "subsection " + subsection + ", ") + "'" +
         name + "'";
}

/** What a pattern allows, in words, out of deal.II's message "The string
 * <value> does not match the given pattern <description>." */
std::string
pattern_of(const ParameterHandler::ExcValueDoesNotMatchPattern &exception)
{
  std::ostringstream message;
  exception.print_info(message);
  const std::string text = message.str();
  const auto begin       = text.find('<', text.find("given pattern")) + 1;
  const auto pattern =
    Patterns::pattern_factory(text.substr(begin, text.rfind('>') - begin));
  std::string words = pattern->description(Patterns::PatternBase::Text);
  for (char &c : words)
    if (c == '\n')
      c = ' ';
  return Utilities::trim(words) + ".";
}

/**
 * Whether a value is a list of numbers of which one is no number that a scene
 * can mean. Patterns::Double also takes "nan" and "inf", reads "1e400" as
 * infinity, and numbers like "1e-320" have lost their digits.
 */
bool
has_extreme_number(const std::string &value)
{
  bool extreme = false;
  for (const auto &part : split(value, ','))
    {
      char *end           = nullptr;
      const double number = std::strtod(part.c_str(), &end);
      if (*end != '\0')
        return false; // a text, which its room reads
      extreme = extreme || !(number == 0 || std::isnormal(number));
    }
  return extreme;
}

/** Whether a line of a scene file that sets the value is read as the same. */
bool
can_be_written(const std::string &value)
{
  return without_comment("= " + value) == "= " + value &&
         (value.empty() || value.back() != '\\') &&
         value.find_first_of("\n\r") == std::string::npos;
}
} // namespace


Parameters::Parameters(const std::string &scene_name,
                       const std::vector<SceneEntry> &entries,
                       const Declare &declare)
  : declare_all(declare)
  , given(entries)
  , scene_name(scene_name)
{
  declare(handler);
  for (const SceneEntry &entry : entries)
    set(entry);
}



void
Parameters::set(const SceneEntry &entry)
{
  const auto path = path_of(entry.subsection);
  if (!path.empty() && !handler.subsection_path_exists(path))
    throw SceneError(entry.location + ": there is no subsection '" +
                     entry.subsection + "' (it sets '" + entry.name +
                     "'); --print-parameters lists all of them.");
  for (const auto &subsection : path)
    handler.enter_subsection(subsection);
  check_characters(entry.value, entry.location);
  std::string problem;
  try
    {
      handler.set(entry.name, entry.value);
      if (!can_be_written(entry.value))
        problem = "allowed is: a value that a scene file can hold, without '#' "
                  "behind a blank, which begins a comment, and without '\\' at "
                  "its end, which continues a line.";
      if (has_extreme_number(entry.value))
        problem = "allowed is: a finite number, 0 or of a magnitude from "
                  "1e-307 to 1e308.";
    }
  catch (const ParameterHandler::ExcEntryUndeclared &)
    {
      throw SceneError(entry.location + ": there is no parameter " +
                       full_name(entry.subsection, entry.name) +
                       "; --print-parameters lists all of them.");
    }
  catch (const ParameterHandler::ExcValueDoesNotMatchPattern &exception)
    {
      problem = "allowed is: " + pattern_of(exception);
    }
  for (unsigned int i = 0; i < path.size(); ++i)
    handler.leave_subsection();
  if (!problem.empty())
    throw SceneError(entry.location + ": " +
                     full_name(entry.subsection, entry.name) + " is '" +
                     entry.value + "'; " + problem);
  locations[{entry.subsection, entry.name}] = entry.location;
}



double
Parameters::number(const std::string &subsection, const std::string &name) const
{
  return handler.get_double(path_of(subsection), name);
}



unsigned int
Parameters::natural(const std::string &subsection,
                    const std::string &name) const
{
  return handler.get_integer(path_of(subsection), name);
}



bool
Parameters::truth(const std::string &subsection, const std::string &name) const
{
  return handler.get_bool(path_of(subsection), name);
}



std::string
Parameters::text(const std::string &subsection, const std::string &name) const
{
  return Utilities::trim(handler.get(path_of(subsection), name));
}



std::vector<double>
Parameters::numbers(const std::string &subsection,
                    const std::string &name,
                    const unsigned int count) const
{
  std::vector<double> values;
  const bool valid = parse_numbers(text(subsection, name), values);
  require(valid && (count == 0 || values.size() == count),
          subsection,
          name,
          (count == 0 ? "" : std::to_string(count) + " ") +
            "numbers separated by commas");
  return values;
}



bool
Parameters::is_given(const std::string &subsection,
                     const std::string &name) const
{
  return locations.count({subsection, name}) > 0;
}



std::vector<std::string>
Parameters::files() const
{
  std::set<std::string> names{scene_name};
  for (const auto &entry : given)
    names.insert(entry.location.substr(0, entry.location.rfind(':')));
  return {names.begin(), names.end()};
}



std::string
Parameters::path(const std::string &subsection, const std::string &name) const
{
  return (std::filesystem::path(scene_name).parent_path() /
          text(subsection, name))
    .string();
}



void
Parameters::reject(const std::string &subsection,
                   const std::string &name,
                   const std::string &allowed) const
{
  const auto found = locations.find({subsection, name});
  // What a library says may be a sentence of its own.
  const std::string end = allowed.empty() || allowed.back() != '.' ? "." : "";
  throw SceneError((found == locations.end() ? scene_name + " (default value)"
                                             : found->second) +
                   ": " + full_name(subsection, name) + " is '" +
                   text(subsection, name) + "'; allowed is: " + allowed + end);
}



void
Parameters::require(const bool condition,
                    const std::string &subsection,
                    const std::string &name,
                    const std::string &allowed) const
{
  if (!condition)
    reject(subsection, name, allowed);
}



void
Parameters::print(std::ostream &out) const
{
  handler.print_parameters(
    out, ParameterHandler::Text | ParameterHandler::KeepDeclarationOrder);
}



Parameters
Parameters::with(const std::vector<SceneEntry> &changes) const
{
  auto entries = given;
  entries.insert(entries.end(), changes.begin(), changes.end());
  return Parameters(scene_name, entries, declare_all);
}



void
declare(ParameterHandler &handler,
        const std::string &subsection,
        const std::string &name,
        const std::string &default_value,
        const Patterns::PatternBase &pattern,
        const std::string &documentation)
{
  const auto path = path_of(subsection);
  for (const auto &part : path)
    handler.enter_subsection(part);
  handler.declare_entry(name, default_value, pattern, documentation);
  for (unsigned int i = 0; i < path.size(); ++i)
    handler.leave_subsection();
}
} // namespace Setsudan
