// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <setsudan/mechanics/elastic_model.h>

namespace Setsudan
{
/** While this lives, a state that has been solved for is taken for accepted,
 * and no time passes behind it: for states that are tried from there on.
 * Nothing where no law remembers. */
template <int dim>
class AssumedState
{
public:
  /** @param displacement of the state, without ghosts. */
  AssumedState(const ElasticModel<dim> &model, const LA::Vector &displacement)
    : internal(model.internal)
    , before(internal.save())
  {
    if (internal.empty())
      return;
    evaluate_laws(model, displacement);
    internal.accept();
  }

  ~AssumedState()
  {
    internal.restore(before);
  }

  AssumedState(const AssumedState &) = delete;
  AssumedState &
  operator=(const AssumedState &) = delete;

private:
  InternalVariables<dim> &internal;
  const typename InternalVariables<dim>::Snapshot before;
};
} // namespace Setsudan
