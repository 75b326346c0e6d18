// SPDX-License-Identifier: LGPL-2.1-or-later
// What the kernels make of neo-Hookean laws for several cells at once is what
// the laws are point by point: forces, energy, and the tangent, exact and
// extrapolated, as a product and as matrices.

#include <setsudan/mechanics/law_integration.h>
#include <setsudan/mechanics/law_kernel.h>

#include <string>

#include "many_models.h"

using namespace Setsudan;


template <int dim>
void
test_forces(const ElasticModel<dim> &model, const LA::Vector &displacement)
{
  const LA::Vector u = model.discretization.with_ghosts(displacement);
  LawIntegration<dim> laws(
    model.discretization, model.materials, model.internal);
  double energy             = 0;
  const LA::Vector expected = assemble_forces<dim>(
    model.discretization, [&](const auto &cell, const auto &) {
      laws.reinit(cell, u);
      energy += laws.energy.potential;
      return &laws.forces;
    });
  energy            = Utilities::MPI::sum(energy, MPI_COMM_WORLD);
  const auto of_all = evaluate_by_kernel(model, displacement);
  LA::Vector forces = of_all.forces;
  forces -= expected;
  check_below_on_all(
    "  forces", forces.linfty_norm() / expected.linfty_norm(), 1e-13);
  check_below_on_all(
    "  energy", std::abs(of_all.energy.potential / energy - 1), 1e-13);
}


/** @param before from which the stress is extrapolated, or null. */
template <int dim>
void
test_tangent(const ElasticModel<dim> &model,
             const LA::Vector &displacement,
             const LA::Vector *before)
{
  const auto &discretization = model.discretization;
  const LA::Vector u         = discretization.with_ghosts(displacement),
                   from      = before != nullptr
                                 ? discretization.with_ghosts(*before)
                                 : LA::Vector(),
                   d = discretization.with_ghosts(deformed(discretization, 1));
  LawIntegration<dim> laws(discretization, model.materials, model.internal);
  const auto tangent = tangent_by_kernel(model, {&displacement, before});
  TangentMatrices<dim> matrices(model, tangent);
  double error         = 0;
  unsigned int number  = 0;
  const unsigned int n = discretization.fe.n_dofs_per_cell();
  dealii::Vector<double> of_cell(n), product(n);
  const LA::Vector expected = assemble_forces<dim>(
    discretization, [&](const auto &cell, const auto &indices) {
      laws.reinit_with_tangent(cell, u, before != nullptr ? &from : nullptr);
      FullMatrix<double> difference = matrices(number++);
      difference.add(-1, laws.tangent);
      error =
        std::max(error, difference.linfty_norm() / laws.tangent.linfty_norm());
      d.extract_subvector_to(indices.begin(), indices.end(), of_cell.begin());
      laws.tangent.vmult(product, of_cell);
      return &product;
    });
  check_below_on_all("  matrices of the tangent", error, 1e-13);
  auto &batches = model.batches();
  auto x        = batches.copy_in(deformed(discretization, 1));
  x.update_ghost_values();
  typename CellBatches<dim>::Vector y(batches.partitioner());
  batches.apply(x, y, tangent.get());
  y.compress(VectorOperation::add);
  LA::Vector result = batches.copy_out(y);
  result -= expected;
  check_below_on_all(
    "  product", result.linfty_norm() / expected.linfty_norm(), 1e-13);
}


template <int dim>
void
test(const CoarseMesh<dim> &mesh,
     const std::string &type,
     const std::string &law,
     const std::string &volumetric)
{
  const SmallModel<dim> small(
    Assignments{dim == 3 ? "Body/Elements=3,2,2" : "Body/Elements=3,3",
                "Body/Element type=" + type,
                "Deformation/Strain=finite",
                "Material/Poisson's ratio=0.3",
                "Material/Law=" + law,
                "Material/Volumetric energy=" + volumetric},
    &mesh);
  const auto &model = small.model;
  say(std::to_string(dim) + "D, " + type + ", " + law + ", " + volumetric +
      (has_law_kernel(model) ? "" : ": not known"));
  if (!has_law_kernel(model))
    return;
  const LA::Vector u      = deformed(model.discretization, 0.1),
                   before = deformed(model.discretization, 0.06);
  test_forces(model, u);
  test_tangent(model, u, nullptr);
  test_tangent(model, u, &before);
}


template <int dim>
void
test_all()
{
  const CoarseMesh<dim> box =
    SmallBody<dim>({dim == 3 ? "Body/Elements=3,2,2" : "Body/Elements=3,3"})
      .body.mesh;
  const CoarseMesh<dim> uneven = distorted(box), bent = curved(uneven);
  for (const std::string law : {"neo-Hooke", "isochoric neo-Hooke"})
    for (const std::string volumetric : {"Ciarlet", "quadratic", "logarithmic"})
      test<dim>(uneven, "serendipity", law, volumetric);
  test<dim>(box, "serendipity", "auto", "Ciarlet");
  test<dim>(bent, "serendipity", "auto", "Ciarlet");
  test<dim>(uneven, "quadratic", "auto", "Ciarlet");
  test<dim>(uneven, "linear", "auto", "Ciarlet");
  test<dim>(uneven, "serendipity", "Mooney-Rivlin", "Ciarlet");
}


/** A body that is turned inside out stores no finite energy. */
void
test_inside_out()
{
  const SmallModel<3> small(
    Assignments{"Body/Elements=2,2,2", "Deformation/Strain=finite"});
  const LA::Vector u =
    nodal_values(small.model.discretization, [](const Point<3> &p) {
      return Tensor<1, 3>({-2 * p[0], 0., 0.});
    });
  say(std::string("inside out: ") +
      (std::isinf(evaluate_by_kernel(small.model, u).energy.potential)
         ? "infinite"
         : "FAILED"));
}


int
main(int argc, char **argv)
{
  return run_test(argc, argv, [] {
    test_all<2>();
    test_all<3>();
    test_inside_out();
  });
}
