// SPDX-License-Identifier: LGPL-2.1-or-later
#include <setsudan/material/presets.h>
#include <setsudan/parameters/lists.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <ostream>
#include <sstream>

namespace Setsudan
{
using namespace dealii;

namespace
{
/** The fields of a line of comma-separated values, some of them between
 * quotation marks. */
std::vector<std::string>
fields_of(const std::string &line)
{
  std::vector<std::string> fields(1);
  bool is_quoted = false;
  for (const char c : line)
    if (c == '"')
      is_quoted = !is_quoted;
    else if (c == ',' && !is_quoted)
      fields.emplace_back();
    else
      fields.back() += c;
  return fields;
}

/** Meters or newtons of a unit. */
using Units = std::map<std::string, double>;

const Units lengths = {{"m", 1.}, {"cm", 1e-2}, {"mm", 1e-3}, {"um", 1e-6}};
const Units forces  = {{"N", 1.},
                       {"kN", 1e3},
                       {"mN", 1e-3},
                       {"uN", 1e-6},
                       {"gf", 9.80665e-3},
                       {"kgf", 9.80665}};

/** What a scene's word for a unit is worth. */
double
unit_of(const Parameters &parameters,
        const std::string &name,
        const Units &units)
{
  const auto found = units.find(parameters.text("", name));
  if (found == units.end())
    {
      std::string known;
      for (const auto &unit : units)
        known += (known.empty() ? "" : ", ") + unit.first;
      parameters.reject("",
                        name,
                        known + " where Material/Preset is given, whose "
                                "values have units");
    }
  return found->second;
}

/** In newtons and meters; N is the power of force, m that of length. */
struct SiUnit
{
  double factor;
  int force;
  int length;
};

const std::map<std::string, SiUnit> si_units = {{"-", {1., 0, 0}},
                                                {"Pa", {1., 1, -2}},
                                                {"kPa", {1e3, 1, -2}},
                                                {"MPa", {1e6, 1, -2}},
                                                {"GPa", {1e9, 1, -2}},
                                                {"J/m^2", {1., 1, -1}},
                                                {"s", {1., 0, 0}}};

std::string
subsection_of(const std::string &quantity)
{
  return quantity == "Friction" ? "Blade" : "Material";
}

/** A value whose entries, lists of them, and pairs with ':' in them, are each
 * what `convert(entry, unit)` says; a pair has a unit for each half. */
template <typename Convert>
std::string
by_entry(const PresetValue &value, const Convert &convert)
{
  const auto units = split(value.unit, ':');
  std::string result;
  for (const auto &item : split(value.value, ';'))
    {
      std::string list;
      for (const auto &pair : split(item, ','))
        {
          const auto entries = split(pair, ':');
          AssertThrow(entries.size() == units.size(),
                      ExcMessage("A value of the table of materials does not "
                                 "fit to its unit: " +
                                 value.quantity + " = " + value.value));
          for (unsigned int i = 0; i < entries.size(); ++i)
            list += (i > 0          ? " : "
                     : list.empty() ? ""
                                    : ", ") +
                    convert(entries[i], units[i]);
        }
      result += (result.empty() ? "" : "; ") + list;
    }
  return result;
}

/** In the units of a scene, without the last digit that the conversion spoils.
 */
std::string
in_units(const PresetValue &value, const double force, const double length)
{
  return by_entry(value,
                  [&](const std::string &entry, const std::string &unit) {
                    const auto &[factor, n_force, n_length] = si_units.at(unit);
                    std::vector<double> number;
                    if (!parse_numbers(entry, number))
                      return entry;
                    std::ostringstream text;
                    text.precision(15);
                    text << number[0] * factor * std::pow(force, -n_force) *
                              std::pow(length, -n_length);
                    return text.str();
                  });
}

/** @throw ExcMessage for a value that has no known units, or is no list of
 * numbers; what has no unit may be a word too. */
void
check(const PresetValue &value)
{
  by_entry(value, [&](const std::string &entry, const std::string &unit) {
    std::vector<double> number;
    AssertThrow(si_units.count(unit) == 1 &&
                  (value.unit == "-" || parse_numbers(entry, number)),
                ExcMessage("A value of the table of materials is wrong: " +
                           value.quantity + " = " + value.value + " " +
                           value.unit));
    return entry;
  });
}

/** For people. */
std::string
with_unit(const PresetValue &value)
{
  if (value.unit.find_first_not_of("-: ") == std::string::npos)
    return value.value;
  return value.value + " " +
         (split(value.unit, ':').size() == 1 ? value.unit
                                             : "[" + value.unit + "]");
}

/** Friction is that of a blade that touches. */
bool
applies(const PresetValue &value, const Parameters &parameters)
{
  return value.quantity != "Friction" ||
         parameters.text("Blade", "Drive") == "travel";
}

std::string
origin(const PresetValue &value)
{
  const std::string conditions =
    value.conditions == "-" ? "" : value.conditions + "; ";
  return conditions + (value.source == "-" ? value.tag : value.source);
}
} // namespace


void
Presets::declare(ParameterHandler &handler)
{
  Setsudan::declare(handler,
                    "Material",
                    "Preset",
                    "",
                    Patterns::Anything(),
                    "A material by its name, as 'firm tofu': values with "
                    "sources, which --print-materials prints, for those of "
                    "these parameters that the scene does not set. Length unit "
                    "and Force unit are those of the scene then, and the unit "
                    "of time is the second. Empty: none.");
}



Presets::Presets(const std::string &text)
{
  std::istringstream lines(text);
  std::string line;
  // The names of the columns.
  std::getline(lines, line);
  while (std::getline(lines, line))
    {
      const auto fields = fields_of(line);
      AssertThrow(
        fields.size() == 7,
        ExcMessage("A line of the table of materials is wrong: " + line));
      values.push_back({fields[0],
                        fields[1],
                        fields[2],
                        fields[3],
                        fields[4],
                        fields[5],
                        fields[6]});
      check(values.back());
    }
}



void
Presets::print(std::ostream &out) const
{
  std::string material;
  for (const auto &value : values)
    {
      if (value.material != material)
        out << value.material << '\n';
      material = value.material;
      out << "  " << value.quantity << " = " << with_unit(value) << " ("
          << origin(value) << ")\n";
    }
}



std::vector<PresetValue>
Presets::values_of(const Parameters &parameters) const
{
  const auto name = parameters.text("Material", "Preset");
  std::vector<PresetValue> found;
  std::string known;
  for (const auto &value : values)
    {
      if (value.material == name)
        found.push_back(value);
      if (known.find(value.material) == std::string::npos)
        known += (known.empty() ? "" : ", ") + value.material;
    }
  parameters.require(name.empty() || !found.empty(),
                     "Material",
                     "Preset",
                     "empty, or one of " + known);
  return found;
}



std::vector<SceneEntry>
Presets::entries(const Parameters &parameters) const
{
  const auto found = values_of(parameters);
  std::vector<SceneEntry> entries;
  if (found.empty())
    return entries;
  const double force  = unit_of(parameters, "Force unit", forces),
               length = unit_of(parameters, "Length unit", lengths);
  const auto name     = parameters.text("Material", "Preset");
  const auto is_known = [&](const std::string &quantity) {
    return parameters.is_given("Material", quantity) ||
           std::any_of(found.begin(), found.end(), [&](const auto &value) {
             return value.quantity == quantity;
           });
  };
  std::vector<std::string> needed;
  if (!is_known("Young's moduli"))
    needed = {"Young's modulus", "Poisson's ratio"};
  if (!parameters.text("Cut", "Surfaces").empty())
    {
      const std::string limit =
        parameters.text("Yield", "Criterion") == "energy release"
          ? "Toughness"
          : "Shear limit";
      if (!is_known(limit + " by axis"))
        needed.push_back(limit);
    }
  for (const auto &quantity : needed)
    parameters.require(is_known(quantity),
                       "Material",
                       "Preset",
                       "a material whose " + quantity +
                         " is in the table, or a scene with Material/" +
                         quantity);
  for (const auto &value : found)
    if (applies(value, parameters))
      entries.push_back({subsection_of(value.quantity),
                         value.quantity,
                         in_units(value, force, length),
                         "Material/Preset = " + name});
  return entries;
}



std::vector<std::string>
Presets::describe(const Parameters &parameters) const
{
  std::vector<std::string> lines;
  for (const auto &value : values_of(parameters))
    if (applies(value, parameters) &&
        !parameters.is_given(subsection_of(value.quantity), value.quantity))
      lines.push_back("Preset " + value.material + ": " + value.quantity +
                      " = " + with_unit(value) + " (" + origin(value) + ").");
  return lines;
}
} // namespace Setsudan
