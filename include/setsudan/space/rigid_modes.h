// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <deal.II/base/point.h>
#include <deal.II/base/tensor.h>
#include <deal.II/lac/vector.h>

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
 * Orthonormal basis of the constraints that supports and ties impose on the
 * rigid-body modes of several bodies.
 *
 * A constraint is a linear form of the six (in 2D three) modes of each body.
 */
template <int dim>
class RigidBodyConstraints
{
public:
  /** A linear form: its value in every rigid motion, body by body. */
  using LinearForm = dealii::Vector<double>;

  /** The point that the motions of a body turn about, and half its size, which
   * makes them all of order one. */
  struct Frame
  {
    dealii::Point<dim> center;
    double length;
  };

  static Frame
  frame_of(const std::vector<dealii::Point<dim>> &points);

  explicit RigidBodyConstraints(const std::vector<Frame> &bodies);

  /** Add the displacement of a point of a body along `direction` to a form (see
   * zero()). A force does this as work, with its length. */
  void
  add_displacement(const unsigned int body,
                   const dealii::Point<dim> &point,
                   const dealii::Tensor<1, dim> &direction,
                   LinearForm &form) const;

  LinearForm
  zero() const;

  /** What is left of a form where all that is held does not move: for a
   * displacement of length one, from 0 to about 1. */
  LinearForm
  unconstrained_part(const LinearForm &form) const;

  /** Hold a form, unless it is held already. */
  void
  hold(const LinearForm &form);

  /** Hold what a support does of a point. */
  void
  hold(const unsigned int body, const HeldPoint<dim> &point);

  bool
  holds_all() const;

  /** Whether a body has no motion left. */
  bool
  holds(const unsigned int body) const;

  /**
   * Hold displacement components of points, as few as stop all motions: one by
   * one the component that stops most.
   *
   * @param points candidates, for each body.
   * @return for each body what is held of its points.
   */
  std::vector<std::vector<PointComponent>>
  hold_all(const std::vector<std::vector<dealii::Point<dim>>> &points);

private:
  const std::vector<Frame> frames;
  std::vector<LinearForm> basis;
};

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
