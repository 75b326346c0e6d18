// SPDX-License-Identifier: LGPL-2.1-or-later
#include <deal.II/base/mpi.h>
#include <deal.II/dofs/dof_tools.h>

#include <setsudan/mechanics/cell_batches.h>
#include <setsudan/mechanics/elastic_model.h>
#include <setsudan/mechanics/follower_pressure.h>
#include <setsudan/mechanics/law_integration.h>
#include <setsudan/mechanics/law_kernel.h>

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
  , load_parameters(load_parameters)
  , discretization(mesh, refinement, communicator, element_type)
  , internal(discretization,
             materials,
             Utilities::pow(discretization.n_gauss_points(), dim))
  , stiffness(discretization, materials)
  , hanging(discretization.relevant)
  , supports(discretization.relevant)
  , supported(discretization.dof_handler.n_dofs())
  , lift(discretization.zero_vector())
  , loads(assemble_loads(discretization,
                         load_parameters,
                         body,
                         materials.finite_strain))
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
void
ElasticModel<dim>::set_load_factor(const double factor)
{
  if (factor == factor_of_loads)
    return;
  if (loads_of_scene.size() == 0)
    {
      loads_of_scene = loads;
      lift_of_scene  = lift;
    }
  factor_of_loads = factor;
  loads.equ(factor, loads_of_scene);
  lift.equ(factor, lift_of_scene);
}



template <int dim>
bool
ElasticModel<dim>::is_linear() const
{
  return materials.is_linear();
}



namespace
{
/** Forces and tangents of cells, with those of the pressures on them. */
template <int dim>
class CellForces
{
public:
  using Cell = typename Discretization<dim>::Cell;

  explicit CellForces(const ElasticModel<dim> &model)
    : laws(model.discretization, model.materials, model.internal)
    , load_factor(model.load_factor())
  {
    if (model.materials.finite_strain)
      pressure = std::make_unique<FollowerPressure<dim>>(model.discretization,
                                                         model.load_parameters);
  }

  /** The vectors have ghosts. */
  void
  reinit(const Cell &cell, const LA::Vector &u)
  {
    laws.reinit(cell, u);
    potential_of_pressure = 0;
    if (pressure && pressure->reinit(cell, u, false))
      {
        laws.forces.add(-load_factor, pressure->forces);
        potential_of_pressure = load_factor * pressure->potential;
      }
  }

  /** @param before see LawIntegration::reinit_with_tangent(). */
  void
  reinit_with_tangent(const Cell &cell,
                      const LA::Vector &u,
                      const LA::Vector *before)
  {
    laws.reinit_with_tangent(cell, u, before);
    if (pressure && pressure->reinit(cell, u, true))
      laws.tangent.add(-load_factor, pressure->tangent);
  }

  LawIntegration<dim> laws;
  double potential_of_pressure = 0;

private:
  std::unique_ptr<FollowerPressure<dim>> pressure;
  const double load_factor;
};
} // namespace


template <int dim>
InternalForces
evaluate_laws(const ElasticModel<dim> &model, const LA::Vector &displacement)
{
  if (has_law_kernel(model))
    return evaluate_by_kernel(model, displacement);
  const LA::Vector u = model.discretization.with_ghosts(displacement);
  CellForces<dim> of_cell(model);
  InternalForces result;
  result.forces = assemble_forces<dim>(
    model.discretization, [&](const auto &cell, const auto &) {
      of_cell.reinit(cell, u);
      result.energy.add(1, of_cell.laws.energy);
      result.potential_of_pressure += of_cell.potential_of_pressure;
      return &of_cell.laws.forces;
    });
  for (double *const sum : {&result.energy.potential,
                            &result.energy.stored,
                            &result.energy.plastic,
                            &result.energy.viscous,
                            &result.potential_of_pressure})
    *sum = Utilities::MPI::sum(*sum, model.discretization.communicator);
  return result;
}



template <int dim>
LA::Vector
follower_forces(const ElasticModel<dim> &model, const LA::Vector &displacement)
{
  const auto &discretization = model.discretization;
  if (!model.materials.finite_strain || !model.load_parameters.has_pressure())
    return discretization.zero_vector();
  FollowerPressure<dim> pressure(discretization, model.load_parameters);
  const LA::Vector u = discretization.with_ghosts(displacement);
  LA::Vector forces =
    assemble_forces<dim>(discretization, [&](const auto &cell, const auto &) {
      return pressure.reinit(cell, u, false) ? &pressure.forces : nullptr;
    });
  forces *= model.load_factor();
  return forces;
}



template <int dim>
LA::Vector
internal_forces(const ElasticModel<dim> &model, const LA::Vector &displacement)
{
  if (!model.is_linear())
    return evaluate_laws(model, displacement).forces;
  if (model.discretization.type == ElementType::linear ||
      !model.materials.is_hookean())
    return internal_forces(model.discretization,
                           model.stiffness,
                           model.discretization.with_ghosts(displacement));
  return internal_forces(model.batches(), displacement);
}



namespace
{
/** A displacement on all cells that this process knows; empty for none. */
template <int dim>
LA::Vector
with_ghosts(const ElasticModel<dim> &model, const LA::Vector *displacement)
{
  return displacement != nullptr
           ? model.discretization.with_ghosts(*displacement)
           : LA::Vector();
}
} // namespace


template <int dim>
void
assemble_tangent(const ElasticModel<dim> &model,
                 const Linearization &linearization,
                 const AffineConstraints<double> &constraints,
                 LA::SparseMatrix &matrix)
{
  if (model.is_linear())
    {
      assemble_stiffness(
        model.discretization, model.stiffness, constraints, matrix);
      return;
    }
  if (has_law_kernel(model))
    {
      TangentMatrices<dim> matrices(model,
                                    tangent_by_kernel(model, linearization));
      unsigned int number = 0;
      assemble_matrix<dim>(
        model.discretization,
        [&](const auto &) -> const FullMatrix<double> & {
          // The batches have the cells in this order.
          return matrices(number++);
        },
        constraints,
        matrix);
      return;
    }
  const LA::Vector u      = with_ghosts(model, linearization.about);
  const LA::Vector before = with_ghosts(model, linearization.before);
  CellForces<dim> of_cell(model);
  assemble_matrix<dim>(
    model.discretization,
    [&](const auto &cell) -> const FullMatrix<double> & {
      of_cell.reinit_with_tangent(
        cell, u, linearization.before != nullptr ? &before : nullptr);
      return of_cell.laws.tangent;
    },
    constraints,
    matrix);
}



template <int dim>
LA::Vector
tangent_times(const ElasticModel<dim> &model,
              const LA::Vector &displacement,
              const LA::Vector &direction)
{
  const auto &discretization = model.discretization;
  const LA::Vector u         = discretization.with_ghosts(displacement);
  const LA::Vector d         = discretization.with_ghosts(direction);
  CellForces<dim> forces(model);
  const unsigned int n = discretization.fe.n_dofs_per_cell();
  dealii::Vector<double> of_cell(n), product(n);
  return assemble_forces<dim>(
    discretization,
    [&](const auto &cell,
        const auto &indices) -> const dealii::Vector<double> * {
      d.extract_subvector_to(indices.begin(), indices.end(), of_cell.begin());
      if (of_cell.all_zero())
        return nullptr;
      forces.reinit_with_tangent(cell, u, nullptr);
      forces.laws.tangent.vmult(product, of_cell);
      return &product;
    });
}



#define INSTANTIATE(dim)                                            \
  template struct ElasticModel<dim>;                                \
  template InternalForces evaluate_laws(const ElasticModel<dim> &,  \
                                        const LA::Vector &);        \
  template LA::Vector follower_forces(const ElasticModel<dim> &,    \
                                      const LA::Vector &);          \
  template LA::Vector internal_forces(const ElasticModel<dim> &,    \
                                      const LA::Vector &);          \
  template void assemble_tangent(const ElasticModel<dim> &,         \
                                 const Linearization &,             \
                                 const AffineConstraints<double> &, \
                                 LA::SparseMatrix &);               \
  template LA::Vector tangent_times(                                \
    const ElasticModel<dim> &, const LA::Vector &, const LA::Vector &);

INSTANTIATE(2)
INSTANTIATE(3)

#undef INSTANTIATE
} // namespace Setsudan
