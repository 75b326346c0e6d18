// SPDX-License-Identifier: LGPL-2.1-or-later
#include <setsudan/parameters/lists.h>
#include <setsudan/simulation/messages.h>

#include <set>
#include <sstream>

namespace Setsudan
{
template <int dim>
std::optional<std::string>
describe_strain(const MaterialParameters<dim> &materials)
{
  if (materials.strain == LawParameters::Strain::automatic)
    return "Strain: small, and finite from the state on whose largest "
           "principal "
           "strain exceeds Material/Linear range = " +
           short_text(materials.linear_range) + ".";
  if (!materials.finite_strain && !materials.has_internal_variables())
    return {};
  if (!materials.finite_strain)
    return std::string("Strain: small, with ") +
           (materials.is_plastic() ? "plastic flow" : "") +
           (materials.is_plastic() && materials.is_viscous() ? " and " : "") +
           (materials.is_viscous() ? "viscosity" : "") +
           ", by Newton's method.";
  std::set<std::string> laws;
  for (const auto &material : materials.all())
    laws.insert(
      material.law->name() +
      (material.is_mixed
         ? " in the mixed formulation, in which distortion and volume "
           "have energies of their own"
         : " in the displacement formulation"));
  std::string line = "Strain: finite, by Newton's method; ";
  for (const auto &law : laws)
    line += (law == *laws.begin() ? "" : ", ") + law;
  return line + ".";
}



template <int dim>
std::vector<std::string>
warn_of_memory(const Scene<dim> &scene)
{
  std::vector<std::string> sentences;
  if (scene.material.is_plastic() && scene.yield.compares_energies())
    sentences.push_back(
      "plastic flow at the front takes what a split sets free, the more of it "
      "the smaller the elements are: with Material/Yield stress compare "
      "forces under Yield/Criterion = energy release on the same elements "
      "only.");
  if (scene.material.is_viscous() && !scene.has_time())
    sentences.push_back(
      "no time passes, since neither Blade/Speed nor times in "
      "Blade/Travel nor Time/Steps are given: Material/Viscous "
      "has no effect.");
  else if (scene.material.is_viscous() && !scene.cut.cuts.empty() &&
           !scene.blade.path.has_times())
    sentences.push_back("no time passes while the body is cut, since neither "
                        "Blade/Speed nor times in Blade/Travel are given.");
  if (scene.time.passes() && !scene.material.is_viscous() &&
      scene.time.load_factors.empty())
    sentences.push_back("Time/Steps has no effect without Material/Viscous or "
                        "Time/Load factor.");
  return sentences;
}



template <int dim>
std::string
describe_change_of_strain(const MaterialParameters<dim> &materials,
                          const Event &event)
{
  std::ostringstream line;
  line.precision(3);
  line << "  in frame " << event.frame << " a principal strain of "
       << event.max_strain
       << " exceeds Material/Linear range = " << materials.linear_range
       << ": this state is solved again with finite strain, and all behind it "
          "are, by Newton's method.";
  return line.str();
}



template <int dim>
std::string
describe_instability(const CutBody<dim> &body,
                     const Event &event,
                     const std::string &reason)
{
  return "Arrest" +
         (body.has_cut() ? " in row " + std::to_string(event.released_rows + 1)
                         : std::string()) +
         ": " + reason;
}



template std::optional<std::string>
describe_strain(const MaterialParameters<2> &);
template std::optional<std::string>
describe_strain(const MaterialParameters<3> &);
template std::vector<std::string>
warn_of_memory(const Scene<2> &);
template std::vector<std::string>
warn_of_memory(const Scene<3> &);
template std::string
describe_change_of_strain(const MaterialParameters<2> &, const Event &);
template std::string
describe_change_of_strain(const MaterialParameters<3> &, const Event &);
template std::string
describe_instability(const CutBody<2> &, const Event &, const std::string &);
template std::string
describe_instability(const CutBody<3> &, const Event &, const std::string &);
} // namespace Setsudan
