// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <deal.II/base/index_set.h>

#include <setsudan/mechanics/elastic_model.h>
#include <setsudan/mesh/coarse_mesh.h>

#include <set>
#include <utility>
#include <vector>

namespace Setsudan
{
/**
 * The hat psi of a corner of some faces of elements: linear along each line,
 * one at the corner and zero at all others. Pressure is interpolated by hats,
 * and gaps are weighted with them: with the faces' own shape functions N, node
 * k has the weight
 *   M_k = integral of psi N_k,
 * so that a uniform pressure exerts just the forces that are in equilibrium
 * with a uniform stress, also on faces of serendipity elements, whose corners
 * take negative forces. Pressure is not negative where its values at the
 * corners are not.
 */
template <int dim>
struct FaceHat
{
  using NodeIndices = typename Discretization<dim>::NodeIndices;

  /** The unknowns of the corner. */
  NodeIndices corner;
  /** An element that has it. */
  unsigned int element = 0;
  /** The integral of the hat, and the mean position over it. */
  double area = 0;
  dealii::Point<dim> center;
  /** The nodes around it and their weights; a hanging node is left to those
   * between which it hangs. */
  std::vector<std::pair<NodeIndices, double>> nodes;
};

/** The hats of some faces, ascending by their corners: the same on all
 * processes, which all call it.
 *
 * @param faces of elements, of which all cells' faces are taken. */
template <int dim>
std::vector<FaceHat<dim>>
face_hats(const ElasticModel<dim> &model, const std::vector<CellFace> &faces);

/** The outer faces of a mesh that look against a direction.
 *
 * @param least_cosine of the angle between their outward normal and the
 *   opposite direction. */
template <int dim>
std::vector<CellFace>
outer_faces_against(const CoarseMesh<dim> &mesh,
                    const dealii::Tensor<1, dim> &direction,
                    const double least_cosine = 0.2);

/** All unknowns of the nodes of hats.
 *
 * @param with_hats what has a FaceHat as its member `hat`. */
template <typename WithHat>
dealii::IndexSet
unknowns_of(const std::vector<WithHat> &with_hats,
            const dealii::types::global_dof_index n_unknowns)
{
  std::set<dealii::types::global_dof_index> all;
  for (const auto &one : with_hats)
    for (const auto &[node, weight] : one.hat.nodes)
      all.insert(node.begin(), node.end());
  dealii::IndexSet indices(n_unknowns);
  indices.add_indices(all.begin(), all.end());
  return indices;
}
} // namespace Setsudan
