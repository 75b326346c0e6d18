// SPDX-License-Identifier: LGPL-2.1-or-later
#include <deal.II/base/utilities.h>

#include <setsudan/body/group_of_word.h>
#include <setsudan/material/material_parameters.h>
#include <setsudan/parameters/lists.h>

#include <algorithm>
#include <array>
#include <map>

namespace Setsudan
{
using namespace dealii;

template <int dim>
void
MaterialParameters<dim>::declare(ParameterHandler &handler)
{
  Setsudan::declare(handler,
                    "Material",
                    "Young's modulus",
                    "5.0",
                    Patterns::Anything(),
                    "E, greater than 0. As the other values of a material: one "
                    "number for the whole body, or 'group : number' for groups "
                    "of its elements, separated by ';', as in '5; cream : 0.5' "
                    "[force/area].");
  Setsudan::declare(handler,
                    "Material",
                    "Poisson's ratio",
                    "0.2",
                    Patterns::Anything(),
                    "Between -1 and 1/2, both excluded [-].");
  Setsudan::declare(handler,
                    "Material",
                    "Shear limit",
                    "1.0",
                    Patterns::Anything(),
                    "The shear stress at which a blade of sharpness 0 divides "
                    "the body, greater than 0 [force/area].");
  Setsudan::declare(handler,
                    "Material",
                    "Toughness",
                    "1.0",
                    Patterns::Anything(),
                    "The energy for each new area that a blade of sharpness 0 "
                    "needs, with the criterion energy release; greater than 0 "
                    "[force/length].");
  Setsudan::declare(handler,
                    "Material",
                    "Formulation",
                    "auto",
                    Patterns::Selection("auto|displacement|mixed"),
                    "displacement: the strain as it is; mixed: the change of "
                    "volume is linear in each element, so that elements do not "
                    "lock where Poisson's ratio is near 1/2; auto: mixed for "
                    "materials whose Poisson's ratio is at least 0.45.");
  Setsudan::declare(handler,
                    "Material",
                    "Linear range",
                    "0.5",
                    Patterns::Double(),
                    "Largest principal strain, in magnitude, up to which the "
                    "linear theory is trusted; beyond it the program warns. "
                    "Greater than 0 [-].");
}



namespace
{
/** A value for each element, or one for all of them. */
using ElementValues = std::vector<double>;

/**
 * Read a parameter that is a number, or numbers for groups of elements.
 *
 * @param is_allowed what a number must fulfil, and `allowed` says.
 */
template <int dim>
ElementValues
read_values(const Parameters &parameters,
            const Body<dim> &body,
            const std::string &name,
            const std::string &allowed,
            bool (*is_allowed)(double))
{
  const auto reject_unless = [&](const bool condition,
                                 const std::string &what) {
    parameters.require(condition, "Material", name, what);
  };
  ElementValues values;
  std::vector<bool> given(body.mesh.cells.size(), false);
  bool all_given = false;
  for (const auto &item : split(parameters.text("Material", name), ';'))
    {
      // The number stands behind the last colon, where there is one.
      const auto colon     = item.rfind(':');
      const bool has_group = colon != std::string::npos;
      const std::string word =
        has_group ? Utilities::trim(item.substr(0, colon)) : "";
      const std::string text = has_group ? item.substr(colon + 1) : item;
      std::vector<double> number;
      reject_unless(parse_numbers(text, number) && number.size() == 1 &&
                      is_allowed(number[0]),
                    allowed + ", or 'group : number', separated by ';'");
      if (word.empty())
        {
          reject_unless(!all_given && values.empty(),
                        "one number without a group, before those of groups");
          values    = number;
          all_given = true;
          continue;
        }
      if (values.size() != body.mesh.cells.size())
        values.assign(body.mesh.cells.size(), all_given ? values[0] : 0.);
      for (const unsigned int cell :
           find_group_or_reject(
             parameters, "Material", name, body, word, GroupKind::elements)
             .cells)
        {
          values[cell] = number[0];
          given[cell]  = true;
        }
    }
  reject_unless(!values.empty(), allowed);
  reject_unless(all_given ||
                  std::all_of(given.begin(),
                              given.end(),
                              [](const bool value) { return value; }),
                "a number for every element: the groups leave some out, for "
                "which a number without a group would be taken");
  return values;
}



// From here on the displacement formulation's stress is wrong by several per
// cent on coarse meshes (doc/theory.md).
constexpr double mixed_from_ratio = 0.45;

double
value_of(const ElementValues &values, const unsigned int element)
{
  return values[values.size() == 1 ? 0 : element];
}
} // namespace


template <int dim>
MaterialParameters<dim>::MaterialParameters(const Parameters &parameters,
                                            const Body<dim> &body)
  : linear_range(parameters.number("Material", "Linear range"))
{
  const auto is_positive     = [](const double value) { return value > 0; };
  const std::string positive = "a number greater than 0";
  const auto moduli =
    read_values(parameters, body, "Young's modulus", positive, is_positive);
  const auto ratios =
    read_values(parameters,
                body,
                "Poisson's ratio",
                "a number greater than -1 and less than 0.5",
                [](const double value) { return value > -1 && value < 0.5; });
  const auto limits =
    read_values(parameters, body, "Shear limit", positive, is_positive);
  const auto toughnesses =
    read_values(parameters, body, "Toughness", positive, is_positive);
  parameters.require(linear_range > 0, "Material", "Linear range", positive);

  const std::string formulation = parameters.text("Material", "Formulation");
  formulation_is_named          = formulation != "auto";
  const auto is_mixed           = [&](const double ratio) {
    return formulation == "mixed" ||
           (formulation == "auto" && ratio >= mixed_from_ratio);
  };
  std::map<std::array<double, 4>, unsigned int> numbers;
  // One of them, where all are the same everywhere.
  const std::size_t n_values =
    std::max({moduli.size(), ratios.size(), limits.size(), toughnesses.size()});
  for (unsigned int element = 0; element < n_values; ++element)
    {
      const std::array<double, 4> values{{value_of(moduli, element),
                                          value_of(ratios, element),
                                          value_of(limits, element),
                                          value_of(toughnesses, element)}};
      const auto inserted = numbers.emplace(values, numbers.size());
      if (inserted.second)
        materials.push_back({std::make_shared<const LinearElasticity>(
                               Hooke(values[0], values[1])),
                             values[2],
                             values[3],
                             is_mixed(values[1])});
      material_of_element.push_back(inserted.first->second);
    }
  if (materials.size() == 1)
    material_of_element.clear();
}



template <int dim>
unsigned int
MaterialParameters<dim>::number(const unsigned int element) const
{
  return material_of_element.empty() ? 0 : material_of_element[element];
}



template <int dim>
const Material &
MaterialParameters<dim>::of_element(const unsigned int element) const
{
  return materials[number(element)];
}



template <int dim>
unsigned int
MaterialParameters<dim>::n_materials() const
{
  return materials.size();
}



namespace
{
double
smallest(const std::vector<Material> &materials, double Material::*value)
{
  double result = materials.front().*value;
  for (const auto &material : materials)
    result = std::min(result, material.*value);
  return result;
}
} // namespace


template <int dim>
void
MaterialParameters<dim>::add_work_of_edge(const double width)
{
  for (auto &material : materials)
    material.toughness += width * 2 * material.shear_limit;
}



template <int dim>
double
MaterialParameters<dim>::smallest_shear_limit() const
{
  return smallest(materials, &Material::shear_limit);
}



template <int dim>
double
MaterialParameters<dim>::smallest_toughness() const
{
  return smallest(materials, &Material::toughness);
}



template <int dim>
double
MaterialParameters<dim>::smallest_youngs_modulus() const
{
  double result = std::numeric_limits<double>::max();
  for (const auto &material : materials)
    result = std::min(result, material.linear().youngs_modulus());
  return result;
}



template <int dim>
bool
MaterialParameters<dim>::any_is_mixed() const
{
  return std::any_of(
    materials.begin(), materials.end(), [](const Material &material) {
      return material.is_mixed;
    });
}



const Hooke &
Material::linear() const
{
  AssertThrow(law->linear() != nullptr,
              ExcMessage("This is for linear laws only."));
  return *law->linear();
}



template <int dim>
bool
MaterialParameters<dim>::is_linear() const
{
  return std::all_of(
    materials.begin(), materials.end(), [](const Material &material) {
      return material.law->linear() != nullptr;
    });
}



template <int dim>
bool
MaterialParameters<dim>::has_internal_variables() const
{
  return std::any_of(
    materials.begin(), materials.end(), [](const Material &material) {
      return material.law->n_internal() > 0;
    });
}



template <int dim>
void
MaterialParameters<dim>::set_law(
  const unsigned int number,
  const std::shared_ptr<const ConstitutiveLaw> &law)
{
  materials[number].law = law;
}



template class MaterialParameters<2>;
template class MaterialParameters<3>;
} // namespace Setsudan
