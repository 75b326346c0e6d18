#pragma once

#include <deal.II/base/tensor.h>

#include <setsudan/parameters/parameters.h>

#include <vector>

namespace Setsudan
{
/** A force at a position along the edge. */
struct EdgeLoad
{
  double position;
  double force;
};

/** Subsection `Blade`. */
template <int dim>
struct BladeParameters
{
  double sharpness;
  double thickness;
  /** Unit vector of the blade's travel. */
  dealii::Tensor<1, dim> direction;
  std::vector<EdgeLoad> edge_loads;

  static void
  declare(dealii::ParameterHandler &handler);

  explicit BladeParameters(const Parameters &parameters);
};
} // namespace Setsudan
