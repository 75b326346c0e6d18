// The load factor at which a row yields, against closed forms.

#include <setsudan/cut/yield_criterion.h>

#include "../test_setup.h"

using namespace Setsudan;

dealii::SymmetricTensor<2, 3>
shear(const double tau)
{
  dealii::SymmetricTensor<2, 3> stress;
  stress[0][1] = tau;
  return stress;
}

void
check(const std::string &name,
      const FrontStresses &base,
      const FrontStresses &per_load,
      const double required,
      const double max_factor,
      const double expected)
{
  const auto load =
    find_yield_load(base, per_load, required, max_factor, MPI_COMM_WORLD);
  check_below(
    name, std::abs(load.load_factor - expected), 1e-12 * (1 + expected));
  std::cout << "  " << (load.yields ? "yields" : "does not yield") << " at "
            << load.cutting_stress << std::endl;
}

int
main(int argc, char **argv)
{
  return run_test(argc, argv, [] {
    check("proportional", {shear(0)}, {shear(0.25)}, 0.5, 10, 2);
    check(
      "beyond the largest factor", {shear(0)}, {shear(0.25)}, 0.5, 1.9, 1.9);
    check("stressed before", {shear(0.3)}, {shear(0.1)}, 0.5, 10, 2);
    // The load first relieves the stress, and then turns it round.
    check("relieved first", {shear(-0.3)}, {shear(0.1)}, 0.5, 10, 8);
    check("yields at rest", {shear(0.6)}, {shear(0.1)}, 0.5, 10, 0);
    check("nothing is required", {shear(0)}, {shear(0.1)}, 0, 10, 0);
    // Of two elements the one that overtakes the other decides.
    check("two elements",
          {shear(0.2), shear(0)},
          {shear(0.1), shear(0.3)},
          1.2,
          10,
          4);
    std::cout << "yields() below, at, above: " << yields(0.4, 0.5)
              << yields(0.5, 0.5) << yields(0.6, 0.5) << ", without need "
              << yields(0, 0) << std::endl;
    std::cout << "required: " << required_stress(2, 0.25) << std::endl;
  });
}
