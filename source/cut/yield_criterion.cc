#include <deal.II/base/mpi.h>

#include <setsudan/cut/yield_criterion.h>
#include <setsudan/elasticity/strain_recovery.h>

#include <boost/math/tools/toms748_solve.hpp>

#include <algorithm>
#include <set>

namespace Setsudan
{
using namespace dealii;

void
YieldParameters::declare(ParameterHandler &handler)
{
  Setsudan::declare(handler,
                    "Yield",
                    "Criterion",
                    "maximum shear",
                    Patterns::Selection("maximum shear"),
                    "The stress that must exceed the required one: the maximum "
                    "shear (Tresca), the largest over the elements that meet "
                    "at the front's nodes. It grows as elements shrink, "
                    "because the stress under a blade is singular.");
  Setsudan::declare(handler,
                    "Yield",
                    "Check",
                    "every row",
                    Patterns::Selection("once|every row"),
                    "once: the first row's yield opens the cut, which then "
                    "runs through (as in the paper); every row: each row must "
                    "yield.");
}



YieldParameters::YieldParameters(const Parameters &parameters)
  : check(parameters.text("Yield", "Check") == "once" ? Check::once
                                                      : Check::every_row)
{
}



template <int dim>
FrontStresses
front_stresses(const ElasticModel<dim> &model,
               const Seam<dim> &seam,
               const Row &row,
               const LA::Vector &displacement)
{
  std::set<types::global_dof_index> front;
  for (const unsigned int pair : row.front)
    front.insert({seam.pairs()[pair].minus[0], seam.pairs()[pair].plus[0]});

  const auto &discretization = model.discretization;
  StrainRecovery<dim> recovery(discretization, node_points<dim>());
  FrontStresses stresses;
  for (const auto &cell : discretization.dof_handler.active_cell_iterators())
    if (cell->is_locally_owned())
      {
        bool evaluated   = false;
        const auto nodes = discretization.node_indices(cell);
        for (unsigned int node = 0; node < nodes.size(); ++node)
          if (front.count(nodes[node][0]) > 0)
            {
              if (!evaluated)
                recovery.reinit(cell, displacement);
              evaluated = true;
              stresses.push_back(model.material.stress(recovery.strain(node)));
            }
      }
  return stresses;
}



double
cutting_stress(const FrontStresses &stresses, const MPI_Comm communicator)
{
  double largest = 0;
  for (const auto &stress : stresses)
    largest = std::max(largest, maximum_shear(stress));
  return Utilities::MPI::max(largest, communicator);
}



double
required_stress(const double shear_limit, const double sharpness)
{
  return shear_limit * (1 - sharpness);
}



bool
yields(const double cutting_stress, const double required_stress)
{
  return cutting_stress > required_stress || required_stress == 0;
}



YieldLoad
find_yield_load(const FrontStresses &base,
                const FrontStresses &per_load,
                const double required,
                const double max_load_factor,
                const MPI_Comm communicator)
{
  const auto stress_at = [&](const double factor) {
    FrontStresses stresses = base;
    for (unsigned int i = 0; i < stresses.size(); ++i)
      stresses[i] += factor * per_load[i];
    return cutting_stress(stresses, communicator);
  };
  const double at_rest = stress_at(0);
  if (yields(at_rest, required))
    return {0, at_rest, true};
  const double at_most = stress_at(max_load_factor);
  if (!yields(at_most, required))
    return {max_load_factor, at_most, false};

  boost::uintmax_t max_iterations = 200;
  const auto bracket              = boost::math::tools::toms748_solve(
    [&](const double factor) { return stress_at(factor) - required; },
    0.,
    max_load_factor,
    at_rest - required,
    at_most - required,
    boost::math::tools::eps_tolerance<double>(52),
    max_iterations);
  return {bracket.second, stress_at(bracket.second), true};
}



template FrontStresses
front_stresses(const ElasticModel<2> &,
               const Seam<2> &,
               const Row &,
               const LA::Vector &);
template FrontStresses
front_stresses(const ElasticModel<3> &,
               const Seam<3> &,
               const Row &,
               const LA::Vector &);
} // namespace Setsudan
