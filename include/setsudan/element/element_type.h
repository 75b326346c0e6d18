// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <deal.II/fe/fe.h>

#include <memory>

namespace Setsudan
{
/** Which functions the displacement is made of in each cell. The first nodes of
 * all types are the same: vertices, then the middles of lines. */
enum class ElementType
{
  /** Nodes at the vertices: deal.II's FE_Q(1). */
  linear,
  /** Nodes in the middle of lines too, 20 in 3D: FE_Q_Serendipity. */
  serendipity,
  /** Nodes in the middle of faces and inside too, 27 in 3D: FE_Q(2). */
  quadratic
};

/** The element of one component of the displacement. */
template <int dim>
std::unique_ptr<dealii::FiniteElement<dim>>
make_element(const ElementType type);
} // namespace Setsudan
