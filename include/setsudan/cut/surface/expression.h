// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <deal.II/base/function_parser.h>
#include <deal.II/base/point.h>

#include <memory>
#include <string>

namespace Setsudan
{
/** A function of position that the scene gives as a text, for muParser: one
 * expression, without lists and assignments, of which muParser would take the
 * last value. */
template <int dim>
class Expression
{
public:
  /** @param variables names of the coordinates, separated by commas. */
  Expression(const std::string &variables, const std::string &text);

  /** Why the text is no expression, or nothing. */
  const std::string &
  problem() const;

  /** Whether it has comparisons, whose values are 0 and 1. */
  bool
  compares() const;

  /** @pre there is no problem. */
  double
  operator()(const dealii::Point<dim> &point) const;

private:
  std::shared_ptr<dealii::FunctionParser<dim>> parser;
  std::string what_is_wrong;
  bool has_comparison;
};
} // namespace Setsudan
