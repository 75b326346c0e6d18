// SPDX-License-Identifier: LGPL-2.1-or-later
#include <deal.II/base/utilities.h>

#include <setsudan/body/group_of_word.h>
#include <setsudan/material/element_values.h>
#include <setsudan/parameters/lists.h>

#include <algorithm>
#include <functional>
#include <optional>

namespace Setsudan
{
using namespace dealii;

namespace
{
/** Where the name of a group ends and its value begins. */
using EndOfGroup = std::string::size_type (*)(const std::string &);

/** At the last colon, where there is one. */
std::string::size_type
last_colon(const std::string &item)
{
  return item.rfind(':');
}

/** At the first colon, unless what stands before it is a number and so the
 * first of a pair. */
std::string::size_type
colon_before_pairs(const std::string &item)
{
  const auto colon = item.find(':');
  std::vector<double> number;
  if (colon == std::string::npos ||
      (parse_numbers(item.substr(0, colon), number) && !number.empty()))
    return std::string::npos;
  return colon;
}



/**
 * Read a parameter that is a value, or values for groups of elements.
 *
 * @param kind of the values, in a word.
 * @param parse nothing, for a text that is not what `allowed` says.
 * @param may_be_empty whether elements need no value.
 */
template <int dim, typename Value>
ElementValues<Value>
read_values(
  const Parameters &parameters,
  const Body<dim> &body,
  const std::string &name,
  const std::string &kind,
  const std::string &allowed,
  const std::function<std::optional<Value>(const std::string &)> &parse,
  const bool may_be_empty       = false,
  const EndOfGroup end_of_group = last_colon)
{
  const auto reject_unless = [&](const bool condition,
                                 const std::string &what) {
    parameters.require(condition, "Material", name, what);
  };
  ElementValues<Value> values;
  std::vector<bool> given(body.mesh.cells.size(), false);
  bool all_given = false;
  for (const auto &item : split(parameters.text("Material", name), ';'))
    {
      const auto colon     = end_of_group(item);
      const bool has_group = colon != std::string::npos;
      const std::string word =
        has_group ? Utilities::trim(item.substr(0, colon)) : "";
      const std::string text = has_group ? item.substr(colon + 1) : item;
      const auto value       = parse(Utilities::trim(text));
      reject_unless(value.has_value(),
                    allowed + ", or 'group : " + kind + "', separated by ';'");
      if (word.empty())
        {
          reject_unless(!all_given && values.empty(),
                        "one " + kind +
                          " without a group, before those of groups");
          values    = {*value};
          all_given = true;
          continue;
        }
      if (values.size() != body.mesh.cells.size())
        values.assign(body.mesh.cells.size(), all_given ? values[0] : Value());
      for (const unsigned int cell :
           find_group_or_reject(
             parameters, "Material", name, body, word, GroupKind::elements)
             .cells)
        {
          values[cell] = *value;
          given[cell]  = true;
        }
    }
  if (may_be_empty && values.empty())
    values.emplace_back();
  reject_unless(!values.empty(), allowed);
  reject_unless(
    all_given || may_be_empty ||
      std::all_of(
        given.begin(), given.end(), [](const bool value) { return value; }),
    "a " + kind +
      " for every element: the groups leave some out, for which a " + kind +
      " without a group would be taken");
  return values;
}
} // namespace


template <int dim>
ElementValues<double>
read_numbers(const Parameters &parameters,
             const Body<dim> &body,
             const std::string &name,
             const std::string &allowed,
             bool (*is_allowed)(double))
{
  return read_values<dim, double>(
    parameters,
    body,
    name,
    "number",
    allowed,
    [&](const std::string &text) -> std::optional<double> {
      std::vector<double> number;
      if (parse_numbers(text, number) && number.size() == 1 &&
          is_allowed(number[0]))
        return number[0];
      return {};
    });
}



template <int dim>
ElementValues<std::vector<double>>
read_lists(const Parameters &parameters,
           const Body<dim> &body,
           const std::string &name,
           const NumberList &list)
{
  return read_values<dim, std::vector<double>>(
    parameters,
    body,
    name,
    list.kind,
    "'" + list.kind + "', " + std::to_string(list.n_numbers) + " " +
      list.allowed,
    [&](const std::string &text) -> std::optional<std::vector<double>> {
      std::vector<double> numbers;
      if (parse_numbers(text, numbers) &&
          (numbers.size() == list.n_numbers ||
           (numbers.empty() && list.may_be_empty)) &&
          std::all_of(numbers.begin(), numbers.end(), list.is_allowed))
        return numbers;
      return {};
    },
    list.may_be_empty);
}



template <int dim>
ElementValues<std::vector<std::pair<double, double>>>
read_pairs(const Parameters &parameters,
           const Body<dim> &body,
           const std::string &name,
           const std::string &kind,
           const std::string &allowed,
           bool (*is_allowed)(const std::pair<double, double> &))
{
  using Pairs = std::vector<std::pair<double, double>>;
  if (parameters.text("Material", name).empty())
    return {Pairs()};
  return read_values<dim, Pairs>(
    parameters,
    body,
    name,
    kind,
    allowed,
    [&](const std::string &text) -> std::optional<Pairs> {
      Pairs pairs;
      for (const auto &[before, behind] : split_items(text, ','))
        {
          std::vector<double> first, second;
          if (!parse_numbers(before, first) || first.size() != 1 ||
              !parse_numbers(behind, second) || second.size() != 1)
            return {};
          pairs.emplace_back(first[0], second[0]);
          if (!is_allowed(pairs.back()))
            return {};
        }
      return pairs;
    },
    false,
    colon_before_pairs);
}



template <int dim>
ElementValues<std::string>
read_names(const Parameters &parameters,
           const Body<dim> &body,
           const std::string &name,
           const std::string &kind,
           const std::string &names)
{
  const std::vector<std::string> all = split(names, '|');
  return read_values<dim, std::string>(
    parameters,
    body,
    name,
    kind,
    names,
    [&](const std::string &text) -> std::optional<std::string> {
      if (std::find(all.begin(), all.end(), text) != all.end())
        return text;
      return {};
    });
}



#define INSTANTIATE(dim)                                                      \
  template ElementValues<double> read_numbers(const Parameters &,             \
                                              const Body<dim> &,              \
                                              const std::string &,            \
                                              const std::string &,            \
                                              bool (*)(double));              \
  template ElementValues<std::vector<double>> read_lists(const Parameters &,  \
                                                         const Body<dim> &,   \
                                                         const std::string &, \
                                                         const NumberList &); \
  template ElementValues<std::vector<std::pair<double, double>>> read_pairs(  \
    const Parameters &,                                                       \
    const Body<dim> &,                                                        \
    const std::string &,                                                      \
    const std::string &,                                                      \
    const std::string &,                                                      \
    bool (*)(const std::pair<double, double> &));                             \
  template ElementValues<std::string> read_names(const Parameters &,          \
                                                 const Body<dim> &,           \
                                                 const std::string &,         \
                                                 const std::string &,         \
                                                 const std::string &);

INSTANTIATE(2)
INSTANTIATE(3)

#undef INSTANTIATE
} // namespace Setsudan
