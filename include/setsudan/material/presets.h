// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <setsudan/parameters/parameters.h>

#include <iosfwd>
#include <string>
#include <vector>

namespace Setsudan
{
/** The file data/materials.csv, which the program was built with. */
extern const char *const material_table;

/** A value of a material that is known by its name. */
struct PresetValue
{
  std::string material;
  /** A parameter of subsection Material, or Friction, which is the blade's. */
  std::string quantity;
  /** As in a scene: a number, a list of them, or pairs with ':' in them. */
  std::string value;
  /** Of every number; 'unit : unit' of pairs; - for none. */
  std::string unit;
  /** Under which it was measured. */
  std::string conditions;
  std::string source;
  /** published, or assumed where there is no source. */
  std::string tag;
};

/** Materials by name: Material/Preset. */
class Presets
{
public:
  static void
  declare(dealii::ParameterHandler &handler);

  /** @param text a table as data/materials.csv. */
  explicit Presets(const std::string &text = material_table);

  /** All of the table, for people. */
  void
  print(std::ostream &out) const;

  /**
   * The parameters that a scene's preset stands for, in the scene's units; they
   * come before its own entries, which override them. Nothing where it names
   * none.
   *
   * @throw SceneError for a name that the table does not have, for units of
   *   the scene that are not known, and where a value is needed that neither
   *   has. */
  std::vector<SceneEntry>
  entries(const Parameters &parameters) const;

  /** What was taken from the table, and from where, a line for each value; what
   * a scene overrides is left out. */
  std::vector<std::string>
  describe(const Parameters &parameters) const;

private:
  /** The values of a scene's preset. */
  std::vector<PresetValue>
  values_of(const Parameters &parameters) const;

  std::vector<PresetValue> values;
};
} // namespace Setsudan
