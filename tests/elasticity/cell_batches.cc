// K u cell by cell in batches is K u by the cells' matrices, for all shapes,
// elements and materials, and so are the parts of K that are asked for.

#include <setsudan/elasticity/elastic_model.h>

#include <cmath>

#include "../test_setup.h"
#include "small_model.h"

using namespace Setsudan;
using namespace dealii;

template <int dim>
LA::Vector
random_displacement(const Discretization<dim> &discretization)
{
  // The same on any number of processes.
  return nodal_values(discretization, [](const Point<dim> &p) {
    Tensor<1, dim> u;
    for (unsigned int c = 0; c < dim; ++c)
      u[c] = std::sin(37 * p[0] + 53 * p[1] + 19 * p[dim - 1] + 5 * c);
    return u;
  });
}


template <int dim>
void
test_product(const std::string &name,
             const CoarseMesh<dim> *mesh,
             Assignments assignments)
{
  const std::string n = dim == 2 ? "3,5" : "3,5,2";
  assignments.push_back("Body/Elements=" + n);
  SmallModel<dim> small(assignments, mesh);
  auto &model          = small.model;
  const LA::Vector u   = random_displacement(model.discretization);
  LA::Vector forces    = internal_forces(model, u);
  const LA::Vector old = internal_forces(
    model.discretization, model.stiffness, model.discretization.with_ghosts(u));
  forces -= old;
  std::cout << dim << "D, " << name << std::endl;
  check_below("  difference", forces.linfty_norm() / old.linfty_norm(), 1e-14);
}


template <int dim>
void
test_products()
{
  const CoarseMesh<dim> box =
    SmallBody<dim>({dim == 2 ? "Body/Elements=3,5" : "Body/Elements=3,5,2"})
      .body.mesh;
  const auto uneven = distorted(box), bent = curved(distorted(box));
  test_product<dim>("box", nullptr, {});
  test_product("distorted", &uneven, {});
  test_product("curved", &bent, {});
  for (const std::string formulation : {"displacement", "mixed"})
    {
      const Assignments nearly{"Material/Poisson's ratio=0.4999",
                               "Material/Formulation=" + formulation};
      test_product<dim>("nu = 0.4999, box, " + formulation, nullptr, nearly);
      test_product("nu = 0.4999, curved, " + formulation, &bent, nearly);
    }
  test_product("quadratic", &uneven, {"Body/Element type=quadratic"});
}


int
main(int argc, char **argv)
{
  return run_test(argc, argv, [] {
    test_products<2>();
    test_products<3>();
  });
}
