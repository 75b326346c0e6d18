// SPDX-License-Identifier: LGPL-2.1-or-later
#include <setsudan/material/finite_viscoelasticity.h>
#include <setsudan/material/j2_plasticity.h>
#include <setsudan/material/logarithmic_strain.h>
#include <setsudan/material/make_material.h>
#include <setsudan/material/small_strain_law.h>

#include <algorithm>

namespace Setsudan
{
namespace
{
using Strain = LawParameters::Strain;

// From here on the displacement formulation's stress is wrong by several per
// cent on coarse meshes (doc/theory.md).
constexpr double mixed_from_ratio = 0.45;

/** An elastic law.
 *
 * @throw SceneError for one that does not fit to the other parameters. */
std::shared_ptr<const ConstitutiveLaw>
make_elastic(const Parameters &parameters,
             const LawParameters &laws,
             const std::string &name,
             const Hooke &at_rest,
             const bool is_mixed)
{
  const auto law = laws.make(name, at_rest, is_mixed);
  parameters.require(law != nullptr,
                     "Material",
                     "Law",
                     "isochoric neo-Hooke, Mooney-Rivlin, Ogden or auto in the "
                     "mixed formulation, which auto takes where Poisson's "
                     "ratio is at least 0.45; or set Material/Formulation = "
                     "displacement");
  return law;
}



/** The same of an orthotropic material. */
std::shared_ptr<const ConstitutiveLaw>
make_orthotropic(const Parameters &parameters,
                 const LawParameters &laws,
                 const std::string &name,
                 const OrthotropicConstants &constants)
{
  if (laws.strain == Strain::small)
    return std::make_shared<const OrthotropicElasticity>(constants);
  parameters.require(name == "auto" || name == "linear elastic",
                     "Material",
                     "Law",
                     "auto or linear elastic where Material/Young's moduli are "
                     "given");
  return std::make_shared<const OrthotropicStVenantKirchhoff>(constants);
}



/** A law with internal variables.
 *
 * @param elastic the law of sudden strains, by its name.
 * @throw SceneError for laws that do not go together. */
std::shared_ptr<const ConstitutiveLaw>
make_with_memory(const Parameters &parameters,
                 const LawParameters &laws,
                 const std::string &name,
                 const Hooke &at_once,
                 const double yield_stress,
                 const Hardening &hardening,
                 const Relaxation &relaxation)
{
  if (laws.strain != Strain::small && name != "auto")
    {
      const auto law = laws.make(name, at_once, true);
      parameters.require(
        yield_stress == 0 && relaxation.bulk.empty() && law != nullptr,
        "Material",
        "Law",
        "auto, which is the law of small strain for logarithmic strain, where "
        "Material/Yield stress or Material/Viscous bulk is given; with "
        "Material/Viscous also isochoric neo-Hooke, Mooney-Rivlin or Ogden");
      return std::make_shared<const FiniteViscoelasticity>(
        std::static_pointer_cast<const DecoupledLaw>(law),
        at_once,
        relaxation.shear);
    }
  const Hooke lasting = relaxation.long_after(at_once);
  std::shared_ptr<const SmallStrainLaw> law;
  if (yield_stress > 0)
    law =
      std::make_shared<const J2Plasticity>(lasting, yield_stress, hardening);
  else
    law = std::make_shared<const LinearElasticity>(lasting);
  if (!relaxation.empty())
    law = std::make_shared<const Viscoelasticity>(law, at_once, relaxation);
  if (laws.strain == Strain::small)
    return law;
  return std::make_shared<const LogarithmicStrain>(law);
}



/** Refuse what orthotropic materials do not have. */
void
check_orthotropic(const Parameters &parameters,
                  const double yield_stress,
                  const Relaxation &relaxation)
{
  const std::string where = " where Material/Young's moduli are given";
  parameters.require(parameters.text("Material", "Formulation") != "mixed",
                     "Material",
                     "Formulation",
                     "auto or displacement" + where);
  parameters.require(
    yield_stress == 0, "Material", "Yield stress", "0" + where);
  parameters.require(relaxation.empty(),
                     "Material",
                     relaxation.shear.empty() ? "Viscous bulk" : "Viscous",
                     "nothing" + where);
}
} // namespace


template <int dim>
Material
make_material(const Parameters &parameters,
              const LawParameters &laws,
              const typename GivenValues<dim>::OfElement &values)
{
  const auto &[modulus,
               ratio,
               limit,
               toughness,
               yield,
               hardening,
               shear_terms,
               bulk_terms,
               name,
               by]              = values;
  const auto directions         = MaterialDirections::make<dim>(parameters, by);
  const auto &elastic           = directions.elastic;
  const std::string formulation = parameters.text("Material", "Formulation");
  const Relaxation relaxation{shear_terms, bulk_terms};
  const Hooke at_rest =
    elastic ? elastic->isotropic_mean() : Hooke(modulus, ratio);
  // Where shear relaxes, the body is nearer to incompressible then.
  const double largest_ratio =
    std::max(ratio, relaxation.long_after(at_rest).poissons_ratio());
  const bool is_mixed =
    formulation == "mixed" ||
    (formulation == "auto" && !elastic && largest_ratio >= mixed_from_ratio);
  parameters.require(name != "Ogden" || !laws.ogden_terms.empty(),
                     "Material",
                     "Law",
                     "another law, or Ogden with Material/Ogden terms");
  std::shared_ptr<const ConstitutiveLaw> law;
  if (elastic)
    {
      check_orthotropic(parameters, yield, relaxation);
      law = make_orthotropic(parameters, laws, name, *elastic);
    }
  else if (yield > 0 || !relaxation.empty())
    law = make_with_memory(parameters,
                           laws,
                           name,
                           at_rest,
                           yield,
                           {hardening[0], hardening[1]},
                           relaxation);
  else
    law = make_elastic(parameters, laws, name, at_rest, is_mixed);
  return {at_rest,
          law,
          directions.shear_limit.value_or(CutLimit(limit)),
          directions.toughness.value_or(CutLimit(toughness)),
          is_mixed};
}



template Material
make_material<2>(const Parameters &,
                 const LawParameters &,
                 const GivenValues<2>::OfElement &);
template Material
make_material<3>(const Parameters &,
                 const LawParameters &,
                 const GivenValues<3>::OfElement &);
} // namespace Setsudan
