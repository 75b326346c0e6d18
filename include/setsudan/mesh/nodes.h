// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <deal.II/base/geometry_info.h>
#include <deal.II/base/point.h>

#include <array>
#include <optional>

namespace Setsudan
{
/** Nodes of a serendipity element: its vertices, then its lines' midpoints. */
template <int dim>
constexpr unsigned int n_element_nodes =
  dealii::GeometryInfo<dim>::vertices_per_cell +
  dealii::GeometryInfo<dim>::lines_per_cell;

/**
 * The two vertices of a cell between which one of its nodes lies; for a
 * corner node both are the corner. Nodes and vertices in deal.II's order.
 */
template <int dim>
std::array<unsigned int, 2>
vertices_of_node(const unsigned int node);

/** The position of a node on the reference cell [0, 1]^dim. */
template <int dim>
dealii::Point<dim>
unit_point_of_node(const unsigned int node);

/** The node at a point of the reference cell, if there is one. */
template <int dim>
std::optional<unsigned int>
node_at(const dealii::Point<dim> &unit_point);

/** Whether a node of the reference cell lies on one of its faces. */
template <int dim>
bool
node_is_on_face(const unsigned int node, const unsigned int face);
} // namespace Setsudan
