// SPDX-License-Identifier: LGPL-2.1-or-later
// A box with its supports, from assignments as the command line has them:
// {"Body/Size=1,2,3", "Support/Fixed faces=bottom"}.
#pragma once

#include <setsudan/body/body_parameters.h>
#include <setsudan/body/supports.h>

#include <string>
#include <vector>

namespace Setsudan
{
using Assignments = std::vector<std::string>;

inline Parameters
parameters_of(const Assignments &assignments,
              const Parameters::Declare &declare)
{
  std::vector<SceneEntry> entries;
  for (const std::string &assignment : assignments)
    entries.push_back(parse_assignment(assignment));
  return Parameters("scene", entries, declare);
}


template <int dim>
struct SmallBody
{
  static void
  declare(dealii::ParameterHandler &handler)
  {
    BodyParameters<dim>::declare(handler);
    SupportParameters<dim>::declare(handler);
  }

  explicit SmallBody(const Parameters &parameters)
    : body(make_body(parameters, BodyParameters<dim>(parameters)))
    , supports(SupportParameters<dim>(parameters, body), body)
  {
  }

  explicit SmallBody(const Assignments &assignments)
    : SmallBody(parameters_of(assignments, declare))
  {
  }

  const Body<dim> body;
  const Supports<dim> supports;
};
} // namespace Setsudan
