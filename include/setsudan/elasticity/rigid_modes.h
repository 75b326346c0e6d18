#pragma once

#include <deal.II/base/point.h>
#include <deal.II/base/tensor.h>

#include <setsudan/body/supports.h>

#include <array>
#include <utility>
#include <vector>

namespace Setsudan
{
/** Independent rigid motions of a body: 3 in the plane, 6 in space. */
template <int dim>
constexpr unsigned int n_rigid_modes = dim *(dim + 1) / 2;

/**
 * The rigid motions about `center`: translations along the axes, then
 * (infinitesimal) rotations, scaled by `length` so that all are of order one.
 *
 * @return the displacement of a point in each of them.
 */
template <int dim>
std::array<dealii::Tensor<1, dim>, n_rigid_modes<dim>>
rigid_modes(const dealii::Point<dim> &point,
            const dealii::Point<dim> &center,
            const double length);

/** One displacement component of one of a list of points. */
using PointComponent = std::pair<unsigned int, unsigned int>;

/**
 * A smallest set of displacement components of `candidates` that, held fixed,
 * stops every rigid motion which the `held` points leave free. Empty where they
 * hold the body.
 */
template <int dim>
std::vector<PointComponent>
find_minimal_hold(const std::vector<HeldPoint<dim>> &held,
                  const std::vector<dealii::Point<dim>> &candidates);
} // namespace Setsudan
