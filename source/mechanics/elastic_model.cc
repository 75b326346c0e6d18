// SPDX-License-Identifier: LGPL-2.1-or-later
#include <deal.II/base/mpi.h>
#include <deal.II/dofs/dof_tools.h>

#include <setsudan/mechanics/cell_batches.h>
#include <setsudan/mechanics/elastic_model.h>
#include <setsudan/mechanics/law_integration.h>

namespace Setsudan
{
using namespace dealii;

template <int dim>
ElasticModel<dim>::ElasticModel(const CoarseMesh<dim> &mesh,
                                const Refinement &refinement,
                                const Body<dim> &body,
                                const Supports<dim> &supports_of_body,
                                const LoadParameters<dim> &load_parameters,
                                const MaterialParameters<dim> &materials,
                                const MPI_Comm communicator,
                                const ElementType element_type)
  : materials(materials)
  , discretization(mesh, refinement, communicator, element_type)
  , internal(discretization,
             materials,
             Utilities::pow(discretization.n_gauss_points(), dim))
  , stiffness(discretization, materials)
  , hanging(discretization.relevant)
  , supports(discretization.relevant)
  , supported(discretization.dof_handler.n_dofs())
  , lift(discretization.zero_vector())
  , loads(assemble_loads(discretization, load_parameters, body))
{
  if (!refinement.refined.empty())
    DoFTools::make_hanging_node_constraints(discretization.dof_handler,
                                            hanging);
  hanging.close();
  constrain_supports(supports_of_body);
}



template <int dim>
ElasticModel<dim>::~ElasticModel() = default;


template <int dim>
void
ElasticModel<dim>::constrain_supports(const Supports<dim> &supports_of_body)
{
  for (const auto &cell : discretization.dof_handler.active_cell_iterators())
    if (!cell->is_artificial())
      {
        const unsigned int element = discretization.element(cell);
        const auto nodes           = discretization.node_indices(cell);
        const auto points          = discretization.points_in_element(cell);
        for (unsigned int node = 0; node < nodes.size(); ++node)
          {
            const auto support = supports_of_body.at(element, points[node]);
            for (unsigned int c = 0; c < dim; ++c)
              {
                const auto index = nodes[node][c];
                if (!support.components[c] || hanging.is_constrained(index))
                  continue;
                supports.add_line(index);
                if (support.displacement[c] != 0 &&
                    discretization.owned.is_element(index))
                  lift(index) = support.displacement[c];
              }
          }
      }
  supports.close();
  lift.compress(VectorOperation::insert);
  hanging.distribute(lift);
  for (const auto index : discretization.owned)
    if (supports.is_constrained(index))
      supported.add_index(index);
  supported.compress();
}



template <int dim>
CellBatches<dim> &
ElasticModel<dim>::batches() const
{
  if (!cell_batches)
    cell_batches =
      std::make_unique<CellBatches<dim>>(discretization, materials);
  return *cell_batches;
}



template <int dim>
bool
ElasticModel<dim>::is_linear() const
{
  return materials.is_linear();
}



namespace
{
/** Evaluate the laws in all cells of this process. */
template <int dim>
void
for_each_cell(
  const ElasticModel<dim> &model,
  const LA::Vector &displacement,
  const std::function<void(const LawIntegration<dim> &,
                           const typename Discretization<dim>::Cell &)> &use)
{
  const LA::Vector u = model.discretization.with_ghosts(displacement);
  LawIntegration<dim> laws(
    model.discretization, model.materials, model.internal);
  for (const auto &cell :
       model.discretization.dof_handler.active_cell_iterators())
    if (cell->is_locally_owned())
      {
        laws.reinit(cell, u, false);
        use(laws, cell);
      }
}
} // namespace


template <int dim>
LA::Vector
internal_forces(const ElasticModel<dim> &model, const LA::Vector &displacement)
{
  if (!model.is_linear())
    {
      LA::Vector forces = model.discretization.zero_vector();
      std::vector<types::global_dof_index> indices(
        model.discretization.fe.n_dofs_per_cell());
      for_each_cell<dim>(
        model, displacement, [&](const auto &laws, const auto &cell) {
          cell->get_dof_indices(indices);
          forces.add(indices, laws.forces);
        });
      forces.compress(VectorOperation::add);
      return forces;
    }
  if (model.discretization.type == ElementType::linear)
    return internal_forces(model.discretization,
                           model.stiffness,
                           model.discretization.with_ghosts(displacement));
  return internal_forces(model.batches(), displacement);
}



template <int dim>
void
assemble_tangent(const ElasticModel<dim> &model,
                 const LA::Vector *displacement,
                 const AffineConstraints<double> &constraints,
                 LA::SparseMatrix &matrix)
{
  if (model.is_linear())
    {
      assemble_stiffness(
        model.discretization, model.stiffness, constraints, matrix);
      return;
    }
  const LA::Vector u = model.discretization.with_ghosts(*displacement);
  LawIntegration<dim> laws(
    model.discretization, model.materials, model.internal);
  assemble_matrix<dim>(
    model.discretization,
    [&](const auto &cell) -> const FullMatrix<double> & {
      laws.reinit(cell, u, true);
      return laws.tangent;
    },
    constraints,
    matrix);
}



template <int dim>
double
stored_energy(const ElasticModel<dim> &model,
              const LA::Vector &displacement,
              const LA::Vector &internal)
{
  if (model.is_linear())
    return 0.5 * (displacement * internal);
  double energy = 0;
  for_each_cell<dim>(model, displacement, [&](const auto &laws, const auto &) {
    energy += laws.energy;
  });
  return Utilities::MPI::sum(energy, model.discretization.communicator);
}



template struct ElasticModel<2>;
template struct ElasticModel<3>;
template LA::Vector
internal_forces(const ElasticModel<2> &, const LA::Vector &);
template void
assemble_tangent(const ElasticModel<2> &,
                 const LA::Vector *,
                 const AffineConstraints<double> &,
                 LA::SparseMatrix &);
template double
stored_energy(const ElasticModel<2> &, const LA::Vector &, const LA::Vector &);
template LA::Vector
internal_forces(const ElasticModel<3> &, const LA::Vector &);
template void
assemble_tangent(const ElasticModel<3> &,
                 const LA::Vector *,
                 const AffineConstraints<double> &,
                 LA::SparseMatrix &);
template double
stored_energy(const ElasticModel<3> &, const LA::Vector &, const LA::Vector &);
} // namespace Setsudan
