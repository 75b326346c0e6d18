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
              const auto &material =
                model.materials.of_element(discretization.element(cell));
              stresses.push_back({material.hooke.stress(recovery.strain(node)),
                                  material.shear_limit});
            }
      }
  return stresses;
}



bool
CuttingStress::yields() const
{
  return reached > required || required == 0;
}



CuttingStress
cutting_stress(const FrontStresses &stresses,
               const double sharpness,
               const MPI_Comm communicator)
{
  double largest = 0;
  CuttingStress decisive;
  for (const auto &[stress, shear_limit] : stresses)
    {
      const double shear    = maximum_shear(stress);
      const double required = required_stress(shear_limit, sharpness);
      const double ratio    = shear / shear_limit;
      if (ratio > largest || (ratio == largest && shear >= decisive.reached))
        {
          largest  = ratio;
          decisive = {shear, required};
        }
    }
  // Of the processes with the largest ratio: they have the same material, or
  // it does not matter which.
  const double of_all = Utilities::MPI::max(largest, communicator);
  if (stresses.empty() || largest < of_all)
    decisive = {0, 0};
  return {Utilities::MPI::max(decisive.reached, communicator),
          Utilities::MPI::max(decisive.required, communicator)};
}



double
required_stress(const double shear_limit, const double sharpness)
{
  return shear_limit * (1 - sharpness);
}



YieldLoad
find_yield_load(const FrontStresses &base,
                const FrontStresses &per_load,
                const double sharpness,
                const double max_load_factor,
                const MPI_Comm communicator)
{
  const auto stress_at = [&](const double factor) {
    FrontStresses stresses = base;
    for (unsigned int i = 0; i < stresses.size(); ++i)
      stresses[i].stress += factor * per_load[i].stress;
    return cutting_stress(stresses, sharpness, communicator);
  };
  // Above 0 where the row yields.
  const auto excess = [](const CuttingStress &stress) {
    return stress.reached / stress.required - 1;
  };
  const CuttingStress at_rest = stress_at(0);
  if (at_rest.yields())
    return {0, at_rest, true};
  const CuttingStress at_most = stress_at(max_load_factor);
  if (!at_most.yields())
    return {max_load_factor, at_most, false};

  boost::uintmax_t max_iterations = 200;
  const auto bracket              = boost::math::tools::toms748_solve(
    [&](const double factor) { return excess(stress_at(factor)); },
    0.,
    max_load_factor,
    excess(at_rest),
    excess(at_most),
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
