// SPDX-License-Identifier: LGPL-2.1-or-later
// A displacement that is chosen, u = grad(phi) + c |x|^2 / 2 with a harmonic
// phi, and the constant body force that holds it: the errors of displacement
// and stress in the L2 norm, while a body of distorted or curved elements is
// refined. Quadratic elements promise the orders 3 and 2.

#include "../mechanics/exact_problem.h"
#include "../mechanics/small_model.h"
#include "../test_setup.h"

using namespace Setsudan;
using namespace dealii;

const double E = 5, nu = 0.3;

template <int dim>
Tensor<1, dim>
quadratic_part()
{
  Tensor<1, dim> c;
  for (unsigned int d = 0; d < dim; ++d)
    c[d] = 0.3 + 0.4 * d;
  return c;
}


/** phi = exp(k x) cos(y) (cos(z)), with k = sqrt(dim - 1). */
template <int dim>
ExactField<dim>
chosen_field()
{
  const double k = std::sqrt(dim - 1.);
  // phi and the factors that a derivative multiplies it with.
  const auto factors = [k](const Point<dim> &p) {
    std::pair<double, Tensor<1, dim>> result{std::exp(k * p[0]), {}};
    result.second[0] = k;
    for (unsigned int d = 1; d < dim; ++d)
      {
        result.first *= std::cos(p[d]);
        result.second[d] = -std::tan(p[d]);
      }
    return result;
  };
  const auto value = [factors](const Point<dim> &p) {
    const auto [phi, factor] = factors(p);
    return phi * factor + p.square() / 2 * quadratic_part<dim>();
  };
  const auto gradient = [factors, k](const Point<dim> &p) {
    const auto [phi, factor]  = factors(p);
    Tensor<2, dim> derivative = phi * outer_product(factor, factor);
    for (unsigned int d = 1; d < dim; ++d)
      derivative[d][d] = -phi;
    return derivative + outer_product(quadratic_part<dim>(), Tensor<1, dim>(p));
  };
  return {value, gradient};
}


/** - div(stress) of the field. */
template <int dim>
std::string
body_force()
{
  const double lambda = E * nu / (1 + nu) / (1 - 2 * nu);
  const double mu     = E / 2 / (1 + nu);
  std::string force;
  for (unsigned int d = 0; d < dim; ++d)
    force += (d > 0 ? ", " : "") +
             short_text(-((dim + 1) * mu + lambda) * quadratic_part<dim>()[d]);
  return force;
}


template <int dim>
RelativeErrors
errors(const Body<dim> &body, const unsigned int n_refinements)
{
  Refinement refinement;
  refinement.global_levels = n_refinements;
  ExactProblem<dim> problem(body,
                            {"Material/Young's modulus=" + short_text(E),
                             "Material/Poisson's ratio=" + short_text(nu),
                             "Load/Body force=" + body_force<dim>()},
                            refinement);
  // All nodes of the surface have the exact displacement.
  const auto &discretization = problem.model.discretization;
  std::vector<Point<dim>> held;
  for (const auto &cell : discretization.dof_handler.active_cell_iterators())
    for (unsigned int face = 0; face < GeometryInfo<dim>::faces_per_cell;
         ++face)
      if (cell->face(face)->at_boundary())
        for (unsigned int node = 0; node < n_element_nodes<dim>; ++node)
          if (node_is_on_face<dim>(node, face))
            held.push_back(discretization.node_positions(cell)[node]);
  return problem.errors(chosen_field<dim>(), [&](const Point<dim> &p) {
    return std::any_of(held.begin(), held.end(), [&](const Point<dim> &q) {
      return p.distance(q) < 1e-12;
    });
  });
}


template <int dim>
void
print_orders(const std::string &name,
             const Body<dim> &body,
             const unsigned int n_refinements)
{
  RelativeErrors last = errors(body, 0);
  for (unsigned int level = 1; level <= n_refinements; ++level)
    {
      const RelativeErrors now = errors(body, level);
      std::cout << dim << "D " << name << ", refined " << level
                << ": displacement " << now.displacement << " order "
                << std::log2(last.displacement / now.displacement)
                << ", stress " << now.stress << " order "
                << std::log2(last.stress / now.stress) << std::endl;
      last = now;
    }
}


template <int dim>
void
test(const std::string &elements, const unsigned int n_refinements)
{
  SmallBody<dim> box({"Body/Size=" + std::string(dim == 2 ? "1, 1" : "1, 1, 1"),
                      "Body/Elements=" + elements});
  Body<dim> body = box.body;
  body.mesh      = distorted(body.mesh);
  print_orders("distorted", body, n_refinements);
  body.mesh = curved(body.mesh);
  print_orders("curved", body, n_refinements);
}


int
main(int argc, char **argv)
{
  return run_test(argc, argv, [] {
    std::cout << std::setprecision(4);
    test<2>("2, 2", 4);
    test<3>("1, 1, 1", 2);
  });
}
