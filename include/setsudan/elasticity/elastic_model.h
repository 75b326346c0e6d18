#pragma once

#include <setsudan/body/supports.h>
#include <setsudan/elasticity/loads.h>
#include <setsudan/elasticity/stiffness.h>

namespace Setsudan
{
/** All of the elastic body that hangs on its mesh, and is made anew when the
 * mesh is cut. */
template <int dim>
struct ElasticModel
{
  ElasticModel(const CoarseMesh<dim> &mesh,
               const Body<dim> &body,
               const Supports<dim> &supports,
               const LoadParameters<dim> &load_parameters,
               const Hooke &material,
               const MPI_Comm communicator);

  const Hooke material;
  Discretization<dim> discretization;
  ElementStiffness<dim> stiffness;
  /** The supports' constraints, closed. */
  dealii::AffineConstraints<double> supports;
  /** The unknowns of this process that a support holds. */
  dealii::IndexSet supported;
  /** Nodal forces of the loads, without the blade. */
  LA::Vector loads;
};
} // namespace Setsudan
