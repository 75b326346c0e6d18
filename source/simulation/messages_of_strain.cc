// SPDX-License-Identifier: LGPL-2.1-or-later
#include <setsudan/simulation/messages.h>

#include <set>

namespace Setsudan
{
template <int dim>
std::optional<std::string>
describe_strain(const Scene<dim> &scene)
{
  if (!scene.material.finite_strain)
    return {};
  std::set<std::string> laws;
  for (const auto &material : scene.material.all())
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
describe_strain(const Scene<2> &);
template std::optional<std::string>
describe_strain(const Scene<3> &);
template std::string
describe_instability(const CutBody<2> &, const Event &, const std::string &);
template std::string
describe_instability(const CutBody<3> &, const Event &, const std::string &);
} // namespace Setsudan
