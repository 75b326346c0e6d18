// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <setsudan/parameters/exceptions.h>
#include <stdexcept>
#include <string>
#include <vector>

namespace Setsudan
{

/** One line `set name = value` of a scene file, or one `--set` option. */
struct SceneEntry
{
  /** Names of the enclosing subsections, joined by '/'; empty at the top. */
  std::string subsection;
  std::string name;
  std::string value;
  /** Where it was written, for messages: `cut.prm:12` or `--set`. */
  std::string location;
};

/**
 * Read a scene file in deal.II's parameter syntax: `subsection`, `set`, `end`,
 * comments after a '#' at the beginning of a line or behind a blank, lines
 * continued by a final '\', and `include FILE` (relative to the including
 * file).
 *
 * dealii::ParameterHandler reads the same syntax but forgets the lines, which
 * every message of a later check needs; so the lines are read here and handed
 * to it one by one (see Parameters).
 *
 * @throw SceneError where the file cannot be read or its syntax is wrong.
 */
std::vector<SceneEntry>
read_scene_file(const std::string &file_name);

/**
 * The entry that the command line option `--set Subsection/Name=value` stands
 * for; a parameter outside all subsections is `Name=value`.
 *
 * @throw SceneError where there is no '=', or for characters that are none of
 * a scene (see check_characters()).
 */
SceneEntry
parse_assignment(const std::string &assignment);
} // namespace Setsudan
