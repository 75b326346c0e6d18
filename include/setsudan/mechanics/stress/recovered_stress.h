// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <setsudan/mechanics/elastic_model.h>
#include <setsudan/mechanics/stress/stress_evaluator.h>

#include <array>
#include <vector>

namespace Setsudan
{
/**
 * A continuous stress field that is nearer to the exact one than the elements'
 * own. Around each vertex the stress at the 2^dim Gauss points of the cells
 * that meet there, where it is most accurate, is fitted by a polynomial, whose
 * values at the nodes are interpolated by the shape functions (Zienkiewicz and
 * Zhu 1992, International Journal for Numerical Methods in Engineering 33,
 * 1331-1364). The polynomial is cubic, one degree more than theirs: at the
 * boundary, where a fit is extended beyond the middle of its cells, the error
 * of a quadratic one is larger than the elements' own on the meshes in use.
 *
 * Only cells of one material are put together, and the two sides of a cut are
 * two fields. Components are held in vectors of the displacement's kind, dim in
 * each.
 */
template <int dim>
class RecoveredStress
{
public:
  using Cell = typename Discretization<dim>::Cell;

  /** @param displacement with ghosts. */
  RecoveredStress(const ElasticModel<dim> &model,
                  const LA::Vector &displacement);

  /** The stress at the points of an evaluator, which has been set to `cell`. */
  std::vector<dealii::SymmetricTensor<2, 3>>
  evaluate(const Cell &cell, const StressEvaluator<dim> &points) const;

private:
  /** Vectors that are needed for 6 components in space, 4 in the plane. */
  static constexpr unsigned int n_vectors = 2;
  using Field                             = std::array<LA::Vector, n_vectors>;

  Field
  recover(const unsigned int material, const LA::Vector &displacement) const;

  const ElasticModel<dim> &model;
  /** With ghosts, for each material. */
  std::vector<Field> fields;
};
} // namespace Setsudan
