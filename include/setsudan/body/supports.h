#pragma once

#include <deal.II/base/point.h>
#include <deal.II/base/types.h>

#include <setsudan/body/body.h>
#include <setsudan/parameters/parameters.h>

#include <set>
#include <vector>

namespace Setsudan
{
/** Subsection `Support`: what holds the body. */
template <int dim>
struct SupportParameters
{
  std::set<dealii::types::boundary_id> faces;
  std::set<unsigned int> nodes;

  static void
  declare(dealii::ParameterHandler &handler);

  /** @throw SceneError for a face or node that does not exist. */
  SupportParameters(const Parameters &parameters, const Body<dim> &body);
};

/**
 * Which nodes are fixed, in all directions. It is asked by cell and node of
 * the cell, so that the copies of a node that was split stay fixed.
 */
template <int dim>
class Supports
{
public:
  Supports(const SupportParameters<dim> &parameters, const Body<dim> &body);

  /**
   * Whether `node` of `cell` is fixed as far as this cell knows: its own faces
   * on the boundary, and the node's number. A node that touches a fixed face
   * of another cell only is fixed through that cell.
   */
  bool
  is_fixed(const unsigned int cell, const unsigned int node) const;

  /** Positions of the fixed nodes of some cells; a node may appear twice. */
  std::vector<dealii::Point<dim>>
  fixed_points(const std::vector<unsigned int> &cells) const;

private:
  const SupportParameters<dim> parameters;
  const Body<dim> &body;
};
} // namespace Setsudan
