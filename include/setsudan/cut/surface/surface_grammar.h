// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <setsudan/cut/surface/surface_choice.h>

#include <functional>
#include <memory>
#include <string>
#include <utility>
#include <vector>

namespace Setsudan
{
/** A surface as the scene describes it. */
template <int dim>
struct SurfaceItem
{
  std::string text;
  std::shared_ptr<SurfaceChoice<dim>> choice;
};

/**
 * Read the list `Cut/Surfaces`.
 *
 * @throw SceneError for an item that no surface is described by.
 */
template <int dim>
std::vector<SurfaceItem<dim>>
read_surfaces(const Parameters &parameters, const Body<dim> &body);

/** A part of space that a cut is limited to: whether it holds a face's center
 * up to a tolerance, for a blade that travels along `direction` and enters at
 * `entry`. */
template <int dim>
using Extent = std::function<bool(const dealii::Point<dim> &center,
                                  const double tolerance,
                                  const dealii::Tensor<1, dim> &direction,
                                  const double entry)>;

/** Read the list `Cut/Extent`: one item for each surface, or one for all. */
template <int dim>
std::vector<Extent<dim>>
read_extents(const Parameters &parameters, const unsigned int n_surfaces);
} // namespace Setsudan
