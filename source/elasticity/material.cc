#include <setsudan/elasticity/material.h>

namespace Setsudan
{
using namespace dealii;

void
MaterialParameters::declare(ParameterHandler &handler)
{
  Setsudan::declare(handler,
                    "Material",
                    "Young's modulus",
                    "5.0",
                    Patterns::Double(),
                    "E, greater than 0 [force/area].");
  Setsudan::declare(handler,
                    "Material",
                    "Poisson's ratio",
                    "0.2",
                    Patterns::Double(),
                    "Between -1 and 1/2, both excluded [-].");
  Setsudan::declare(handler,
                    "Material",
                    "Shear limit",
                    "1.0",
                    Patterns::Double(),
                    "The shear stress at which a blade of sharpness 0 divides "
                    "the body, greater than 0 [force/area].");
  Setsudan::declare(handler,
                    "Material",
                    "Linear range",
                    "0.5",
                    Patterns::Double(),
                    "Largest principal strain, in magnitude, up to which the "
                    "linear theory is trusted; beyond it the program warns. "
                    "Greater than 0 [-].");
}



MaterialParameters::MaterialParameters(const Parameters &parameters)
  : youngs_modulus(parameters.number("Material", "Young's modulus"))
  , poissons_ratio(parameters.number("Material", "Poisson's ratio"))
  , shear_limit(parameters.number("Material", "Shear limit"))
  , linear_range(parameters.number("Material", "Linear range"))
{
  parameters.require(youngs_modulus > 0,
                     "Material",
                     "Young's modulus",
                     "a number greater than 0");
  parameters.require(poissons_ratio > -1 && poissons_ratio < 0.5,
                     "Material",
                     "Poisson's ratio",
                     "a number greater than -1 and less than 0.5");
  parameters.require(
    shear_limit > 0, "Material", "Shear limit", "a number greater than 0");
  parameters.require(
    linear_range > 0, "Material", "Linear range", "a number greater than 0");
}



Hooke::Hooke(const double youngs_modulus, const double poissons_ratio)
  : lambda(youngs_modulus * poissons_ratio /
           ((1 + poissons_ratio) * (1 - 2 * poissons_ratio)))
  , mu(youngs_modulus / (2 * (1 + poissons_ratio)))
{
}



template <int dim>
SymmetricTensor<2, 3>
Hooke::stress(const SymmetricTensor<2, dim> &strain) const
{
  SymmetricTensor<2, 3> stress;
  for (unsigned int i = 0; i < dim; ++i)
    for (unsigned int j = i; j < dim; ++j)
      stress[i][j] = 2 * mu * strain[i][j];
  for (unsigned int i = 0; i < 3; ++i)
    stress[i][i] += lambda * trace(strain);
  return stress;
}



double
maximum_shear(const SymmetricTensor<2, 3> &stress)
{
  // The closed form of eigenvalues() loses half of the digits where two of them
  // are equal, as in any uniaxial stress.
  const auto principal =
    eigenvectors(stress, SymmetricTensorEigenvectorMethod::jacobi);
  return (principal[0].first - principal[2].first) / 2;
}



template SymmetricTensor<2, 3>
Hooke::stress(const SymmetricTensor<2, 2> &) const;
template SymmetricTensor<2, 3>
Hooke::stress(const SymmetricTensor<2, 3> &) const;
} // namespace Setsudan
