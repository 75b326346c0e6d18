// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <deal.II/base/quadrature.h>

#include <setsudan/material/material_parameters.h>
#include <setsudan/mechanics/dilatation.h>
#include <setsudan/mechanics/internal_variables.h>

#include <memory>
#include <optional>
#include <vector>

namespace Setsudan
{
/** Where in a cell stress is asked for: its nodes, or its Gauss points. */
template <int dim>
dealii::Quadrature<dim>
node_points(const Discretization<dim> &discretization);

template <int dim>
dealii::Quadrature<dim>
gauss_points(const Discretization<dim> &discretization);

/**
 * Displacement gradients of a cell, and the strain and stress that follow
 * (equations 6 and 7 of Kakefuda et al. 1996), evaluated directly where they
 * are asked for: no extrapolation, no averaging. The element's functions
 * interpolate displacement and position alike. A point costs what is asked of
 * it, and nothing else.
 */
template <int dim>
class StressEvaluator
{
public:
  using Cell = typename Discretization<dim>::Cell;

  /**
   * Where laws have internal variables, those of the state that was evaluated
   * last are known at Gauss points. Elsewhere in a cell they are the linear
   * function that is nearest to them, from which the law answers to the strain
   * there.
   *
   * @param discretization, materials and internal must live as long.
   * @param points in reference coordinates; their weights matter to volume()
   *   only.
   * @param internal if not null, stress is asked for in cells of this process
   *   only.
   */
  StressEvaluator(const Discretization<dim> &discretization,
                  const MaterialParameters<dim> &materials,
                  const dealii::Quadrature<dim> &points,
                  const InternalVariables<dim> *internal = nullptr);

  /** Go to a cell.
   *
   * @param displacement with ghosts; must live as long as stresses are asked
   *   for. */
  void
  reinit(const Cell &cell, const LA::Vector &displacement);

  unsigned int
  n_points() const;

  /** The position of a point in the body at rest. */
  dealii::Point<dim>
  point(const unsigned int point) const;

  /** The volume that a point of a quadrature rule stands for. */
  double
  volume(const unsigned int point) const;

  dealii::Tensor<2, dim>
  gradient(const unsigned int point) const;

  dealii::SymmetricTensor<2, dim>
  strain(const unsigned int point) const;

  dealii::SymmetricTensor<2, 3>
  stress(const unsigned int point) const;

  /** The stresses at all points. */
  std::vector<dealii::SymmetricTensor<2, 3>>
  stresses() const;

  /** The values at all points of a field of the displacement's kind, with
   * ghosts. */
  std::vector<dealii::Tensor<1, dim>>
  values(const LA::Vector &field) const;

private:
  /** The stress of a law with internal variables. */
  dealii::SymmetricTensor<2, 3>
  stress_with_memory(const unsigned int point) const;

  /** The derivative of the position by the reference coordinates. */
  dealii::Tensor<2, dim>
  jacobian(const unsigned int point) const;

  const Discretization<dim> &discretization;
  const MaterialParameters<dim> &materials;
  const std::vector<double> weights;
  /** Of each function at each point, in reference coordinates:
   * [point][function]. */
  std::vector<std::vector<double>> function_values;
  std::vector<std::vector<dealii::Tensor<1, dim>>> function_gradients;
  /** Only where a material needs it. */
  std::unique_ptr<Dilatation<dim>> dilatation;
  /** Null where no law has any. */
  const InternalVariables<dim> *internal = nullptr;
  /** What each Gauss point's internal variables count at each point:
   * [point][Gauss point]. */
  std::vector<std::vector<double>> internal_weights;

  // Of the present cell.
  std::vector<typename Discretization<dim>::NodeIndices> indices;
  std::vector<dealii::Point<dim>> positions;
  std::vector<dealii::Tensor<1, dim>> displacements;
  const Material *material = nullptr;
  Cell present;
  const LA::Vector *field = nullptr;
  /** What Dilatation says of the cell, once a stress has been asked for. */
  mutable std::optional<LinearFunction<dim>> projected;
};
} // namespace Setsudan
