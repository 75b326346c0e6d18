// SPDX-License-Identifier: LGPL-2.1-or-later
// Laws for finite strain: stress and tangent are derivatives of the energy, at
// rest they are Hooke's law, and uniform states have their closed forms.

#include <setsudan/material/law_parameters.h>

#include <array>
#include <cmath>
#include <limits>
#include <memory>
#include <random>
#include <string>
#include <utility>
#include <vector>

#include "../test_setup.h"

using namespace Setsudan;
using namespace dealii;
using Form = VolumetricEnergy::Form;

using Law = std::shared_ptr<const HyperelasticLaw>;

/** Ogden's constants for rubber, which are scaled. */
const Ogden::Terms rubber{{0.63, 1.3}, {0.0012, 5.}, {-0.01, -2.}};

std::vector<std::pair<std::string, Law>>
all_laws(const Hooke &at_rest)
{
  std::vector<std::pair<std::string, Law>> laws{
    {"linear elastic", std::make_shared<StVenantKirchhoff>(at_rest)}};
  const std::vector<std::pair<std::string, Form>> forms{
    {"Ciarlet", Form::ciarlet},
    {"quadratic", Form::quadratic},
    {"logarithmic", Form::logarithmic}};
  for (const auto &[name, form] : forms)
    {
      laws.emplace_back("neo-Hooke, " + name,
                        std::make_shared<NeoHooke>(at_rest, form));
      laws.emplace_back("isochoric neo-Hooke, " + name,
                        std::make_shared<MooneyRivlin>(at_rest, form));
      laws.emplace_back("Mooney-Rivlin, " + name,
                        std::make_shared<MooneyRivlin>(at_rest, form, 0.3));
      laws.emplace_back("Ogden, " + name,
                        std::make_shared<Ogden>(at_rest, form, rubber));
    }
  return laws;
}



/** The largest differences of stress and tangent from central differences of
 * energy and stress, relative to the modulus. */
std::array<double, 2>
errors_of_derivatives(const HyperelasticLaw &law,
                      const Tensor<2, 3> &gradient,
                      const double modulus)
{
  constexpr double step = 1e-5;
  const auto response   = law.respond(gradient);
  std::array<double, 2> errors{};
  for (unsigned int i = 0; i < 3; ++i)
    for (unsigned int j = 0; j < 3; ++j)
      {
        Tensor<2, 3> change;
        change[i][j]      = step;
        const auto after  = law.respond(gradient + change);
        const auto before = law.respond(gradient - change);
        const double slope =
          (after.energy.potential - before.energy.potential) / (2 * step);
        errors[0] = std::max(errors[0],
                             std::abs(slope - response.stress[i][j]) / modulus);
        const Tensor<2, 3> of_stress =
          (after.stress - before.stress) / (2 * step);
        for (unsigned int k = 0; k < 3; ++k)
          for (unsigned int l = 0; l < 3; ++l)
            errors[1] = std::max(
              errors[1],
              std::abs(of_stress[k][l] - response.tangent[k][l][i][j]) /
                modulus);
      }
  return errors;
}



void
test_derivatives()
{
  const Hooke at_rest(2, 0.3);
  std::mt19937 random(5);
  std::uniform_real_distribution<double> number(-0.3, 0.3);
  std::vector<Tensor<2, 3>> gradients(2);
  // At rest, and where two stretches are the same, all directions are
  // principal ones.
  gradients[1][0][0] = 0.4;
  for (unsigned int n = 0; n < 4; ++n)
    {
      gradients.emplace_back();
      for (unsigned int i = 0; i < 3; ++i)
        for (unsigned int j = 0; j < 3; ++j)
          gradients.back()[i][j] = number(random);
    }
  for (const auto &[name, law] : all_laws(at_rest))
    {
      std::array<double, 2> worst{};
      for (const auto &gradient : gradients)
        {
          const auto errors = errors_of_derivatives(*law, gradient, 2);
          for (unsigned int i = 0; i < 2; ++i)
            worst[i] = std::max(worst[i], errors[i]);
        }
      check_below(name + ": stress", worst[0], 1e-8);
      check_below(name + ": tangent", worst[1], 1e-8);
    }
}



void
test_rest()
{
  const Hooke at_rest(2, 0.3);
  const auto one                    = unit_symmetric_tensor<3>();
  const SymmetricTensor<4, 3> hooke = at_rest.lambda * outer_product(one, one) +
                                      2 * at_rest.mu * identity_tensor<3>();
  double slope = 0, stress = 0, energy = 0, volume = 0;
  for (const auto &[name, law] : all_laws(at_rest))
    {
      const StrainEnergy at_one = law->at(one);
      slope  = std::max(slope, (at_one.tangent - hooke).norm());
      stress = std::max(stress, at_one.stress.norm());
      energy = std::max(energy, std::abs(at_one.value));
      if (law->decoupled() != nullptr)
        volume = std::max(
          volume,
          std::abs(trace(law->decoupled()->distortion(2 * one).stress)));
    }
  check_below("tangent at rest: Hooke's", slope, 1e-13);
  check_below("no stress at rest", stress, 1e-14);
  check_below("no energy at rest", energy, 1e-14);
  check_below(
    "no stress of distortion where only the volume changes", volume, 1e-14);
  Tensor<2, 3> inverted;
  inverted[0][0] = -1.5;
  std::cout
    << "energy of a body turned inside out: "
    << NeoHooke(at_rest, Form::ciarlet).respond(inverted).energy.potential
    << std::endl;
}



/** The lateral stretch at which a bar that is stretched has no lateral stress,
 * and its nominal stress. */
std::array<double, 2>
uniaxial(const HyperelasticLaw &law, const double stretch)
{
  const auto response = [&](const double lateral) {
    Tensor<2, 3> gradient;
    gradient[0][0] = stretch - 1;
    gradient[1][1] = gradient[2][2] = lateral - 1;
    return law.respond(gradient);
  };
  double lateral = 1;
  for (unsigned int i = 0; i < 50; ++i)
    {
      const auto now = response(lateral);
      lateral -=
        now.stress[1][1] / (now.tangent[1][1][1][1] + now.tangent[1][1][2][2]);
    }
  return {{lateral, response(lateral).stress[0][0]}};
}



/** Uniaxial stretch, E = 1, by an independent program. */
void
test_uniaxial()
{
  const Hooke soft(1, 0.3), stiff(1, 0.49);
  const std::vector<std::pair<Law, std::array<std::array<double, 3>, 4>>> known{
    {std::make_shared<NeoHooke>(soft, Form::ciarlet),
     {{{{0.5, 1.17834984, -0.87577566}},
       {{1.5, 0.87423283, 0.38095307}},
       {{2., 0.78426354, 0.65094821}},
       {{3., 0.66367227, 1.09737681}}}}},
    {std::make_shared<MooneyRivlin>(stiff, Form::ciarlet),
     {{{{0.5, 1.40588198, -1.16789249}},
       {{1.5, 0.82075247, 0.35021837}},
       {{2., 0.71512379, 0.57660229}},
       {{3., 0.59288489, 0.93374429}}}}},
    {std::make_shared<MooneyRivlin>(stiff, Form::ciarlet, 0.3),
     {{{{0.5, 1.40339780, -1.51212185}},
       {{1.5, 0.82033673, 0.31576575}},
       {{2., 0.71396386, 0.49196703}},
       {{3., 0.58998179, 0.75356541}}}}},
    {std::make_shared<Ogden>(stiff, Form::ciarlet, rubber),
     {{{{0.5, 1.40548389, -1.22317852}},
       {{1.5, 0.82034017, 0.31605026}},
       {{2., 0.71369775, 0.47260850}},
       {{3., 0.58880738, 0.68142838}}}}}};
  for (const auto &[law, rows] : known)
    {
      double error = 0;
      for (const auto &[stretch, lateral, stress] : rows)
        {
          const auto found = uniaxial(*law, stretch);
          error            = std::max(
            {error, std::abs(found[0] - lateral), std::abs(found[1] - stress)});
        }
      check_below("bar of " + law->name() + ", stretch 0.5 to 3", error, 1e-8);
    }
  // Ogden's law with one exponent of 2 is neo-Hookean.
  const Ogden single(stiff, Form::ciarlet, {{1., 2.}});
  const MooneyRivlin neo_hooke(stiff, Form::ciarlet);
  check_below("Ogden with alpha = 2 is neo-Hooke",
              std::abs(uniaxial(single, 2)[1] - uniaxial(neo_hooke, 2)[1]),
              1e-14);
}



/** Simple shear gamma = 1: s12 = mu gamma, s11 - s22 = mu gamma^2, and s22 -
 * s33 = -2 c01 gamma^2. */
void
test_shear()
{
  const Hooke at_rest(1, 0.49);
  const double mu    = at_rest.mu;
  const double share = 0.3;
  const std::vector<std::pair<Law, double>> laws{
    {std::make_shared<NeoHooke>(at_rest, Form::ciarlet), 0.},
    {std::make_shared<MooneyRivlin>(at_rest, Form::ciarlet), 0.},
    {std::make_shared<MooneyRivlin>(at_rest, Form::ciarlet, share),
     -share * mu}};
  double error = 0;
  for (const auto &[law, difference] : laws)
    {
      Tensor<2, 3> gradient;
      gradient[0][1] = 1;
      // J is 1.
      const Tensor<2, 3> stress =
        law->respond(gradient).stress *
        transpose(gradient + unit_symmetric_tensor<3>());
      error = std::max({error,
                        std::abs(stress[0][1] - mu),
                        std::abs(stress[0][0] - stress[1][1] - mu),
                        std::abs(stress[1][1] - stress[2][2] - difference)});
    }
  check_below("simple shear", error, 1e-14);
}



int
main(int argc, char **argv)
{
  return run_test(argc, argv, [] {
    test_derivatives();
    test_rest();
    test_uniaxial();
    test_shear();
  });
}
