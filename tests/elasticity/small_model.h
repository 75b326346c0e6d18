// An elastic box with supports and loads, from assignments as the command line
// has them: {"Body/Elements=2,1,1", "Load/Pressures=top:1"}.
#pragma once

#include <setsudan/elasticity/elastic_model.h>

#include <cmath>

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
    MaterialParameters::declare(handler);
    LoadParameters<dim>::declare(handler);
  }

  /** On the elements of `mesh`, or on the body's own. */
  SmallModel(const Parameters &parameters, const CoarseMesh<dim> *mesh)
    : SmallBody<dim>(parameters)
    , material(parameters)
    , loads(parameters, this->body)
    , model(mesh == nullptr ? this->body.mesh : *mesh,
            this->body,
            this->supports,
            loads,
            Hooke(material.youngs_modulus, material.poissons_ratio),
            MPI_COMM_WORLD)
  {
  }

  explicit SmallModel(const Assignments &assignments,
                      const CoarseMesh<dim> *mesh = nullptr)
    : SmallModel(parameters_of(assignments, declare), mesh)
  {
  }

  const MaterialParameters material;
  const LoadParameters<dim> loads;
  ElasticModel<dim> model;
};


/** The displacement whose value at a node is `value(position)`. */
template <int dim, typename Function>
LA::Vector
nodal_values(const Discretization<dim> &discretization, const Function &value)
{
  LA::Vector vector  = discretization.zero_vector();
  const auto sites   = discretization.sites();
  unsigned int local = 0;
  for (const auto index : discretization.owned)
    {
      vector(index) = value(sites[local].position)[sites[local].component];
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
  const double length = std::pow(mesh.cell_volume(0), 1. / dim);
  for (unsigned int v = 0; v < mesh.vertices.size(); ++v)
    for (unsigned int d = 0; d < dim; ++d)
      mesh.vertices[v][d] += 0.04 * length * ((5 * v + 3 * d) % 7);
  return mesh;
}
} // namespace Setsudan
