// SPDX-License-Identifier: LGPL-2.1-or-later
#include <setsudan/material/make_material.h>
#include <setsudan/material/material_parameters.h>
#include <setsudan/material/presets.h>

#include <algorithm>
#include <map>

namespace Setsudan
{
using namespace dealii;

namespace
{
/** What makes a material flow and relax. */
void
declare_memory(ParameterHandler &handler)
{
  Setsudan::declare(handler,
                    "Material",
                    "Yield stress",
                    "0",
                    Patterns::Anything(),
                    "The stress at which a bar begins to flow (von Mises), so "
                    "that it stays deformed; 0 for a material that is elastic. "
                    "Under finite strain that of Kirchhoff's stress "
                    "[force/area].");
  Setsudan::declare(handler,
                    "Material",
                    "Hardening",
                    "0, 0",
                    Patterns::Anything(),
                    "'isotropic, kinematic': by how much Yield stress rises "
                    "with the plastic strain of a bar, and by how much the "
                    "center of its elastic range moves [force/area].");
  Setsudan::declare(
    handler,
    "Material",
    "Viscous",
    "",
    Patterns::Anything(),
    "'relative modulus : relaxation time', several separated by ',', as in "
    "'0.5 : 0.1, 0.2 : 30', or 'group : ...' separated by ';': the parts of "
    "the shear modulus that relax, and the times in which they fall to 1/e. "
    "Young's modulus and Poisson's ratio are those of a sudden strain. Time "
    "comes from Blade/Speed, Blade/Travel and Time/Steps; empty for a material "
    "without time [-] : [time].");
  Setsudan::declare(handler,
                    "Material",
                    "Viscous bulk",
                    "",
                    Patterns::Anything(),
                    "The same of the bulk modulus [-] : [time].");
}
} // namespace


template <int dim>
void
MaterialParameters<dim>::declare(ParameterHandler &handler)
{
  Presets::declare(handler);
  LawParameters::declare(handler);
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
  DirectionalValues<dim>::declare(handler);
  declare_memory(handler);
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
                    "linear theory is trusted; beyond it the program warns, or "
                    "takes finite strain where Deformation/Strain is auto. "
                    "Greater than 0 [-].");
}



template <int dim>
MaterialParameters<dim>::MaterialParameters(const Parameters &parameters,
                                            const Body<dim> &body)
  : linear_range(parameters.number("Material", "Linear range"))
{
  using Strain = LawParameters::Strain;
  const GivenValues<dim> given(parameters, body);
  parameters.require(
    linear_range > 0, "Material", "Linear range", "a number greater than 0");
  formulation_is_named = parameters.text("Material", "Formulation") != "auto";
  const LawParameters laws(parameters);
  strain        = laws.strain;
  finite_strain = strain == Strain::finite;
  parameters.require(strain != Strain::automatic || linear_range < 1,
                     "Material",
                     "Linear range",
                     "a number less than 1 where Deformation/Strain is auto, "
                     "since a body may be inside out beyond that");
  LawParameters at_first = laws;
  if (strain == Strain::automatic)
    at_first.strain = Strain::small;
  std::map<typename GivenValues<dim>::OfElement, unsigned int> numbers;
  bool hardens = false;
  for (unsigned int element = 0; element < given.size(); ++element)
    {
      const auto values   = given.of_element(element);
      const auto inserted = numbers.emplace(values, numbers.size());
      if (inserted.second)
        {
          const auto &hardening = std::get<5>(values);
          hardens = hardens || hardening[0] > 0 || hardening[1] > 0;
          materials.push_back(make_material<dim>(parameters, at_first, values));
          if (strain == Strain::automatic)
            laws_to_come.push_back(
              make_material<dim>(parameters, laws, values).law);
        }
      material_of_element.push_back(inserted.first->second);
    }
  if (materials.size() == 1)
    material_of_element.clear();
  parameters.require(!has_internal_variables() || strain != Strain::automatic,
                     "Deformation",
                     "Strain",
                     "small or finite where Material/Yield stress or "
                     "Material/Viscous is given");
  parameters.require(is_plastic() || !hardens,
                     "Material",
                     "Hardening",
                     "0, 0 where no Material/Yield stress is given");
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
smallest(const std::vector<Material> &materials,
         const CutLimit Material::*limit,
         const unsigned int dim)
{
  double result = (materials.front().*limit).smallest(dim);
  for (const auto &material : materials)
    result = std::min(result, (material.*limit).smallest(dim));
  return result;
}
} // namespace


template <int dim>
void
MaterialParameters<dim>::add_work_of_edge(const double width)
{
  for (auto &material : materials)
    material.toughness.add(width * 2, material.shear_limit);
}



template <int dim>
double
MaterialParameters<dim>::smallest_shear_limit() const
{
  return smallest(materials, &Material::shear_limit, dim);
}



template <int dim>
double
MaterialParameters<dim>::smallest_toughness() const
{
  return smallest(materials, &Material::toughness, dim);
}



template <int dim>
double
MaterialParameters<dim>::smallest_youngs_modulus() const
{
  double result = std::numeric_limits<double>::max();
  for (const auto &material : materials)
    result = std::min(result, material.at_rest.youngs_modulus());
  return result;
}



namespace
{
bool
any_of(const std::vector<Material> &materials,
       bool (*const holds)(const Material &))
{
  return std::any_of(materials.begin(), materials.end(), holds);
}
} // namespace


template <int dim>
bool
MaterialParameters<dim>::any_is_mixed() const
{
  return any_of(materials,
                [](const Material &material) { return material.is_mixed; });
}



template <int dim>
bool
MaterialParameters<dim>::is_linear() const
{
  return std::all_of(
    materials.begin(), materials.end(), [](const Material &material) {
      return material.law->is_linear();
    });
}



template <int dim>
bool
MaterialParameters<dim>::is_hookean() const
{
  return std::all_of(
    materials.begin(), materials.end(), [](const Material &material) {
      return material.law->is_linear() &&
             material.law->anisotropic_stiffness() == nullptr;
    });
}



template <int dim>
bool
MaterialParameters<dim>::is_plastic() const
{
  return any_of(materials, [](const Material &material) {
    return material.law->is_plastic();
  });
}



template <int dim>
bool
MaterialParameters<dim>::is_viscous() const
{
  return any_of(materials, [](const Material &material) {
    return material.law->is_viscous();
  });
}



template <int dim>
bool
MaterialParameters<dim>::has_internal_variables() const
{
  return any_of(materials, [](const Material &material) {
    return material.law->n_internal() > 0;
  });
}



template <int dim>
void
MaterialParameters<dim>::take_finite_strain()
{
  Assert(laws_to_come.size() == materials.size(),
         ExcMessage("Strain is not small until it is finite."));
  for (unsigned int m = 0; m < materials.size(); ++m)
    materials[m].law = laws_to_come[m];
  laws_to_come.clear();
  finite_strain = true;
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
