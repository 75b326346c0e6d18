// SPDX-License-Identifier: LGPL-2.1-or-later
// The stiffness matrix of an element: symmetric, without resistance to rigid
// motions and to nothing else, the right energy; and integrated once for all
// elements of a box that are of one material.

#include <setsudan/mechanics/stiffness.h>

#include <deal.II/lac/lapack_full_matrix.h>
#include <deal.II/lac/vector.h>

#include <cmath>

#include "../parameters/check.h"
#include "../test_setup.h"
#include "small_model.h"

using namespace Setsudan;
using namespace dealii;

template <int dim>
CoarseMesh<dim>
box(const std::string &n_elements)
{
  return SmallBody<dim>({"Body/Elements=" + n_elements}).body.mesh;
}


template <int dim>
void
test_matrix(const std::string &name,
            const CoarseMesh<dim> &mesh,
            const double nu)
{
  const Discretization<dim> discretization(mesh, {}, MPI_COMM_WORLD);
  const auto material = material_of(mesh, 5., nu);
  ElementStiffness<dim> stiffness(discretization, material);
  const auto cell = discretization.dof_handler.begin_active();
  const FullMatrix<double> matrix(stiffness(cell));
  const unsigned int n = matrix.m();

  double asymmetry = 0;
  for (unsigned int i = 0; i < n; ++i)
    for (unsigned int j = 0; j < i; ++j)
      asymmetry = std::max(asymmetry, std::abs(matrix(i, j) - matrix(j, i)));
  LAPACKFullMatrix<double> lapack(n);
  lapack = matrix;
  FullMatrix<double> vectors;
  Vector<double> eigenvalues;
  // All are found if none is negative.
  const double bound = matrix.frobenius_norm();
  lapack.compute_eigenvalues_symmetric(
    -1e-12 * bound, 2 * bound, 1e-15 * bound, eigenvalues, vectors);
  unsigned int n_zero = 0;
  for (const double value : eigenvalues)
    n_zero += value < 1e-12 * bound;

  std::cout << dim << "D, " << name << ", nu = " << nu << ": " << n
            << " unknowns, " << eigenvalues.size()
            << " eigenvalues not negative, " << n_zero << " zero" << std::endl;
  check_below("asymmetry", asymmetry, 0.);
}


/** The number of eigenvalues of a whole body's stiffness that are zero. */
unsigned int
n_zero_eigenvalues(const FullMatrix<double> &matrix)
{
  LAPACKFullMatrix<double> lapack(matrix.m());
  lapack = matrix;
  FullMatrix<double> vectors;
  Vector<double> eigenvalues;
  const double bound = matrix.frobenius_norm();
  lapack.compute_eigenvalues_symmetric(
    -bound, 2 * bound, 1e-15 * bound, eigenvalues, vectors);
  return std::count_if(
    eigenvalues.begin(), eigenvalues.end(), [&](const double value) {
      return std::abs(value) < 1e-12 * bound;
    });
}


/** A free body of few elements, such as a cut leaves, has its rigid motions
 * and no other motion for nothing. */
template <int dim>
void
test_free_piece(const std::string &n_elements, const std::string &formulation)
{
  const SmallModel<dim> small({"Body/Elements=" + n_elements,
                               "Material/Poisson's ratio=0.4999",
                               "Material/Formulation=" + formulation});
  const auto &discretization = small.model.discretization;
  ElementStiffness<dim> stiffness(discretization, small.material);
  FullMatrix<double> matrix(discretization.dof_handler.n_dofs());
  std::vector<types::global_dof_index> indices(
    discretization.fe.n_dofs_per_cell());
  for (const auto &cell : discretization.dof_handler.active_cell_iterators())
    {
      cell->get_dof_indices(indices);
      for (unsigned int i = 0; i < indices.size(); ++i)
        for (unsigned int j = 0; j < indices.size(); ++j)
          matrix(indices[i], indices[j]) += stiffness(cell)(i, j);
    }
  std::cout << "free piece of " << n_elements << " elements, " << formulation
            << ": " << n_zero_eigenvalues(matrix) << " zero eigenvalues"
            << std::endl;
}


/** In a uniform strain the nodes' work is twice the strain energy. */
template <int dim>
void
test_energy(const CoarseMesh<dim> &mesh, const Refinement &refinement)
{
  const Discretization<dim> discretization(mesh, refinement, MPI_COMM_WORLD);
  const auto material = material_of(mesh, 5., 0.3);
  const Hooke &hooke  = material.of_element(0).at_rest;
  ElementStiffness<dim> stiffness(discretization, material);

  Tensor<2, dim> gradient;
  for (unsigned int a = 0; a < dim; ++a)
    for (unsigned int b = 0; b < dim; ++b)
      gradient[a][b] = 0.1 * (a + 1) - 0.03 * b * b;
  const auto u = nodal_values(
    discretization, [&](const Point<dim> &p) { return gradient * p; });
  const LA::Vector forces =
    internal_forces(discretization, stiffness, discretization.with_ghosts(u));

  const SymmetricTensor<2, dim> strain = symmetrize(gradient);
  const auto stress                    = hooke.stress(strain);
  double density = 0, volume = 0;
  for (unsigned int a = 0; a < dim; ++a)
    for (unsigned int b = 0; b < dim; ++b)
      density += strain[a][b] * stress[a][b];
  for (unsigned int cell = 0; cell < mesh.cells.size(); ++cell)
    volume += volume_of_element(mesh.node_positions(cell));
  check_below("energy of a uniform strain, relative error",
              std::abs(u * forces / (volume * density) - 1),
              1e-12);
}


/** How often matrices are integrated while all cells are asked for, twice. */
template <int dim>
unsigned int
n_integrations(const CoarseMesh<dim> &mesh)
{
  const Discretization<dim> discretization(mesh, {}, MPI_COMM_WORLD);
  const auto material = material_of(mesh, 5., 0.2);
  ElementStiffness<dim> stiffness(discretization, material);
  for (unsigned int repeat = 0; repeat < 2; ++repeat)
    for (const auto &cell : discretization.dof_handler.active_cell_iterators())
      stiffness(cell);
  return stiffness.n_integrations();
}


void
test_integrations()
{
  check("one integration in 2D", n_integrations(box<2>("13, 7")) == 1);
  check("one integration in 3D", n_integrations(box<3>("13, 7, 3")) == 1);
  check("one integration for thin elements",
        n_integrations(box<3>("1, 300, 1")) == 1);
  check("elements that differ are not mistaken for each other",
        n_integrations(distorted(box<3>("3, 1, 1"))) >= 3);
  check("nor those that differ in a middle node",
        n_integrations(curved(box<3>("3, 1, 1"))) >= 3);
}


/** Of two materials, side by side: each cell has the matrix of its own, and one
 * is integrated for each change from one to the other. */
template <int dim>
void
test_materials()
{
  Body<dim> body;
  body.mesh = box<dim>(dim == 3 ? "6, 1, 1" : "6, 1");
  body.groups.push_back({"soft", 1, dim, {2, 3, 5}, {}});
  const MaterialParameters<dim> materials(
    parameters_of({"Material/Young's modulus=5; soft : 0.5"},
                  MaterialParameters<dim>::declare),
    body);
  const Discretization<dim> discretization(body.mesh, {}, MPI_COMM_WORLD);
  ElementStiffness<dim> stiffness(discretization, materials);
  std::vector<double> norms(6);
  for (const auto &cell : discretization.dof_handler.active_cell_iterators())
    norms[discretization.element(cell)] = stiffness(cell).frobenius_norm();
  std::cout << dim << "D, two materials:";
  for (const double norm : norms)
    std::cout << " " << norm / norms[0];
  std::cout << ", " << stiffness.n_integrations() << " integrations"
            << std::endl;
}


int
main(int argc, char **argv)
{
  return run_test(argc, argv, [] {
    for (const double nu : {0.2, 0., -0.9, 0.4999})
      {
        test_matrix("square", box<2>("1, 1"), nu);
        test_matrix("distorted", distorted(box<2>("1, 1")), nu);
        test_matrix("cube", box<3>("1, 1, 1"), nu);
        test_matrix("distorted", distorted(box<3>("1, 1, 1")), nu);
      }
    test_matrix("curved", curved(box<2>("1, 1")), 0.2);
    test_matrix("curved", curved(box<3>("1, 1, 1")), 0.2);
    const Refinement everywhere{1, {}};
    const auto plane = box<2>("3, 2");
    const auto space = box<3>("2, 3, 2");
    test_energy(distorted(plane), {});
    test_energy(distorted(space), {});
    test_energy(distorted(plane), everywhere);
    test_energy(curved(plane), {});
    test_energy(curved(plane), everywhere);
    test_energy(curved(space), {});
    for (const char *formulation : {"displacement", "mixed"})
      {
        test_free_piece<2>("1, 1", formulation);
        test_free_piece<2>("2, 1", formulation);
        test_free_piece<3>("1, 1, 1", formulation);
        test_free_piece<3>("2, 1, 1", formulation);
        test_free_piece<3>("1, 1, 2", formulation);
      }
    test_integrations();
    test_materials<2>();
    test_materials<3>();
  });
}
