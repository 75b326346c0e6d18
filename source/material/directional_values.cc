// SPDX-License-Identifier: LGPL-2.1-or-later
#include <setsudan/material/directional_values.h>

#include <algorithm>
#include <cmath>
#include <utility>

namespace Setsudan
{
using namespace dealii;

namespace
{
/** The places of the values of an element. */
struct Place
{
  enum
  {
    youngs_moduli,
    poissons_ratios,
    shear_moduli,
    shear_limits,
    toughnesses,
    axes
  };
};

/** What Young's moduli do not go without. */
const std::pair<unsigned int, const char *> elastic_places[] = {
  {Place::poissons_ratios, "Poisson's ratios"},
  {Place::shear_moduli, "Shear moduli"}};
} // namespace


template <int dim>
void
DirectionalValues<dim>::declare(ParameterHandler &handler)
{
  const auto declare_list = [&](const std::string &name,
                                const std::string &default_value,
                                const std::string &documentation) {
    Setsudan::declare(handler,
                      "Material",
                      name,
                      default_value,
                      Patterns::Anything(),
                      documentation);
  };
  declare_list(
    "Young's moduli",
    "",
    "'E1, E2, E3' along the axes of an orthotropic material, greater "
    "than 0, or 'group : E1, E2, E3' for layers. Where they are given "
    "Young's modulus and Poisson's ratio do not count; empty (also "
    "behind 'group :') for a material that is isotropic "
    "[force/area].");
  declare_list(
    "Poisson's ratios",
    "",
    "'nu12, nu23, nu31' with Young's moduli: under a stress along "
    "axis i, nu_ij is the strain along axis j over that along i, with "
    "the opposite sign. nu_ij / E_i is nu_ji / E_j, and every strain "
    "must store energy [-].");
  declare_list("Shear moduli",
               "",
               "'G12, G23, G31' with Young's moduli, greater than 0 "
               "[force/area].");
  declare_list("Axes",
               "1, 0, 0, 0, 1, 0",
               "'x1, y1, z1, x2, y2, z2': the first and the second axis of the "
               "material, at right angles, of any length; the third is their "
               "cross product. In 2D one of the three must be z [-].");
  declare_list("Shear limit by axis",
               "",
               "'s1, s2, s3' instead of Shear limit: what a cut needs whose "
               "normal is axis 1, 2 or 3 of the material, greater than 0; for "
               "another normal n the sum of s_i (n . e_i)^2 [force/area].");
  declare_list(
    "Toughness by axis",
    "",
    "'R1, R2, R3' instead of Toughness, in the same way: of a material "
    "with fibres along axis 1, R1 is needed across the fibres, R2 and "
    "R3 between them [force/length].");
}



template <int dim>
DirectionalValues<dim>::DirectionalValues(const Parameters &parameters,
                                          const Body<dim> &body)
{
  const auto is_positive = [](const double value) { return value > 0; };
  const auto is_any      = [](const double) { return true; };
  const auto read = [&](const std::string &name, const NumberList &list) {
    return read_lists(parameters, body, name, list);
  };
  const std::string positive = "numbers greater than 0";
  values[Place::youngs_moduli] =
    read("Young's moduli", {"E1, E2, E3", 3, positive, is_positive, true});
  values[Place::poissons_ratios] =
    read("Poisson's ratios", {"nu12, nu23, nu31", 3, "numbers", is_any, true});
  values[Place::shear_moduli] =
    read("Shear moduli", {"G12, G23, G31", 3, positive, is_positive, true});
  values[Place::shear_limits] =
    read("Shear limit by axis", {"s1, s2, s3", 3, positive, is_positive, true});
  values[Place::toughnesses] =
    read("Toughness by axis", {"R1, R2, R3", 3, positive, is_positive, true});
  values[Place::axes] =
    read("Axes", {"x1, y1, z1, x2, y2, z2", 6, "numbers", is_any, false});
  const auto is_given = [](const ElementValues<std::vector<double>> &lists) {
    return std::any_of(lists.begin(), lists.end(), [](const auto &list) {
      return !list.empty();
    });
  };
  for (const auto &[place, name] : elastic_places)
    parameters.require(is_given(values[Place::youngs_moduli]) ||
                         !is_given(values[place]),
                       "Material",
                       name,
                       "nothing where no Material/Young's moduli are given");
}



template <int dim>
unsigned int
DirectionalValues<dim>::size() const
{
  unsigned int result = 1;
  for (const auto &of_elements : values)
    result = std::max<unsigned int>(result, of_elements.size());
  return result;
}



template <int dim>
typename DirectionalValues<dim>::OfElement
DirectionalValues<dim>::of_element(const unsigned int element) const
{
  OfElement result;
  for (unsigned int i = 0; i < result.size(); ++i)
    result[i] = values[i][values[i].size() == 1 ? 0 : element];
  return result;
}



namespace
{
std::array<double, 3>
triple(const std::vector<double> &numbers)
{
  return {{numbers[0], numbers[1], numbers[2]}};
}



template <int dim>
MaterialAxes
make_axes(const Parameters &parameters, const std::vector<double> &numbers)
{
  const auto found = find_axes({{numbers[0], numbers[1], numbers[2]}},
                               {{numbers[3], numbers[4], numbers[5]}});
  parameters.require(found.has_value(),
                     "Material",
                     "Axes",
                     "two axes that are not zero and at right angles, as in "
                     "'1, 0, 0, 0, 1, 0'");
  const auto is_across = [](const Tensor<1, 3> &axis) {
    return std::abs(axis[2]) > 1 - 1e-12;
  };
  parameters.require(dim == 3 ||
                       std::any_of(found->begin(), found->end(), is_across),
                     "Material",
                     "Axes",
                     "axes of which one is z, or lies across two that are in "
                     "the plane, in 2D");
  return *found;
}
} // namespace


template <int dim>
MaterialDirections
MaterialDirections::make(const Parameters &parameters,
                         const typename DirectionalValues<dim>::OfElement &of)
{
  const MaterialAxes directions = make_axes<dim>(parameters, of[Place::axes]);
  const auto limit              = [&](const std::vector<double> &numbers) {
    return numbers.empty() ? std::optional<CutLimit>()
                                        : CutLimit(triple(numbers), directions);
  };
  MaterialDirections result;
  result.shear_limit        = limit(of[Place::shear_limits]);
  result.toughness          = limit(of[Place::toughnesses]);
  const bool is_orthotropic = !of[Place::youngs_moduli].empty();
  for (const auto &[place, name] : elastic_places)
    parameters.require(!is_orthotropic || !of[place].empty(),
                       "Material",
                       name,
                       "three numbers where Material/Young's moduli are given");
  if (!is_orthotropic)
    return result;
  result.elastic = OrthotropicConstants{triple(of[Place::youngs_moduli]),
                                        triple(of[Place::poissons_ratios]),
                                        triple(of[Place::shear_moduli]),
                                        directions};
  parameters.require(
    result.elastic->are_definite(),
    "Material",
    "Poisson's ratios",
    "numbers with which every strain stores energy: with these "
    "Young's moduli they are too large");
  return result;
}



template class DirectionalValues<2>;
template class DirectionalValues<3>;
template MaterialDirections
MaterialDirections::make<2>(const Parameters &,
                            const DirectionalValues<2>::OfElement &);
template MaterialDirections
MaterialDirections::make<3>(const Parameters &,
                            const DirectionalValues<3>::OfElement &);
} // namespace Setsudan
