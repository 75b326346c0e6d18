// SPDX-License-Identifier: LGPL-2.1-or-later
#include <setsudan/material/given_values.h>
#include <setsudan/material/law_parameters.h>

#include <algorithm>

namespace Setsudan
{
using namespace dealii;

template <int dim>
GivenValues<dim>::GivenValues(const Parameters &parameters,
                              const Body<dim> &body)
  : directional(parameters, body)
{
  const auto read = [&](const std::string &name,
                        const std::string &allowed,
                        bool (*is_allowed)(double)) {
    return read_numbers(parameters, body, name, allowed, is_allowed);
  };
  const auto is_positive     = [](const double value) { return value > 0; };
  const auto is_not_negative = [](const double value) { return value >= 0; };
  const std::string positive = "a number greater than 0";
  moduli                     = read("Young's modulus", positive, is_positive);
  ratios                     = read("Poisson's ratio",
                "a number greater than -1 and less than 0.5",
                [](const double value) { return value > -1 && value < 0.5; });
  limits                     = read("Shear limit", positive, is_positive);
  toughnesses                = read("Toughness", positive, is_positive);
  yield_stresses =
    read("Yield stress", "a number that is not negative", is_not_negative);
  hardenings            = read_lists(parameters,
                          body,
                          "Hardening",
                          {"isotropic, kinematic",
                                      2,
                                      "numbers that are not negative",
                                      is_not_negative});
  const auto read_terms = [&](const std::string &name) {
    return read_pairs(parameters,
                      body,
                      name,
                      "relative modulus : relaxation time",
                      "'relative modulus : relaxation time', separated by ',', "
                      "all greater than 0 and moduli that sum to less than 1",
                      [](const std::pair<double, double> &term) {
                        return term.first > 0 && term.second > 0;
                      });
  };
  shear_terms = read_terms("Viscous");
  bulk_terms  = read_terms("Viscous bulk");
  for (const auto &[all, name] : {std::make_pair(&shear_terms, "Viscous"),
                                  std::make_pair(&bulk_terms, "Viscous bulk")})
    for (const auto &terms : *all)
      parameters.require(Relaxation::lasting_part(terms) > 0,
                         "Material",
                         name,
                         "relative moduli that sum to less than 1, since a "
                         "part of the body must last");
  names = read_names(parameters, body, "Law", "law", LawParameters::names());
}



template <int dim>
unsigned int
GivenValues<dim>::size() const
{
  return std::max<std::size_t>({moduli.size(),
                                ratios.size(),
                                limits.size(),
                                toughnesses.size(),
                                yield_stresses.size(),
                                hardenings.size(),
                                shear_terms.size(),
                                bulk_terms.size(),
                                names.size(),
                                directional.size()});
}



template <int dim>
typename GivenValues<dim>::OfElement
GivenValues<dim>::of_element(const unsigned int element) const
{
  const auto of = [&](const auto &values) {
    return values[values.size() == 1 ? 0 : element];
  };
  return {of(moduli),
          of(ratios),
          of(limits),
          of(toughnesses),
          of(yield_stresses),
          of(hardenings),
          of(shear_terms),
          of(bulk_terms),
          of(names),
          directional.of_element(element)};
}



template class GivenValues<2>;
template class GivenValues<3>;
} // namespace Setsudan
