// SPDX-License-Identifier: LGPL-2.1-or-later
// An elastic box with supports and loads, from assignments as the command line
// has them: {"Body/Elements=2,1,1", "Load/Pressures=top:1"}.
#pragma once

#include <setsudan/mechanics/elastic_model.h>
#include <setsudan/mesh/geometry.h>
#include <setsudan/parameters/lists.h>

#include <cmath>
#include <vector>

#include "../body/small_body.h"

namespace Setsudan
{
template <int dim>
struct SmallModel : SmallBody<dim>
{
  static void
  declare(dealii::ParameterHandler &handler)
  {
    SmallBody<dim>::declare(handler);
    MaterialParameters<dim>::declare(handler);
    LoadParameters<dim>::declare(handler);
  }

  /** On the elements of `mesh`, or on the body's own. */
  SmallModel(const Parameters &parameters,
             const CoarseMesh<dim> *mesh,
             const Refinement &refinement = {})
    : SmallBody<dim>(parameters)
    , material(parameters, this->body)
    , loads(parameters, this->body)
    , model(mesh == nullptr ? this->body.mesh : *mesh,
            refinement,
            this->body,
            this->supports,
            loads,
            material,
            MPI_COMM_WORLD,
            BodyParameters<dim>(parameters).element_type)
  {
  }

  explicit SmallModel(const Assignments &assignments,
                      const CoarseMesh<dim> *mesh  = nullptr,
                      const Refinement &refinement = {})
    : SmallModel(parameters_of(assignments, declare), mesh, refinement)
  {
  }

  const MaterialParameters<dim> material;
  const LoadParameters<dim> loads;
  ElasticModel<dim> model;
};


/** One material for all elements of a mesh. */
template <int dim>
MaterialParameters<dim>
material_of(const CoarseMesh<dim> &mesh, const double E, const double nu)
{
  Body<dim> body;
  body.mesh = mesh;
  return MaterialParameters<dim>(
    parameters_of({"Material/Young's modulus=" + short_text(E),
                   "Material/Poisson's ratio=" + short_text(nu)},
                  MaterialParameters<dim>::declare),
    body);
}


/** The displacement whose value at a node is `value(position)`. */
template <int dim, typename Function>
LA::Vector
nodal_values(const Discretization<dim> &discretization, const Function &value)
{
  LA::Vector vector         = discretization.zero_vector();
  const auto &dof_locations = discretization.dof_locations();
  unsigned int local        = 0;
  for (const auto index : discretization.owned)
    {
      vector(index) =
        value(dof_locations[local].position)[dof_locations[local].component];
      ++local;
    }
  vector.compress(dealii::VectorOperation::insert);
  return vector;
}


/** The mesh with its vertices moved, so that no two elements are alike. */
template <int dim>
CoarseMesh<dim>
distorted(CoarseMesh<dim> mesh)
{
  const double length =
    std::pow(volume_of_element(mesh.node_positions(0)), 1. / dim);
  for (unsigned int v = 0; v < mesh.vertices.size(); ++v)
    for (unsigned int d = 0; d < dim; ++d)
      mesh.vertices[v][d] += 0.04 * length * ((5 * v + 3 * d) % 7);
  return mesh;
}


/** A straight mesh with the middle nodes of its lines moved as well, the same
 * way in all elements that share a line. */
template <int dim>
CoarseMesh<dim>
curved(CoarseMesh<dim> mesh)
{
  constexpr unsigned int n_corners =
    dealii::GeometryInfo<dim>::vertices_per_cell;
  const double length =
    std::pow(volume_of_element(mesh.node_positions(0)), 1. / dim);
  std::vector<typename CoarseMesh<dim>::LineNodes> line_nodes;
  for (unsigned int cell = 0; cell < mesh.cells.size(); ++cell)
    {
      line_nodes.emplace_back();
      for (unsigned int line = 0; line < line_nodes.back().size(); ++line)
        {
          const auto ends = vertices_of_node<dim>(n_corners + line);
          const auto a    = mesh.cells[cell].vertices[ends[0]];
          const auto b    = mesh.cells[cell].vertices[ends[1]];
          auto &node      = line_nodes.back()[line];
          node            = mesh.node_position(cell, n_corners + line);
          for (unsigned int d = 0; d < dim; ++d)
            node[d] += 0.02 * length * ((3 * (a + b) + 2 * d) % 5);
        }
    }
  mesh.line_nodes = line_nodes;
  return mesh;
}
} // namespace Setsudan
