// SPDX-License-Identifier: LGPL-2.1-or-later
#include <deal.II/physics/elasticity/standard_tensors.h>

#include <setsudan/material/viscoelasticity.h>

#include <algorithm>
#include <cmath>
#include <map>

namespace Setsudan
{
using namespace dealii;

namespace
{
/** A strain and a change of volume, as they are kept. */
struct Strain
{
  SymmetricTensor<2, 3> tensor;
  double dilatation = 0;

  static constexpr unsigned int n_numbers = 7;

  static Strain
  read(const double *numbers)
  {
    Strain strain;
    for (unsigned int i = 0; i < 6; ++i)
      strain.tensor.access_raw_entry(i) = numbers[i];
    strain.dilatation = numbers[6];
    return strain;
  }

  void
  write(double *numbers) const
  {
    for (unsigned int i = 0; i < 6; ++i)
      numbers[i] = tensor.access_raw_entry(i);
    numbers[6] = dilatation;
  }
};

Strain
combine(const double a, const Strain &first, const double b, const Strain &last)
{
  return {a * first.tensor + b * last.tensor,
          a * first.dilatation + b * last.dilatation};
}

/** first : C : last of an isotropic stiffness. */
double
product(const double lambda,
        const double mu,
        const Strain &first,
        const Strain &last)
{
  return lambda * first.dilatation * last.dilatation +
         2 * mu * (first.tensor * last.tensor);
}

/** What a step of time does to a Maxwell element. */
struct Decay
{
  /** @param steps in relaxation times. */
  explicit Decay(const double steps)
    : kept(std::exp(-steps))
    , gained(steps > 0 ? -std::expm1(-steps) / steps : 1)
  {
    // By its series where the difference would take the digits.
    constexpr double small = 1e-3;
    work                   = steps < small
                               ? 1. / 2 - steps * (1. / 6 - steps * (1. / 24 - steps / 120))
                               : (1 - gained) / steps;
  }

  /** Of the spring's strain before, and of the change of the strain. */
  double kept;
  double gained;
  /** Of (change of strain) : C : (change of strain), what is work. */
  double work;
};

/** The energy of heat, and the last strain. */
constexpr unsigned int n_common = 1 + Strain::n_numbers;
} // namespace


double
Relaxation::lasting_part(const Terms &terms)
{
  double relaxing = 0;
  for (const auto &[part, time] : terms)
    relaxing += part;
  return 1 - relaxing;
}



Hooke
Relaxation::long_after(const Hooke &at_once) const
{
  const double G = at_once.mu * lasting_part(shear);
  const double K = (at_once.lambda + 2 * at_once.mu / 3) * lasting_part(bulk);
  return Hooke(9 * K * G / (3 * K + G), (3 * K - 2 * G) / (6 * K + 2 * G));
}



Viscoelasticity::Viscoelasticity(
  const std::shared_ptr<const SmallStrainLaw> &lasting,
  const Hooke &at_once,
  const Relaxation &relaxation)
  : lasting(lasting)
{
  // By relaxation times: what shear and bulk modulus lose.
  std::map<double, std::pair<double, double>> moduli;
  for (const auto &[part, time] : relaxation.shear)
    moduli[time].first += part * at_once.mu;
  for (const auto &[part, time] : relaxation.bulk)
    moduli[time].second += part * (at_once.lambda + 2 * at_once.mu / 3);
  for (const auto &[time, of_time] : moduli)
    elements.push_back(
      {of_time.second - 2 * of_time.first / 3, of_time.first, time});
}



std::string
Viscoelasticity::name() const
{
  return is_plastic() ? "viscoelasticity and " + lasting->name()
                      : "viscoelasticity";
}



unsigned int
Viscoelasticity::n_internal() const
{
  return n_common + elements.size() * Strain::n_numbers + lasting->n_internal();
}



void
Viscoelasticity::initialize(const ArrayView<double> &internal) const
{
  const unsigned int n_own = n_internal() - lasting->n_internal();
  std::fill(internal.begin(), internal.begin() + n_own, 0.);
  lasting->initialize({internal.data() + n_own, lasting->n_internal()});
}



SmallStrainResponse
Viscoelasticity::respond(const SymmetricTensor<2, 3> &strain,
                         const double dilatation,
                         const History &history) const
{
  const double *before     = history.before.data();
  double *const after      = history.after.data();
  const unsigned int n_own = n_internal() - lasting->n_internal();
  auto response            = lasting->respond(strain,
                                   dilatation,
                                   {{before + n_own, lasting->n_internal()},
                                               {after + n_own, lasting->n_internal()},
                                               history.time_step});
  const Strain now{strain, dilatation};
  const Strain change = combine(1, now, -1, Strain::read(before + 1));
  double heat         = before[0];
  for (unsigned int i = 0; i < elements.size(); ++i)
    {
      const auto &[lambda, mu, time] = elements[i];
      const unsigned int place       = n_common + i * Strain::n_numbers;
      const Decay decay(history.time_step / time);
      const Strain spring =
        combine(1, Strain::read(before + 1), -1, Strain::read(before + place));
      const Strain elastic = combine(decay.kept, spring, decay.gained, change);
      combine(1, now, -1, elastic).write(after + place);

      response.stress += 2 * mu * elastic.tensor + lambda * elastic.dilatation *
                                                     unit_symmetric_tensor<3>();
      response.tangent +=
        2 * mu * decay.gained * Physics::Elasticity::StandardTensors<3>::S;
      response.mean_stress += lambda * elastic.dilatation;
      response.lambda += lambda * decay.gained;
      const double stored = product(lambda, mu, elastic, elastic) / 2;
      response.energy.stored += stored;
      // In a step without end the spring has nothing left.
      if (decay.gained > 0)
        response.energy.potential += stored / decay.gained;
      heat += decay.gained * product(lambda, mu, spring, change) +
              decay.work * product(lambda, mu, change, change) +
              product(lambda, mu, spring, spring) / 2 - stored;
    }
  after[0] = heat;
  now.write(after + 1);
  response.energy.viscous += heat;
  response.energy.potential += before[0];
  return response;
}
} // namespace Setsudan
