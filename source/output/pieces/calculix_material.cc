// SPDX-License-Identifier: LGPL-2.1-or-later
#include <setsudan/material/decoupled_law.h>
#include <setsudan/material/orthotropic_elasticity.h>
#include <setsudan/output/pieces/calculix_material.h>

#include <iomanip>
#include <sstream>
#include <vector>

namespace Setsudan
{
namespace
{
// CalculiX reads at most 20 characters of a number, and 8 of them on a line.
constexpr int n_constant_digits       = 12;
constexpr unsigned int n_line_numbers = 8;
// Of Ogden's law.
constexpr unsigned int most_terms = 4;

std::string
card(const std::string &keyword, const std::vector<double> &values)
{
  std::ostringstream text;
  text << std::scientific << std::setprecision(n_constant_digits) << keyword
       << '\n';
  for (unsigned int i = 0; i < values.size(); ++i)
    text << values[i]
         << (i + 1 == values.size() || (i + 1) % n_line_numbers == 0 ? "\n"
                                                                     : ", ");
  return text.str();
}

/** D of CalculiX's energy of volume (J - 1)^2 / D. */
double
compressibility(const DecoupledLaw &law)
{
  return 2 / law.volumetric.modulus;
}

std::string
mooney_rivlin(const MooneyRivlin &law)
{
  return law.c01 == 0
           ? card("*HYPERELASTIC, NEO HOOKE", {law.c10, compressibility(law)})
           : card("*HYPERELASTIC, MOONEY-RIVLIN",
                  {law.c10, law.c01, compressibility(law)});
}

std::string
ogden(const Ogden &law)
{
  std::vector<double> values;
  // CalculiX's moduli are of 2 mu_i / alpha_i^2 (a^alpha_i + ...).
  for (const auto &[modulus, exponent] : law.terms)
    {
      values.push_back(modulus * exponent / 2);
      values.push_back(exponent);
    }
  // It takes values of its own for those that are zero: let the higher powers
  // of the energy of volume vanish.
  constexpr double without_energy = 1e20;
  values.push_back(compressibility(law));
  for (unsigned int i = 1; i < law.terms.size(); ++i)
    values.push_back(without_energy * compressibility(law));
  return card("*HYPERELASTIC, OGDEN, N=" + std::to_string(law.terms.size()),
              values);
}
/** nu13 follows from nu31. */
std::string
engineering_constants(const OrthotropicConstants &constants)
{
  const auto &[E, nu, G, axes] = constants;
  return card(
    "*ELASTIC, TYPE=ENGINEERING CONSTANTS",
    {E[0], E[1], E[2], nu[0], nu[2] * E[0] / E[2], nu[1], G[0], G[2], G[1]});
}

const OrthotropicElasticity *
orthotropic(const Material &material)
{
  return dynamic_cast<const OrthotropicElasticity *>(material.law.get());
}
} // namespace


std::optional<std::string>
calculix_orientation(const Material &material)
{
  const auto *const law = orthotropic(material);
  if (law == nullptr)
    return {};
  std::ostringstream text;
  text << std::scientific << std::setprecision(n_constant_digits);
  for (const unsigned int axis : {0, 1})
    for (unsigned int d = 0; d < 3; ++d)
      text << (axis + d == 0 ? "" : ", ") << law->constants.axes[axis][d];
  return text.str() + "\n";
}



std::optional<std::string>
calculix_material(const Material &material)
{
  const auto *const finite = material.law->hyperelastic();
  if (const auto *const law = orthotropic(material))
    return engineering_constants(law->constants);
  if (finite == nullptr)
    return card("*ELASTIC",
                {material.at_rest.youngs_modulus(),
                 material.at_rest.lambda /
                   (2 * (material.at_rest.lambda + material.at_rest.mu))});
  const auto *const law = finite->decoupled();
  if (law == nullptr ||
      law->volumetric.form != VolumetricEnergy::Form::quadratic)
    return {};
  if (const auto *const of_invariants = dynamic_cast<const MooneyRivlin *>(law))
    return mooney_rivlin(*of_invariants);
  if (const auto *const of_stretches = dynamic_cast<const Ogden *>(law);
      of_stretches != nullptr && of_stretches->terms.size() <= most_terms)
    return ogden(*of_stretches);
  return {};
}
} // namespace Setsudan
