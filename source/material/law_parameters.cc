// SPDX-License-Identifier: LGPL-2.1-or-later
#include <deal.II/base/utilities.h>

#include <setsudan/material/law_parameters.h>
#include <setsudan/material/small_strain_law.h>
#include <setsudan/parameters/lists.h>

namespace Setsudan
{
using namespace dealii;

std::string
LawParameters::names()
{
  return "auto|linear elastic|neo-Hooke|isochoric neo-Hooke|Mooney-Rivlin|"
         "Ogden";
}



void
LawParameters::declare(ParameterHandler &handler)
{
  Setsudan::declare(handler,
                    "Deformation",
                    "Strain",
                    "small",
                    Patterns::Selection("small|finite|auto"),
                    "small: the linear theory of small strains and rotations, "
                    "in which a whole cut takes one factorization; finite: "
                    "large displacements, rotations and strains by Newton's "
                    "method, with Material/Law; auto: small until a principal "
                    "strain exceeds Material/Linear range, which must be less "
                    "than 1 then; this state is solved again with finite "
                    "strain, and all behind it are.");
  Setsudan::declare(handler,
                    "Material",
                    "Law",
                    "auto",
                    Patterns::Anything(),
                    "The law for finite strain, or 'group : law', separated by "
                    "';': linear elastic (between Green's strain and the "
                    "second Piola-Kirchhoff stress, for large rotations), "
                    "neo-Hooke, isochoric neo-Hooke, Mooney-Rivlin or Ogden. "
                    "All have Young's modulus and Poisson's ratio at rest. "
                    "auto: isochoric neo-Hooke in the mixed formulation, "
                    "which needs an energy of the volume of its own, linear "
                    "elastic where Young's moduli are given, the law of small "
                    "strain for logarithmic strain where Yield stress or "
                    "Viscous is, and neo-Hooke elsewhere. Small strain always "
                    "takes Hooke's law.");
  Setsudan::declare(handler,
                    "Material",
                    "Volumetric energy",
                    "Ciarlet",
                    Patterns::Selection("Ciarlet|quadratic|logarithmic"),
                    "What a change of volume J stores in finite strain, over "
                    "its modulus, lambda in neo-Hooke and the bulk modulus in "
                    "the laws that follow it: (J^2 - 1 - 2 ln J) / 4, (J - "
                    "1)^2 / 2 or (ln J)^2 / 2.");
  Setsudan::declare(handler,
                    "Material",
                    "Mooney-Rivlin share",
                    "0.5",
                    Patterns::Double(),
                    "c01 / (c10 + c01) of Mooney-Rivlin, between 0, which is "
                    "isochoric neo-Hooke, and 1 [-].");
  Setsudan::declare(handler,
                    "Material",
                    "Ogden terms",
                    "",
                    Patterns::Anything(),
                    "'mu : alpha' of Ogden, separated by ';', as in '0.63 : "
                    "1.3; 0.0012 : 5; -0.01 : -2'. The moduli count in "
                    "relation to each other: they are scaled to Young's "
                    "modulus and Poisson's ratio.");
}



namespace
{
LawParameters::Strain
read_strain(const Parameters &parameters)
{
  using Strain           = LawParameters::Strain;
  const std::string name = parameters.text("Deformation", "Strain");
  return name == "small"    ? Strain::small
         : name == "finite" ? Strain::finite
                            : Strain::automatic;
}



Ogden::Terms
read_ogden_terms(const Parameters &parameters)
{
  Ogden::Terms terms;
  double sum = 0;
  for (const auto &item :
       split(parameters.text("Material", "Ogden terms"), ';'))
    {
      const auto both = split(item, ':');
      std::vector<double> modulus, exponent;
      parameters.require(both.size() == 2 && parse_numbers(both[0], modulus) &&
                           modulus.size() == 1 &&
                           parse_numbers(both[1], exponent) &&
                           exponent.size() == 1 && exponent[0] != 0,
                         "Material",
                         "Ogden terms",
                         "'modulus : exponent', separated by ';', with "
                         "exponents that are not 0");
      terms.emplace_back(modulus[0], exponent[0]);
      sum += modulus[0] * exponent[0];
    }
  parameters.require(terms.empty() || sum > 0,
                     "Material",
                     "Ogden terms",
                     "terms whose products of modulus and exponent have a "
                     "positive sum, since that is twice the shear modulus");
  return terms;
}
} // namespace


LawParameters::LawParameters(const Parameters &parameters)
  : strain(read_strain(parameters))
  , mooney_rivlin_share(parameters.number("Material", "Mooney-Rivlin share"))
  , ogden_terms(read_ogden_terms(parameters))
{
  using Form               = VolumetricEnergy::Form;
  const std::string energy = parameters.text("Material", "Volumetric energy");
  volumetric               = energy == "Ciarlet"     ? Form::ciarlet
                             : energy == "quadratic" ? Form::quadratic
                                                     : Form::logarithmic;
  parameters.require(mooney_rivlin_share >= 0 && mooney_rivlin_share <= 1,
                     "Material",
                     "Mooney-Rivlin share",
                     "a number from 0 to 1");
}



std::shared_ptr<const ConstitutiveLaw>
LawParameters::make(const std::string &name,
                    const Hooke &at_rest,
                    const bool is_mixed) const
{
  if (strain == Strain::small)
    return std::make_shared<const LinearElasticity>(at_rest);
  if (name == "isochoric neo-Hooke" || (name == "auto" && is_mixed))
    return std::make_shared<const MooneyRivlin>(at_rest, volumetric);
  if (name == "Mooney-Rivlin")
    return std::make_shared<const MooneyRivlin>(
      at_rest, volumetric, mooney_rivlin_share);
  if (name == "Ogden")
    return std::make_shared<const Ogden>(at_rest, volumetric, ogden_terms);
  if (is_mixed)
    return nullptr;
  if (name == "linear elastic")
    return std::make_shared<const StVenantKirchhoff>(at_rest);
  return std::make_shared<const NeoHooke>(at_rest, volumetric);
}
} // namespace Setsudan
