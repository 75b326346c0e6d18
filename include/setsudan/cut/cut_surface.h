#pragma once

#include <deal.II/base/tensor.h>

#include <setsudan/body/body.h>
#include <setsudan/parameters/parameters.h>

#include <string>
#include <vector>

namespace Setsudan
{
/** An interior element face that a cut opens, as seen from its two sides. */
template <int dim>
struct CutFace
{
  CellFace minus;
  CellFace plus;
  /** Unit vector from minus to plus, the side of the larger coordinate. */
  dealii::Tensor<1, dim> normal;
};

/** The faces that one cut opens. */
template <int dim>
using CutSurface = std::vector<CutFace<dim>>;

/** One item of `Cut/Surfaces`: a boundary between layers of elements. */
struct AxisCut
{
  unsigned int axis;
  /** The paper's dn: the boundary behind this many layers. */
  unsigned int boundary;
  /** As the scene has it, for messages. */
  std::string text;
};

/** Subsection `Cut`: where the body is cut, one cut after the other. */
template <int dim>
struct CutParameters
{
  std::vector<AxisCut> surfaces;

  static void
  declare(dealii::ParameterHandler &handler);

  CutParameters(const Parameters &parameters, const BodyParameters<dim> &body);
};

/** The element faces of an AxisCut (equations 19, 23, 26 of Kakefuda et al.
 * 1996 name the elements behind it). */
template <int dim>
CutSurface<dim>
make_cut_surface(const Body<dim> &body, const AxisCut &cut);
} // namespace Setsudan
