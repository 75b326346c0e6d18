#pragma once

#include <setsudan/material/material_parameters.h>
#include <setsudan/mechanics/dilatation.h>

#include <memory>
#include <vector>

namespace Setsudan
{
/**
 * The stress at single nodes of a cell, as StrainRecovery has it there
 * (equations 6 and 7 of Kakefuda et al. 1996), without looking at the others.
 */
template <int dim>
class NodeStresses
{
public:
  using Cell = typename Discretization<dim>::Cell;

  /** @param discretization and materials must live as long. */
  NodeStresses(const Discretization<dim> &discretization,
               const MaterialParameters<dim> &materials);

  /** The stresses at some nodes of a cell.
   *
   * @param displacement with ghosts. */
  std::vector<dealii::SymmetricTensor<2, 3>>
  operator()(const Cell &cell,
             const std::vector<unsigned int> &nodes,
             const LA::Vector &displacement) const;

private:
  const Discretization<dim> &discretization;
  const MaterialParameters<dim> &materials;
  /** Of each function at each node, in reference coordinates: [node][function].
   */
  std::vector<std::vector<dealii::Tensor<1, dim>>> gradients;
  /** Only where a material needs it. */
  std::unique_ptr<Dilatation<dim>> dilatation;
};
} // namespace Setsudan
