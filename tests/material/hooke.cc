// SPDX-License-Identifier: LGPL-2.1-or-later
// Hooke's law against the closed forms of simple states, and the maximum shear.

#include <setsudan/material/material.h>

#include <deal.II/base/symmetric_tensor.h>

#include <algorithm>
#include <cmath>

#include "../test_setup.h"

using namespace Setsudan;
using namespace dealii;
using Tensor3 = SymmetricTensor<2, 3>;

Tensor3
tensor(const double xx,
       const double yy,
       const double zz,
       const double xy = 0,
       const double yz = 0,
       const double zx = 0)
{
  Tensor3 t;
  t[0][0] = xx, t[1][1] = yy, t[2][2] = zz;
  t[0][1] = xy, t[1][2] = yz, t[2][0] = zx;
  return t;
}


void
test_simple_states(const double E, const double nu)
{
  std::cout << "E = " << E << ", nu = " << nu << std::endl;
  const Hooke hooke(E, nu);
  const double s = 0.7, G = E / (2 * (1 + nu)), K = E / (3 * (1 - 2 * nu));

  const Tensor3 pulled = hooke.stress(tensor(s / E, -nu * s / E, -nu * s / E));
  check_below("pulled", (pulled - tensor(s, 0, 0)).norm(), 1e-13);
  check_below(
    "its maximum shear", std::abs(maximum_shear(pulled) - s / 2), 1e-13);

  const Tensor3 sheared = hooke.stress(tensor(0, 0, 0, 0, s / (2 * G), 0));
  check_below("sheared", (sheared - tensor(0, 0, 0, 0, s, 0)).norm(), 1e-13);
  check_below("its maximum shear", std::abs(maximum_shear(sheared) - s), 1e-13);

  const double e        = s / (3 * K);
  const Tensor3 pressed = hooke.stress(tensor(-e, -e, -e));
  check_below("pressed", (pressed + tensor(s, s, s)).norm(), 1e-13);
  check_below("its maximum shear", maximum_shear(pressed), 1e-13);
}


/** Equation (11) of Kakefuda et al. (1996) without its typing errors: the
 * matrix of an isotropic body, for engineering shear strains. */
void
test_matrix(const double E, const double nu)
{
  const double factor = E * (1 - nu) / ((1 + nu) * (1 - 2 * nu));
  const double a = nu / (1 - nu), b = (1 - 2 * nu) / (2 * (1 - nu));
  const double x = 0.3, y = -0.2, z = 0.5, xy = 0.4, yz = -0.1, zx = 0.6;
  const Tensor3 expected = factor * tensor(x + a * (y + z),
                                           y + a * (z + x),
                                           z + a * (x + y),
                                           b * xy,
                                           b * yz,
                                           b * zx);
  const Tensor3 stress =
    Hooke(E, nu).stress(tensor(x, y, z, xy / 2, yz / 2, zx / 2));
  check_below("equation 11", (stress - expected).norm() / factor, 1e-14);
}


/** Plane strain is the strain in space without components across the plane;
 * the stress across is nu (sxx + syy) and takes part in the maximum shear. */
void
test_plane_strain(const double E, const double nu)
{
  const Hooke hooke(E, nu);
  SymmetricTensor<2, 2> strain;
  strain[0][0] = 0.3, strain[1][1] = -0.1, strain[0][1] = 0.25;
  const Tensor3 stress = hooke.stress(strain);
  check_below("plane strain",
              (stress - hooke.stress(tensor(0.3, -0.1, 0, 0.25))).norm() / E,
              1e-14);
  check_below("stress across the plane",
              std::abs(stress[2][2] - nu * (stress[0][0] + stress[1][1])) / E,
              1e-14);

  // Stretched alike in both directions, it is sheared across the plane only.
  strain       = 0;
  strain[0][0] = strain[1][1] = 0.1;
  check_below(
    "shear across the plane",
    std::abs(maximum_shear(hooke.stress(strain)) - E / (2 * (1 + nu)) * 0.1) /
      E,
    1e-14);
}


void
test_maximum_shear()
{
  std::cout << "maximum shear of principal stresses 1, 5, -2: "
            << maximum_shear(tensor(1, 5, -2)) << std::endl;
  std::cout << "of sxx = 3, syy = -1, sxy = 1.5: "
            << maximum_shear(tensor(3, -1, 0, 1.5)) << std::endl;
  std::cout << "of no stress: " << maximum_shear(Tensor3()) << std::endl;
}


/** A rod pulled along an axis that is none of the coordinates': two of its
 * principal stresses are equal. */
void
test_oblique_pull()
{
  double error = 0;
  for (double angle = 0.1; angle < 1.5; angle += 0.1)
    {
      Tensor<1, 3> axis;
      axis[0]              = std::cos(angle) * std::cos(2 * angle);
      axis[1]              = std::sin(angle) * std::cos(2 * angle);
      axis[2]              = std::sin(2 * angle);
      const Tensor3 stress = symmetrize(outer_product(axis, axis));
      error = std::max(error, std::abs(maximum_shear(stress) - 0.5));
    }
  check_below("maximum shear of an oblique pull", error, 1e-12);
}


int
main(int argc, char **argv)
{
  return run_test(argc, argv, [] {
    for (const double nu : {0.2, 0., -0.5, 0.49})
      {
        test_simple_states(5., nu);
        test_matrix(5., nu);
        test_plane_strain(5., nu);
      }
    test_maximum_shear();
    test_oblique_pull();
  });
}
