// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <deal.II/base/parameter_handler.h>

#include <setsudan/parameters/scene_file.h>

#include <functional>
#include <iosfwd>
#include <map>
#include <string>
#include <utility>
#include <vector>

namespace Setsudan
{
/**
 * The parameters of a scene: what the rooms declared, with the values of a
 * scene file and of the command line, and with where each was written.
 *
 * Every room declares its own with dealii::ParameterHandler, reads them from
 * here and calls reject() for a value that its pattern could not refuse.
 * Subsections are paths joined by '/'; the empty one holds the parameters at
 * the top of the file.
 */
class Parameters
{
public:
  using Declare = std::function<void(dealii::ParameterHandler &)>;

  /**
   * Declare the parameters and set those that `entries` name, later ones
   * winning. `scene_name` stands in messages about values nobody wrote.
   *
   * @throw SceneError for a subsection or name that was not declared and for
   * a value that does not match its pattern.
   */
  Parameters(const std::string &scene_name,
             const std::vector<SceneEntry> &entries,
             const Declare &declare);

  double
  number(const std::string &subsection, const std::string &name) const;

  unsigned int
  natural(const std::string &subsection, const std::string &name) const;

  bool
  truth(const std::string &subsection, const std::string &name) const;

  std::string
  text(const std::string &subsection, const std::string &name) const;

  /** Numbers separated by commas; `count` of them, or any number if 0. */
  std::vector<double>
  numbers(const std::string &subsection,
          const std::string &name,
          const unsigned int count = 0) const;

  /** Whether the scene file or the command line names this parameter. */
  bool
  is_given(const std::string &subsection, const std::string &name) const;

  /** The files that parameters were read from. */
  std::vector<std::string>
  files() const;

  /** The path of a file that a parameter names relative to the scene file. */
  std::string
  path(const std::string &subsection, const std::string &name) const;

  /**
   * Refuse the value of a parameter. `allowed` completes "allowed is ...".
   *
   * @throw SceneError always; it names file, line, subsection, name and value.
   */
  [[noreturn]] void
  reject(const std::string &subsection,
         const std::string &name,
         const std::string &allowed) const;

  /** reject() unless `condition` holds. */
  void
  require(const bool condition,
          const std::string &subsection,
          const std::string &name,
          const std::string &allowed) const;

  /** All parameters as a scene file, with their documentation. */
  void
  print(std::ostream &out) const;

  /** The same parameters but for some. */
  Parameters
  with(const std::vector<SceneEntry> &changes) const;

private:
  void
  set(const SceneEntry &entry);

  const Declare declare_all;
  dealii::ParameterHandler handler;
  std::vector<SceneEntry> given;
  std::map<std::pair<std::string, std::string>, std::string> locations;
  std::string scene_name;
};

/** Declare a parameter in `subsection`; the last words of its documentation
 * are its unit, in brackets. */
void
declare(dealii::ParameterHandler &handler,
        const std::string &subsection,
        const std::string &name,
        const std::string &default_value,
        const dealii::Patterns::PatternBase &pattern,
        const std::string &documentation);
} // namespace Setsudan
